// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCost.h"

#include "ForEachDimension.h"

#include <algorithm>
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
using PartialSums = Sums<Dim, std::uint64_t>;
template <int Dim>
using Total = Sums<Dim, std::atomic<std::uint64_t>>;

/** The keys that searches for the leaves of a block look up, and do not find, when they start below
 * them: scattered over the table, so they are asked for well ahead. */
template <int Dim>
void PrefetchBelow(const Octree<Dim>& tree, std::size_t block)
{
  tree.ForEachChild(block, block + 1,
    [&tree](const typename Octree<Dim>::Node& child)
    {
      const MortonKey<Dim> key = child.NodeKey.GetFirstAtMaxDepth();
      for (int depth = child.NodeKey.GetDepth(); depth < tree.GetDeepestDepth(); ++depth)
      {
        tree.GetTable().Prefetch(key.AtDepth(depth).GetValue());
      }
    });
}

/**
 * Counts the nodes that searches for leaves examine, from all start depths together. A search that
 * comes to a node goes on like the one that starts there: so each node on the way to a leaf is
 * looked up once, and those that the leaf before it has there, too, not again. Where the searches
 * for several leaves in turn go up and down at the same depths, they are added up together.
 */
template <int Dim>
class LeafSearches
{
public:
  LeafSearches(const Octree<Dim>& tree, int lastStartDepth)
    : Tree(tree)
    , LastStartDepth(lastStartDepth)
    , Last{ 0, tree.IsRootInternal() ? 1U : 0U }
  {
  }

  void Add(const typename Octree<Dim>::Node& leaf)
  {
    const MortonKey<Dim> key = leaf.NodeKey.GetFirstAtMaxDepth();
    const Way way = this->FindWay(key);
    if (way.Up != this->Last.Up || way.Down != this->Last.Down)
    {
      this->AddUp();
    }
    this->LastKey = key;
    this->Last = way;
    ++this->Leaves;
    this->Points += leaf.GetNumberOfPoints();
  }

  /** What all searches together examine. */
  const PartialSums<Dim>& GetSums()
  {
    this->AddUp();
    return this->Sums;
  }

private:
  /** How searches go on from the nodes at all depths above a key of MaxDepth: bit depth. */
  struct Way
  {
    std::uint32_t Up;
    std::uint32_t Down;
  };

  Way FindWay(MortonKey<Dim> key) const
  {
    int depth = this->Leaves > 0 ? MortonKey<Dim>::GetCommonDepth(this->LastKey, key) + 1 : 1;
    const std::uint32_t known = (1U << depth) - 1U;
    Way way{ this->Last.Up & known, this->Last.Down & known };
    for (; depth <= this->LastStartDepth; ++depth)
    {
      // A node is seen in its parent, as by FindLeaf().
      const auto* parent = this->Tree.GetTable().Find(key.AtDepth(depth - 1).GetValue());
      const std::uint32_t internal = parent != nullptr ? parent->Internal : 0U;
      way.Up |= (parent == nullptr ? 1U : 0U) << depth;
      way.Down |= (internal >> key.AtDepth(depth).GetOctant() & 1U) << depth;
    }
    return way;
  }

  /** Adds the leaves since the last call, whose ways are the last one. */
  void AddUp()
  {
    const auto deepest = static_cast<std::size_t>(this->LastStartDepth);
    std::array<std::uint64_t, MortonKey<Dim>::MaxDepth + 1> nodes{};
    for (std::size_t depth = 0; depth <= deepest; ++depth)
    {
      nodes[depth] = (this->Last.Up >> depth & 1U) != 0 ? nodes[depth - 1] + 1 : 1;
    }
    for (std::size_t depth = deepest; depth-- > 0;)
    {
      nodes[depth] = (this->Last.Down >> depth & 1U) != 0 ? nodes[depth + 1] + 1 : nodes[depth];
    }
    for (std::size_t depth = 0; depth <= deepest; ++depth)
    {
      this->Sums.Leaves[depth] += nodes[depth] * this->Leaves;
      this->Sums.Points[depth] += nodes[depth] * this->Points;
    }
    this->Leaves = 0;
    this->Points = 0;
  }

  const Octree<Dim>& Tree;
  int LastStartDepth;
  MortonKey<Dim> LastKey;
  Way Last;
  std::uint64_t Leaves = 0; ///< Not yet in the sums; some whenever another is added.
  std::uint64_t Points = 0; ///< In these leaves.
  PartialSums<Dim> Sums;
};

template <int Dim>
void AddSums(const PartialSums<Dim>& sums, Total<Dim>& total)
{
  for (std::size_t depth = 0; depth < sums.Leaves.size(); ++depth)
  {
    total.Leaves[depth].fetch_add(sums.Leaves[depth], std::memory_order_relaxed);
    total.Points[depth].fetch_add(sums.Points[depth], std::memory_order_relaxed);
  }
}

/** Adds what the searches for all leaves of the part examine to the total, on several threads. */
template <int Dim>
void AddSearches(
  const TreePart<Dim>& part, int lastStartDepth, const Execution& execution, Total<Dim>& total)
{
  constexpr std::size_t chunkSize = 32; // Blocks, of up to 2^Dim leaves each.
  using Node = typename Octree<Dim>::Node;
  const Octree<Dim>& tree = part.GetTree();
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  const auto add = [&part](const Node& node, LeafSearches<Dim>& searches)
  {
    if (!node.Internal && part.Has(node.NodeKey))
    {
      searches.Add(node);
    }
  };
  LeafSearches<Dim> ofRoot(tree, lastStartDepth);
  add(tree.GetRoot(), ofRoot);
  AddSums(ofRoot.GetSums(), total);
  execution.ForChunks(numberOfBlocks, chunkSize,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      LeafSearches<Dim> searches(tree, lastStartDepth);
      for (std::size_t block = first; block < last; ++block)
      {
        PrefetchBelow(tree, std::min(block + 1, numberOfBlocks - 1));
        tree.ForEachChild(block, block + 1, [&](const Node& child) { add(child, searches); });
      }
      AddSums(searches.GetSums(), total);
    });
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
  const int lastStartDepth = std::max(part.GetDeepestDepth(), 1);
  Total<Dim> total;
  AddSearches(part, lastStartDepth, execution, total);

  const auto numberOfDepths = static_cast<std::size_t>(lastStartDepth) + 1;
  const DepthCounts& counts = part.GetDepthCounts();
  return { GetMeans(part, total.Leaves, numberOfDepths, GetTotal(counts.Leaves)),
    GetMeans(part, total.Points, numberOfDepths, GetTotal(counts.Points)) };
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template MeasuredCost MeasureCost(const TreePart<Dim>&, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
