// SPDX-License-Identifier: BSD-3-Clause
#include "PaperNeighborStarts.h"

#include "AdjacentSearch.h"
#include "AdjacentSearchAtStartDepth.h"
#include "InRadiusSearch.h"
#include "NodeStartDepths.h"
#include "TopDownSearch.h"

#include <algorithm>

namespace paper_benchmark
{
namespace
{
using hashedoctree::NodeCount;
using hashedoctree::Octree;

/** For each leaf the nodes that a search for its neighbours examines from each depth of the tree:
 * count(leaf, startDepth). */
template <typename CountNodes>
std::vector<std::vector<std::uint64_t>> ScanStartDepths(
  const std::vector<Key>& leaves, int deepest, const CountNodes& count)
{
  std::vector<std::vector<std::uint64_t>> nodes;
  for (const Key leaf : leaves)
  {
    nodes.emplace_back();
    for (int startDepth = 0; startDepth <= deepest; ++startDepth)
    {
      nodes.back().push_back(count(leaf, startDepth));
    }
  }
  return nodes;
}

NeighborCosts GetCosts(const std::vector<std::vector<std::uint64_t>>& nodes, int median)
{
  std::vector<std::uint64_t> sums(nodes.front().size(), 0);
  std::uint64_t own = 0;
  for (const std::vector<std::uint64_t>& ofLeaf : nodes)
  {
    std::transform(ofLeaf.begin(), ofLeaf.end(), sums.begin(), sums.begin(), std::plus<>());
    own += *std::min_element(ofLeaf.begin(), ofLeaf.end());
  }
  const auto best = std::min_element(sums.begin(), sums.end());
  const auto getMean = [&nodes](std::uint64_t sum)
  { return static_cast<double>(sum) / static_cast<double>(nodes.size()); };
  return { getMean(sums.front()), getMean(sums[static_cast<std::size_t>(median)]), getMean(*best),
    static_cast<int>(best - sums.begin()), getMean(own), getMean(sums.back()) };
}

/** The paper's tree, as a classical search sees it, with the nodes that it looks at counted. */
class CountedTree
{
public:
  using Node = TreePaper::Node;
  static constexpr bool HasParents = TreePaper::HasParents;

  explicit CountedTree(const TreePaper& tree)
    : Tree(tree)
  {
  }

  const Node* GetRoot() const
  {
    ++this->Looks;
    return this->Tree.GetRoot();
  }
  template <typename Wants, typename Function>
  void ForEachChild(const Node& node, const Wants& wants, const Function& function) const
  {
    this->Tree.ForEachChild(node, wants,
      [&](const Node& child)
      {
        ++this->Looks;
        function(child);
      });
  }

