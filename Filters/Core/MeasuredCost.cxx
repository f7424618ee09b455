// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCost.h"

#include <array>

namespace hashedoctree
{
namespace
{
/** Nodes examined for all leaves, and for all points, per start depth. */
template <int Dim>
struct Sums
{
  std::array<std::uint64_t, MortonKey<Dim>::MaxDepth + 1> Leaves{};
  std::array<std::uint64_t, MortonKey<Dim>::MaxDepth + 1> Points{};
};

/** The keys that searches for the leaves of a block look up, and do not find, when they start below
 * them: scattered over the table, so they are asked for well ahead. */
template <int Dim>
void PrefetchBelow(const Octree<Dim>& tree, std::size_t block)
{
  for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
  {
    const typename Octree<Dim>::Node child = tree.GetChild(block, octant);
    const MortonKey<Dim> key = child.NodeKey.GetFirstAtMaxDepth();
    for (int depth = child.NodeKey.GetDepth(); depth < tree.GetDeepestDepth(); ++depth)
    {
      tree.GetTable().Prefetch(key.AtDepth(depth).GetValue());
    }
  }
}

template <int Dim>
void AddLeaf(const Octree<Dim>& tree, const typename Octree<Dim>::Node& leaf, Sums<Dim>& sums)
{
  const MortonKey<Dim> key = leaf.NodeKey.GetFirstAtMaxDepth();
  for (int startDepth = 0; startDepth <= tree.GetDeepestDepth(); ++startDepth)
  {
    const std::uint64_t nodes = CountExaminedNodes(tree, key, startDepth);
    sums.Leaves[static_cast<std::size_t>(startDepth)] += nodes;
    sums.Points[static_cast<std::size_t>(startDepth)] += nodes * leaf.GetNumberOfPoints();
  }
}
}

template <int Dim>
MeasuredCost MeasureCost(const Octree<Dim>& tree, const Execution& execution)
{
  constexpr std::size_t chunkSize = 64; // Blocks, of up to 2^Dim leaves each.
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  std::vector<Sums<Dim>> sums(Execution::GetNumberOfChunks(numberOfBlocks, chunkSize) + 1);
  if (!tree.IsRootInternal())
  {
    AddLeaf(tree, tree.GetRoot(), sums.back());
  }
  execution.ForChunks(numberOfBlocks, chunkSize,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      Sums<Dim> local;
      for (std::size_t block = first; block < last; ++block)
      {
        PrefetchBelow(tree, std::min(block + 1, numberOfBlocks - 1));
        for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
        {
          const typename Octree<Dim>::Node child = tree.GetChild(block, octant);
          if (!child.Internal)
          {
            AddLeaf(tree, child, local);
          }
        }
      }
      sums[chunk] = local;
    });

  MeasuredCost mean;
  const auto leaves = static_cast<double>(tree.GetNumberOfLeaves());
  const auto points = static_cast<double>(tree.GetNumberOfPoints());
  for (std::size_t depth = 0; depth <= static_cast<std::size_t>(tree.GetDeepestDepth()); ++depth)
  {
    std::uint64_t forLeaves = 0;
    std::uint64_t forPoints = 0;
    for (const Sums<Dim>& part : sums)
    {
      forLeaves += part.Leaves[depth];
      forPoints += part.Points[depth];
    }
    mean.Leaves.push_back(static_cast<double>(forLeaves) / leaves);
    mean.Points.push_back(points > 0.0 ? static_cast<double>(forPoints) / points : 0.0);
  }
  return mean;
}

template MeasuredCost MeasureCost(const Octree<1>&, const Execution&);
template MeasuredCost MeasureCost(const Octree<2>&, const Execution&);
template MeasuredCost MeasureCost(const Octree<3>&, const Execution&);
template MeasuredCost MeasureCost(const Octree<4>&, const Execution&);
}
