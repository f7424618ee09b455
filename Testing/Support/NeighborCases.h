// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_NeighborCases_h
#define Testing_Support_NeighborCases_h

#include "BruteForceNeighbors.h"
#include "Neighbor.h"
#include "SampleTree.h"

#include <algorithm>
#include <vector>

/** Its root has side 8; the bottom-left child is split, and of its children the top-right one. */
inline SampleTree<2, double> MakeThreeDepths()
{
  return SampleTree<2, double>(
    PointSample<2, double>{ "three depths", { 0.0, 0.0, 2.1, 2.1, 3.1, 3.1, 8.0, 8.0 } });
}

/** The keys of found neighbours, in their order; one found twice is there twice. */
template <int Dim>
std::vector<std::uint64_t> GetKeys(const std::vector<hashedoctree::Neighbor<Dim>>& found)
{
  std::vector<std::uint64_t> keys;
  keys.reserve(found.size());
  for (const auto& neighbor : found)
  {
    keys.push_back(neighbor.Key.GetValue());
  }
  return keys;
}

/** The same, sorted. */
template <int Dim>
std::vector<std::uint64_t> GetSortedKeys(const std::vector<hashedoctree::Neighbor<Dim>>& found)
{
  std::vector<std::uint64_t> keys = GetKeys(found);
  std::sort(keys.begin(), keys.end());
  return keys;
}

/** Whether the same neighbours were found in the same order, with the same told of each. */
template <int Dim>
bool AreSame(const std::vector<hashedoctree::Neighbor<Dim>>& found,
  const std::vector<hashedoctree::Neighbor<Dim>>& expected)
{
  return std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
    [](const auto& a, const auto& b) { return a.Key == b.Key && a.ParentBlock == b.ParentBlock; });
}

/** Checks what is told of each neighbour beside its key. */
template <int Dim>
void ExpectParentBlocks(
  const hashedoctree::Octree<Dim>& tree, const std::vector<hashedoctree::Neighbor<Dim>>& found)
{
  for (const auto& neighbor : found)
  {
    EXPECT_EQ(tree.GetBlockKey(neighbor.ParentBlock), neighbor.Key.GetParent());
  }
}

/** About `wanted` nodes of a tree, leaves and internal ones of all depths, or all if there are
 * fewer. */
template <int Dim>
std::vector<hashedoctree::MortonKey<Dim>> PickNodes(
  const hashedoctree::Octree<Dim>& tree, std::size_t wanted)
{
  std::vector<hashedoctree::MortonKey<Dim>> nodes;
  const std::size_t step = tree.GetNumberOfNodes() / wanted + 1;
  std::size_t number = 0;
  ForEachNode(tree,
    [&](const auto& node)
    {
      if (number++ % step == 0)
      {
        nodes.push_back(node.NodeKey);
      }
    });
  return nodes;
}

/** Calls check(tree, oracle, node) for about `wanted` nodes of each tree over the standing samples,
 * with one point per leaf and with three. */
template <int Dim, typename Check>
void ForNodesOfSamples(std::size_t wanted, const Check& check)
{
  for (const auto& sample : MakePointSamples<Dim, double>())
  {
    for (const std::size_t maxPointsPerLeaf : { 1U, 3U })
    {
      SCOPED_TRACE(sample.Name);
      const SampleTree<Dim, double> made(
        sample, { maxPointsPerLeaf, hashedoctree::MortonKey<Dim>::MaxDepth });
      const BruteForceNeighbors<Dim> oracle(made.Tree);
      for (const hashedoctree::MortonKey<Dim> node : PickNodes(made.Tree, wanted))
      {
        check(made.Tree, oracle, node);
      }
    }
  }
}

#endif