  std::size_t GetLooks() const { return this->Looks; }

private:
  const TreePaper& Tree;
  mutable std::size_t Looks = 0;
};

/** Looks of the classical searches for the neighbours of leaves: search(tree, leaf, found). */
template <typename Search>
double CountTopDown(const TreePaper& tree, const std::vector<Key>& leaves, const Search& search)
{
  using Placed = PlacedNode<3, TreePaper::Node>;
  const CountedTree counted(tree);
  std::vector<Placed> found;
  for (const Key leaf : leaves)
  {
    search(counted, Placed{ tree.Find(leaf), leaf.GetCell(), leaf.GetDepth() }, found);
  }
  return static_cast<double>(counted.GetLooks()) / static_cast<double>(leaves.size());
}

/** Both options of the adjacent search (the paper's section 3b) from the median. Nodes are counted
 * apart from the time. */
void CompareOptions(
  const Octree<3>& tree, const std::vector<Key>& leaves, int repetitions, PaperResults& results)
{
  std::vector<hashedoctree::Neighbor<3>> found;
  const auto forEachLeaf = [&leaves](const auto& search)
  { std::for_each(leaves.begin(), leaves.end(), search); };
  const auto reject = [&](auto& count)
  {
    AdjacentSearchAtStartDepth<3, std::decay_t<decltype(count)>> rejected(tree, count);
    forEachLeaf([&](Key leaf) { rejected.Find(leaf, results.StartDepth, found); });
  };
  const auto take = [&](auto& count)
  {
    forEachLeaf(
      [&](Key leaf) { FindAdjacentLeaves(tree, leaf, results.StartDepth, found, count); });
  };
  const auto getNodes = [&leaves](const auto& search)
  {
    NodeCount count;
    search(count);
    return static_cast<double>(count.Nodes) / static_cast<double>(leaves.size());
  };
  hashedoctree::NoCount none;
  const std::vector<Spread> times = TimeInTurns({ [&] { return GetSeconds([&] { reject(none); }); },
                                                  [&] { return GetSeconds([&] { take(none); }); } },
    leaves.size(), repetitions);
  results.Neighbors.Rejected = { getNodes(reject), times[0] };
  results.Neighbors.Taken = { getNodes(take), times[1] };
}

/** The start depth kept for a leaf that is not the root, looked up as a search does that knows only
 * the leaf's key. */
int GetOwnStartDepth(
  const Octree<3>& tree, const hashedoctree::NodeStartDepths<3>& stored, Key leaf)
{
  return stored.Get(tree.GetTable().Find(leaf.GetParent().GetValue())->Block, leaf.GetOctant());
}

/** Adjacent searches from the median and from the depths that are kept, which are looked up. */
void TimeOwnStartDepths(const Octree<3>& tree, const std::vector<Key>& leaves,
  const hashedoctree::NodeStartDepths<3>& stored, int repetitions, PaperResults& results)
{
  std::vector<hashedoctree::Neighbor<3>> found;
  const auto time = [&](const auto& getStartDepth)
  {
    return GetSeconds(
      [&]
      {
        for (const Key leaf : leaves)
        {
          FindAdjacentLeaves(tree, leaf, getStartDepth(leaf), found);
        }
      });
  };
  const std::vector<Spread> times = TimeInTurns(
    { [&] { return time([&](Key) { return results.StartDepth; }); },
      [&] { return time([&](Key leaf) { return GetOwnStartDepth(tree, stored, leaf); }); } },
    leaves.size(), repetitions);
  results.Neighbors.MedianTime = times[0];
  results.Neighbors.OwnTime = times[1];
}

/** What searches of the paper's own tree look at. */
void CountInPaperTree(
  const PaperTrees& trees, const std::vector<Key>& leaves, double radius, PaperResults& results)
{
  const int deepest = trees.Ours.GetDeepestDepth();
  std::vector<Key> keys;
  const auto countAdjacent = [&](Key leaf, int startDepth)
  {
    NodeCount count;
    trees.Paper->FindAdjacent(leaf, startDepth, keys, count);
    return count.Nodes;
  };
  const auto countInRadius = [&](Key leaf, int startDepth)
  {
    NodeCount count;
    trees.Paper->FindInRadius(leaf, radius, startDepth, keys, count);
    return count.Nodes;
  };
  NeighborStarts& starts = results.Neighbors;
  starts.PaperAdjacent =
    GetCosts(ScanStartDepths(leaves, deepest, countAdjacent), results.StartDepth);
  starts.PaperInRadius =
    GetCosts(ScanStartDepths(leaves, deepest, countInRadius), results.StartDepth);
  starts.PaperAdjacent.TopDown = CountTopDown(*trees.Paper, leaves,
    [](const auto& counted, const auto& leaf, auto& placed)
    { FindAdjacentTopDown(counted, leaf, placed); });
  starts.PaperInRadius.TopDown = CountTopDown(*trees.Paper, leaves,
    [&](const auto& counted, const auto& leaf, auto& placed)
    { FindInRadiusTopDown(counted, trees.Ours.GetGrid(), leaf, radius, placed); });
}

/** What searches of our tree look at, and whether the start depths kept for the leaves are those
 * from which adjacent searches look at the fewest. */
void CountInOurTree(const Octree<3>& tree, const std::vector<Key>& leaves, double radius,
  const hashedoctree::NodeStartDepths<3>& stored, PaperResults& results)
{
  std::vector<hashedoctree::Neighbor<3>> found;
  const auto countAdjacent = [&](Key leaf, int startDepth)
  {
    NodeCount count;
    FindAdjacentLeaves(tree, leaf, startDepth, found, count);
    return count.Nodes;
  };
  const auto countInRadius = [&](Key leaf, int startDepth)
  {
    NodeCount count;
    FindLeavesInRadius(tree, leaf, radius, startDepth, found, count);
    return count.Nodes;
  };
  const int deepest = tree.GetDeepestDepth();
  const auto adjacent = ScanStartDepths(leaves, deepest, countAdjacent);
  results.Neighbors.Adjacent = GetCosts(adjacent, results.StartDepth);
  results.Neighbors.InRadius =
    GetCosts(ScanStartDepths(leaves, deepest, countInRadius), results.StartDepth);
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    const std::uint64_t own = countAdjacent(leaves[i], GetOwnStartDepth(tree, stored, leaves[i]));
    const std::uint64_t fewest = *std::min_element(adjacent[i].begin(), adjacent[i].end());
    ++results.CheckedAnswers;
    results.DifferentAnswers += own == fewest ? 0 : 1;
  }
}
}

void MeasureNeighborStarts(const PaperTrees& trees, const std::vector<Key>& leaves, double radius,
  int repetitions, PaperResults& results)
{
  const Octree<3>& tree = trees.Ours;
  const auto getFirst = [&leaves](std::size_t most) -> std::vector<Key> {
    return { leaves.begin(), leaves.begin() + std::min(leaves.size(), most) };
  };
  const std::vector<Key> scanned = getFirst(MaxScannedLeaves);
  CountInPaperTree(trees, scanned, radius, results);
  hashedoctree::NodeStartDepths<3> stored;
  results.Neighbors.StoredSeconds =
    GetSeconds([&] { stored = hashedoctree::NodeStartDepths<3>(tree, hashedoctree::Execution()); });
  results.Neighbors.StoredBytes = stored.GetBytes();
  CountInOurTree(tree, scanned, radius, stored, results);
  TimeOwnStartDepths(tree, scanned, stored, repetitions, results);
  CompareOptions(tree, getFirst(MaxRejectedLeaves), repetitions, results);
}
}
