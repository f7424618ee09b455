// SPDX-License-Identifier: BSD-3-Clause
#include "AdjacentSearch.h"

#include "AdjacentSearchAtStartDepth.h"
#include "BruteForceNeighbors.h"
#include "Dimensions.h"
#include "NeighborCases.h"

using namespace hashedoctree;

namespace
{
constexpr EmptyOctants Readings[] = { EmptyOctants::Leaves, EmptyOctants::Missing };

/** One point in each cell of a depth: a full tree. */
template <int Dim>
PointSample<Dim, double> MakeFullTree(int depth)
{
  PointSample<Dim, double> sample{ "full", {} };
  const std::uint32_t last = (1U << depth) - 1;
  for (std::uint64_t key = 1ULL << (Dim * depth); key < 2ULL << (Dim * depth); ++key)
  {
    for (const std::uint32_t coordinate : MortonKey<Dim>(key).GetCell())
    {
      // The points at the ends lie on the faces of the root.
      sample.Coordinates.push_back(coordinate == 0 ? 0.0 : coordinate + (coordinate == last));
    }
  }
  return sample;
}
}

template <typename Dimension>
class TestAdjacentSearch : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Key = MortonKey<Dim>;
  using Neighbors = std::vector<Neighbor<Dim>>;

  /** Checks the neighbours of a node from all start depths, and what finding them costs. */
  static void Check(const Octree<Dim>& tree, const BruteForceNeighbors<Dim>& oracle, Key node)
  {
    const std::uint64_t adjacentNodes = oracle.CountAdjacentNodes(node);
    const auto complete = oracle.FindAdjacent(node, EmptyOctants::Leaves);
    for (const EmptyOctants reading : Readings)
    {
      Neighbors first;
      FindAdjacentLeaves(tree, node, 0, first, reading);
      ASSERT_EQ(GetSortedKeys(first), oracle.FindAdjacent(node, reading));
      ExpectParentBlocks(tree, first);
      for (int startDepth = 0; startDepth <= Key::MaxDepth; ++startDepth)
      {
        Neighbors found(1);
        NodeCount count;
        FindAdjacentLeaves(tree, node, startDepth, found, count, reading);
        ASSERT_TRUE(AreSame(found, first));
        std::uint64_t expected = adjacentNodes;
        for (const std::uint64_t leaf : complete)
        {
          const int depth = Key(leaf).GetDepth();
          if (depth < node.GetDepth()) // Case 3.
          {
            expected += static_cast<std::uint64_t>(
              2 + std::abs(depth - std::min(startDepth, node.GetDepth() - 1)));
          }
        }
        ASSERT_EQ(count.Nodes, expected);
      }
    }
  }
};
TYPED_TEST_SUITE(TestAdjacentSearch, Dimensions);

TYPED_TEST(TestAdjacentSearch, EqualsBruteForceAtTheModelledCost)
{
  constexpr int dim = TestFixture::Dim;
  ForNodesOfSamples<dim>(150,
    [this](const auto& tree, const auto& oracle, MortonKey<dim> node)
    { this->Check(tree, oracle, node); });
}

TYPED_TEST(TestAdjacentSearch, EqualsBruteForceForAllNodesOfSmallTrees)
{
  constexpr int dim = TestFixture::Dim;
  for (unsigned seed = 511; seed < 515; ++seed)
  {
    const SampleTree<dim, double> made(PointSample<dim, double>{ "few",
      seed % 2 == 0 ? MakeUniformPoints<dim, double>(20, seed)
                    : MakeClusteredPoints<dim, double>(6, seed) });
    const BruteForceNeighbors<dim> oracle(made.Tree);
    ForEachNode(made.Tree, [&](const auto& node) { this->Check(made.Tree, oracle, node.NodeKey); });
  }
}

