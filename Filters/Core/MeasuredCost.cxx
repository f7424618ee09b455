// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCost.h"

#include <array>
#include <atomic>

namespace hashedoctree
{
namespace
{
/** Nodes examined for all leaves, and for all points, per start depth. */
template <int Dim, typename Number>
struct Sums
{
  std::array<Number, MortonKey<Dim>::MaxDepth + 1> Leaves{};
  std::array<Number, MortonKey<Dim>::MaxDepth + 1> Points{};
};

/** What one thread adds to, and the sum of all. */
template <int Dim>
using Part = Sums<Dim, std::uint64_t>;
template <int Dim>
using Total = Sums<Dim, std::atomic<std::uint64_t>>;

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
void AddLeaf(const Octree<Dim>& tree, const typename Octree<Dim>::Node& leaf, Part<Dim>& part)
{
  const MortonKey<Dim> key = leaf.NodeKey.GetFirstAtMaxDepth();
  for (int startDepth = 0; startDepth <= tree.GetDeepestDepth(); ++startDepth)
  {
    const std::uint64_t nodes = CountExaminedNodes(tree, key, startDepth);
    part.Leaves[static_cast<std::size_t>(startDepth)] += nodes;
    part.Points[static_cast<std::size_t>(startDepth)] += nodes * leaf.GetNumberOfPoints();
  }
}

template <int Dim>
void AddPart(const Part<Dim>& part, Total<Dim>& total)
{
  for (std::size_t depth = 0; depth < part.Leaves.size(); ++depth)
  {
    total.Leaves[depth].fetch_add(part.Leaves[depth], std::memory_order_relaxed);
    total.Points[depth].fetch_add(part.Points[depth], std::memory_order_relaxed);
  }
}
}

template <int Dim>
MeasuredCost MeasureCost(const Octree<Dim>& tree, const Execution& execution)
{
  constexpr std::size_t chunkSize = 32; // Blocks, of up to 2^Dim leaves each.
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  Total<Dim> total;
  if (!tree.IsRootInternal())
  {
    Part<Dim> root;
    AddLeaf(tree, tree.GetRoot(), root);
    AddPart(root, total);
  }
  execution.ForChunks(numberOfBlocks, chunkSize,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      Part<Dim> part;
      for (std::size_t block = first; block < last; ++block)
      {
        PrefetchBelow(tree, std::min(block + 1, numberOfBlocks - 1));
        for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
        {
          const typename Octree<Dim>::Node child = tree.GetChild(block, octant);
          if (!child.Internal)
          {
            AddLeaf(tree, child, part);
          }
        }
      }
      AddPart(part, total);
    });

  MeasuredCost mean;
  const auto leaves = static_cast<double>(tree.GetNumberOfLeaves());
  const auto points = static_cast<double>(tree.GetNumberOfPoints());
  for (std::size_t depth = 0; depth <= static_cast<std::size_t>(tree.GetDeepestDepth()); ++depth)
  {
    mean.Leaves.push_back(static_cast<double>(total.Leaves[depth]) / leaves);
    mean.Points.push_back(points > 0.0 ? static_cast<double>(total.Points[depth]) / points : 0.0);
  }
  return mean;
}

template MeasuredCost MeasureCost(const Octree<1>&, const Execution&);
template MeasuredCost MeasureCost(const Octree<2>&, const Execution&);
template MeasuredCost MeasureCost(const Octree<3>&, const Execution&);
template MeasuredCost MeasureCost(const Octree<4>&, const Execution&);
}
