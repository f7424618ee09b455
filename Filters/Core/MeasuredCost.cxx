// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCost.h"

#include "DirectSearch.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>

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
using PartialSums = Sums<Dim, std::uint64_t>;
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

/**
 * Counts the nodes that searches for a leaf examine, from all start depths together. A search that
 * comes to a node goes on like the one that starts there: so each node on the way is looked up
 * once, and those above two leaves only for the first.
 */
template <int Dim>
class LeafSearches
{
public:
  using Counts = std::array<std::uint64_t, MortonKey<Dim>::MaxDepth + 1>;

  LeafSearches(const Octree<Dim>& tree, int lastStartDepth)
    : Tree(tree)
    , LastStartDepth(lastStartDepth)
  {
  }

  /** The leaf that a key of MaxDepth lies in. How many nodes, at index start depth. */
  Counts Count(MortonKey<Dim> key)
  {
    this->GoTo(key);
    const auto deepest = static_cast<std::size_t>(this->LastStartDepth);
    Counts nodes{};
    for (std::size_t depth = 0; depth <= deepest; ++depth)
    {
      nodes[depth] = this->Cases[depth] == SearchCase::Up ? nodes[depth - 1] + 1 : 1;
    }
    for (std::size_t depth = deepest; depth-- > 0;)
    {
      nodes[depth] = this->Cases[depth] == SearchCase::Down ? nodes[depth + 1] + 1 : nodes[depth];
    }
    return nodes;
  }

private:
  void GoTo(MortonKey<Dim> key)
  {
    int depth = this->Last ? MortonKey<Dim>::GetCommonDepth(*this->Last, key) + 1 : 0;
    for (; depth <= this->LastStartDepth; ++depth)
    {
      this->Cases[static_cast<std::size_t>(depth)] = this->Examine(key.AtDepth(depth));
    }
    this->Last = key;
  }

  /** How a search goes on from the node of a key. */
  SearchCase Examine(MortonKey<Dim> key) const
  {
    const auto node = this->Tree.FindNode(key);
    return !node ? SearchCase::Up : node->Internal ? SearchCase::Down : SearchCase::Hit;
  }

  const Octree<Dim>& Tree;
  int LastStartDepth;
  std::optional<MortonKey<Dim>> Last;
  std::array<SearchCase, MortonKey<Dim>::MaxDepth + 1> Cases{}; ///< On the way to the last leaf.
};

template <int Dim>
void AddLeaf(
  LeafSearches<Dim>& searches, const typename Octree<Dim>::Node& leaf, PartialSums<Dim>& sums)
{
  const auto nodes = searches.Count(leaf.NodeKey.GetFirstAtMaxDepth());
  for (std::size_t startDepth = 0; startDepth < nodes.size(); ++startDepth)
  {
    sums.Leaves[startDepth] += nodes[startDepth];
    sums.Points[startDepth] += nodes[startDepth] * leaf.GetNumberOfPoints();
  }
}

template <int Dim>
void AddSums(const PartialSums<Dim>& sums, Total<Dim>& total)
{
  for (std::size_t depth = 0; depth < sums.Leaves.size(); ++depth)
  {
    total.Leaves[depth].fetch_add(sums.Leaves[depth], std::memory_order_relaxed);
    total.Points[depth].fetch_add(sums.Points[depth], std::memory_order_relaxed);
  }
}

/** What one of `count` searches examines in the mean, given what those in this part do. */
template <int Dim, typename Numbers>
std::vector<double> GetMeans(const TreePart<Dim>& part, const Numbers& examined,
  std::size_t numberOfDepths, std::uint64_t count)
{
  std::vector<std::uint64_t> all(examined.begin(), examined.begin() + numberOfDepths);
  part.AddUp(all);
  std::vector<double> means(numberOfDepths, 0.0);
  for (std::size_t depth = 0; count > 0 && depth < numberOfDepths; ++depth)
  {
    means[depth] = static_cast<double>(all[depth]) / static_cast<double>(count);
  }
  return means;
}
}

template <int Dim>
MeasuredCost MeasureCost(const TreePart<Dim>& part, const Execution& execution)
{
  constexpr std::size_t chunkSize = 32; // Blocks, of up to 2^Dim leaves each.
  const Octree<Dim>& tree = part.GetTree();
  const int lastStartDepth = std::max(part.GetDeepestDepth(), 1);
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  Total<Dim> total;
  if (!tree.IsRootInternal() && part.Has(MortonKey<Dim>::Root()))
  {
    PartialSums<Dim> root;
    LeafSearches<Dim> searches(tree, lastStartDepth);
    AddLeaf(searches, tree.GetRoot(), root);
    AddSums(root, total);
  }
  execution.ForChunks(numberOfBlocks, chunkSize,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      PartialSums<Dim> sums;
      LeafSearches<Dim> searches(tree, lastStartDepth);
      for (std::size_t block = first; block < last; ++block)
      {
        PrefetchBelow(tree, std::min(block + 1, numberOfBlocks - 1));
        for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
        {
          const typename Octree<Dim>::Node child = tree.GetChild(block, octant);
          if (!child.Internal && part.Has(child.NodeKey))
          {
            AddLeaf(searches, child, sums);
          }
        }
      }
      AddSums(sums, total);
    });

  const auto numberOfDepths = static_cast<std::size_t>(lastStartDepth) + 1;
  const DepthCounts& counts = part.GetDepthCounts();
  return { GetMeans(part, total.Leaves, numberOfDepths, GetTotal(counts.Leaves)),
    GetMeans(part, total.Points, numberOfDepths, GetTotal(counts.Points)) };
}

template MeasuredCost MeasureCost(const TreePart<1>&, const Execution&);
template MeasuredCost MeasureCost(const TreePart<2>&, const Execution&);
template MeasuredCost MeasureCost(const TreePart<3>&, const Execution&);
template MeasuredCost MeasureCost(const TreePart<4>&, const Execution&);
}