TYPED_TEST(TestAdjacentSearch, NothingIsBeyondTheBorderOfTheRoot)
{
  // 7, 11, 17 or 26 neighbours in 3D (README, row 26).
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(MakeFullTree<dim>(2));
  ASSERT_EQ(made.Tree.GetNumberOfLeaves(), std::size_t(1) << (2 * dim));
  std::vector<Neighbor<dim>> found;
  ForEachNode(made.Tree,
    [&](const auto& node)
    {
      std::size_t expected = 1;
      for (const std::uint32_t coordinate : node.NodeKey.GetCell())
      {
        const std::uint32_t last = (1U << node.NodeKey.GetDepth()) - 1;
        expected *= coordinate == 0 || coordinate == last ? 2 : 3;
      }
      if (!node.Internal)
      {
        FindAdjacentLeaves(made.Tree, node.NodeKey, 2, found);
        EXPECT_EQ(found.size(), expected - 1);
      }
    });
}

TYPED_TEST(TestAdjacentSearch, TheDeepestLeavesHaveTheirSiblings)
{
  // At least 2^Dim - 1 neighbours of the same depth (README, row 27).
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "clusters", MakeClusteredPoints<dim, double>(100, 521) });
  std::vector<Neighbor<dim>> found;
  ForEachLeaf(made.Tree,
    [&](const auto& leaf)
    {
      if (leaf.NodeKey.GetDepth() == made.Tree.GetDeepestDepth())
      {
        FindAdjacentLeaves(made.Tree, leaf.NodeKey, 0, found);
        EXPECT_GE(std::count_if(found.begin(), found.end(),
                    [&leaf](const auto& neighbor)
                    { return neighbor.Key.GetDepth() == leaf.NodeKey.GetDepth(); }),
          (1 << dim) - 1);
      }
    });
}

TYPED_TEST(TestAdjacentSearch, TreesOfOneLeafHaveNoNeighbours)
{
  constexpr int dim = TestFixture::Dim;
  for (const std::size_t count : { 0U, 1U })
  {
    const SampleTree<dim, double> made(
      PointSample<dim, double>{ "few", MakeUniformPoints<dim, double>(count, 531) });
    std::vector<Neighbor<dim>> found(1);
    FindAdjacentLeaves(made.Tree, MortonKey<dim>::Root(), 0, found);
    EXPECT_TRUE(found.empty());
  }
}

TYPED_TEST(TestAdjacentSearch, TheRejectedOptionFindsTheSame)
{
  // The option that the paper rejects (section 3b). Not from far below the node, where it looks at
  // too many cells.
  constexpr int dim = TestFixture::Dim;
  constexpr int deepestStart = 8 / dim;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample, { 3, MortonKey<dim>::MaxDepth });
    const int median = GetMedianDepth(made.Tree.GetDepthCounts().Leaves);
    for (const MortonKey<dim> node : PickNodes(made.Tree, 50))
    {
      for (const EmptyOctants reading : Readings)
      {
        std::vector<Neighbor<dim>> found;
        FindAdjacentLeaves(made.Tree, node, median, found, reading);
        NoCount count;
        AdjacentSearchAtStartDepth<dim, NoCount> rejected(made.Tree, count, reading);
        std::vector<Neighbor<dim>> same;
        const int last = std::min(MortonKey<dim>::MaxDepth, node.GetDepth() + deepestStart);
        for (int startDepth = 0; startDepth <= last; ++startDepth)
        {
          rejected.Find(node, startDepth, same);
          ASSERT_EQ(GetSortedKeys(same), GetSortedKeys(found)) << startDepth;
          ExpectParentBlocks(made.Tree, same);
        }
      }
    }
  }
}

