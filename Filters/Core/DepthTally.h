// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DepthTally_h
#define hashedoctree_DepthTally_h

#include "DepthStatistics.h"
#include "Octree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/** Counts of leaves by depth that several threads make in parts and add up. */
template <int Dim>
class DepthTally
{
public:
  /** Counts those children of an internal node that are leaves. */
  void AddChildren(
    int depthOfChildren, typename Octree<Dim>::Octants octants, std::uint64_t pointsInLeaves)
  {
    const auto depth = static_cast<std::size_t>(depthOfChildren);
    this->Leaves[depth] += Octree<Dim>::NumberOfOctants - CountOctants(octants.Internal);
    this->EmptyLeaves[depth] += Octree<Dim>::NumberOfOctants - CountOctants(octants.Occupied);
    this->Points[depth] += pointsInLeaves;
  }

  /** Counts a leaf. */
  void AddLeaf(int depthOfLeaf, std::uint64_t points)
  {
    const auto depth = static_cast<std::size_t>(depthOfLeaf);
    ++this->Leaves[depth];
    this->EmptyLeaves[depth] += points == 0 ? 1 : 0;
    this->Points[depth] += points;
  }

  void Add(const DepthTally& part)
  {
    for (std::size_t depth = 0; depth < NumberOfDepths; ++depth)
    {
      this->Leaves[depth] += part.Leaves[depth];
      this->EmptyLeaves[depth] += part.EmptyLeaves[depth];
      this->Points[depth] += part.Points[depth];
    }
  }

  /** Down to the deepest leaf. */
  DepthCounts GetCounts() const
  {
    std::size_t depths = NumberOfDepths;
    while (depths > 0 && this->Leaves[depths - 1] == 0)
    {
      --depths;
    }
    const auto getHistogram = [depths](const PerDepth& counts) {
      return DepthHistogram(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(depths));
    };
    return { getHistogram(this->Leaves), getHistogram(this->EmptyLeaves),
      getHistogram(this->Points) };
  }

private:
  static constexpr std::size_t NumberOfDepths = MortonKey<Dim>::MaxDepth + 1;
  using PerDepth = std::array<std::uint64_t, NumberOfDepths>;

  PerDepth Leaves{};
  PerDepth EmptyLeaves{};
  PerDepth Points{};
};
}

#endif