TYPED_TEST(TestAdjacentSearch, ClimbingExaminesNoMoreNodesThanTheMedian)
{
  constexpr int dim = TestFixture::Dim;
  // Case 3 from min(startDepth, depth - 1) (README, row 25): below all leaves that is the plain
  // walk from parent to parent. The paper expects more of the median.
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    const int median = GetMedianDepth(made.Tree.GetDepthCounts().Leaves);
    NodeCount fromMedian;
    NodeCount climbing;
    NodeCount fromRoot;
    std::vector<Neighbor<dim>> found;
    ForEachLeaf(made.Tree,
      [&](const auto& leaf)
      {
        FindAdjacentLeaves(made.Tree, leaf.NodeKey, median, found, fromMedian);
        FindAdjacentLeaves(made.Tree, leaf.NodeKey, MortonKey<dim>::MaxDepth, found, climbing);
        FindAdjacentLeaves(made.Tree, leaf.NodeKey, 0, found, fromRoot);
      });
    EXPECT_LE(fromMedian.Nodes, fromRoot.Nodes);
    EXPECT_LE(climbing.Nodes, fromMedian.Nodes);
  }
}

TEST(TestAdjacentSearchFacts, Order)
{
  const SampleTree<2, double> made = MakeThreeDepths();
  const auto expect =
    [&made](std::uint64_t node, EmptyOctants reading, const std::vector<std::uint64_t>& expected)
  {
    std::vector<Neighbor<2>> found;
    FindAdjacentLeaves(made.Tree, MortonKey<2>(node), 0, found, reading);
    EXPECT_EQ(GetKeys(found), expected);
  };
  // Of top-left: the leaves along the top of bottom-left come first.
  expect(0b101, EmptyOctants::Leaves, { 0b10001, 0b1001101, 0b1001111, 0b110, 0b111 });
  expect(0b101, EmptyOctants::Missing, { 0b1001111, 0b111 });
  // Of the bottom-right child of bottom-left: one leaf beside it, two cells of which touch it.
  expect(0b10010, EmptyOctants::Leaves, { 0b10000, 0b10001, 0b1001100, 0b1001110, 0b110 });
  expect(0b10010, EmptyOctants::Missing, { 0b10000, 0b1001100 });
  // Of the internal child of bottom-left: what lies in it is left out.
  expect(0b10011, EmptyOctants::Leaves, { 0b10000, 0b10001, 0b10010, 0b101, 0b110, 0b111 });
}

TEST(TestAdjacentSearchFacts, TheRejectedOptionExaminesWhatTouchesOnTheWayDown)
{
  // Around the bottom-right child of bottom-left. From the root: it, bottom-left with three
  // children and two below the top-right of these, and bottom-right. From depth 1 all but the root.
  // From depth 2 each of the five cells that touch it, one of them with two children; two of the
  // others lie in the leaf at bottom-right, one depth above.
  const SampleTree<2, double> made = MakeThreeDepths();
  const std::array<std::uint64_t, 3> expected{ 8, 7, 9 };
  for (int startDepth = 0; startDepth < 3; ++startDepth)
  {
    NodeCount count;
    AdjacentSearchAtStartDepth<2, NodeCount> rejected(made.Tree, count);
    std::vector<Neighbor<2>> found;
    rejected.Find(MortonKey<2>(0b10010), startDepth, found);
    EXPECT_EQ(count.Nodes, expected[static_cast<std::size_t>(startDepth)]) << startDepth;
  }
}

TEST(TestAdjacentSearchFacts, TheRejectedOptionExaminesMoreNodes)
{
  const SampleTree<3, double> made(
    PointSample<3, double>{ "sphere", MakeSpherePoints<3, double>(2000, 551) });
  const int median = GetMedianDepth(made.Tree.GetDepthCounts().Leaves);
  NodeCount count;
  NodeCount rejectedCount;
  AdjacentSearchAtStartDepth<3, NodeCount> rejected(made.Tree, rejectedCount);
  std::vector<Neighbor<3>> found;
  ForEachLeaf(made.Tree,
    [&](const auto& leaf)
    {
      FindAdjacentLeaves(made.Tree, leaf.NodeKey, median, found, count);
      rejected.Find(leaf.NodeKey, median, found);
    });
  EXPECT_LT(count.Nodes, rejectedCount.Nodes);
}
