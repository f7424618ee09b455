// SPDX-License-Identifier: BSD-3-Clause
#include "InRadiusSearch.h"

#include "AdjacentSearch.h"
#include "BruteForceNeighbors.h"
#include "Dimensions.h"
#include "NeighborCases.h"
#include "NodeBall.h"

#include <cstdlib>
#include <limits>
#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestInRadiusSearch : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Key = MortonKey<Dim>;

  /** Radii from 0 to beyond the root: within the node, to its faces exactly, beyond its adjacent
   * leaves, and in steps of the depth. */
  static std::vector<double> GetRadii(const Grid<Dim>& grid, int depth)
  {
    const double side = grid.GetSide(depth);
    std::vector<double> radii{ 0.0, 0.49 * side, 0.5 * side, 0.51 * side, std::sqrt(0.5) * side,
      side, 1.5 * side, 1.51 * side, 2.5 * side, 7.0 * side, 2.0 * grid.GetSide(),
      std::numeric_limits<double>::infinity() };
    for (int above = 0; above < depth; above += 2)
    {
      radii.push_back(0.7 * grid.GetSide(above));
    }
    return radii;
  }

  /** The children, but the node that is searched from, of an internal node that meets a ball and of
   * all such below it. */
  static std::uint64_t CountBelow(
    const Octree<Dim>& tree, const NodeBall<Dim>& ball, Key node, Key parent)
  {
    std::uint64_t count = 0;
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      const Key child = parent.GetChild(octant);
      if (child != node)
      {
        const bool isEntered =
          tree.FindNode(child)->Internal && ball.Meets(child.GetCell(), child.GetDepth());
        count += 1 + (isEntered ? CountBelow(tree, ball, node, child) : 0);
      }
    }
    return count;
  }

  /** What a search examines: what is in the cells that cover the ball, and for each leaf that holds
   * some of these cells one of them and what a direct search from there does. */
  static std::uint64_t CountNodes(const Octree<Dim>& tree, Key node, double radius, int startDepth)
  {
    const NodeBall<Dim> ball(tree.GetGrid(), node, radius);
    if (node == Key::Root() || !ball.ReachesBorder())
    {
      return 0;
    }
    const NeighborCells<Dim> cover = ball.GetCover();
    typename NeighborCells<Dim>::CornerKeys cells;
    const std::size_t numberOfCells = cover.GetKeys(cells);
    std::set<std::uint64_t> leaves;
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < numberOfCells; ++i)
    {
      const Key cell = cells[i].Key;
      const auto found = tree.FindNode(cell);
      if (found && found->Internal)
      {
        count += CountBelow(tree, ball, node, cell);
        continue;
      }
      Key leaf = cell;
      for (; !tree.FindNode(leaf); leaf = leaf.GetParent())
      {
      }
      if (leaves.insert(leaf.GetValue()).second)
      {
        const int start = std::min(startDepth, cover.Depth);
        count += static_cast<std::uint64_t>(2 + std::abs(leaf.GetDepth() - start));
      }
    }
    return count;
  }

  static void Check(const Octree<Dim>& tree, const BruteForceNeighbors<Dim>& oracle, Key node)
  {
    const double side = tree.GetGrid().GetSide();
    for (const double radius : GetRadii(tree.GetGrid(), node.GetDepth()))
    {
      for (const EmptyOctants reading : { EmptyOctants::Leaves, EmptyOctants::Missing })
      {
        const auto expected = oracle.FindInRadius(node, radius, side, reading);
        std::vector<Neighbor<Dim>> first;
        FindLeavesInRadius(tree, node, radius, 0, first, reading);
        ASSERT_EQ(GetSortedKeys(first), expected) << radius / side;
        ExpectParentBlocks(tree, first);
        for (int startDepth = 0; startDepth <= Key::MaxDepth; startDepth += 5)
        {
          std::vector<Neighbor<Dim>> found(1);
          NodeCount count;
          FindLeavesInRadius(tree, node, radius, startDepth, found, count, reading);
          ASSERT_TRUE(AreSame(found, first));
          ASSERT_EQ(count.Nodes, CountNodes(tree, node, radius, startDepth));
          // What does not count is compiled for another machine.
          FindLeavesInRadius(tree, node, radius, startDepth, found, reading);
          ASSERT_TRUE(AreSame(found, first));
        }
      }
    }
  }
};
TYPED_TEST_SUITE(TestInRadiusSearch, Dimensions);

TYPED_TEST(TestInRadiusSearch, EqualsBruteForce)
{
  constexpr int dim = TestFixture::Dim;
  ForNodesOfSamples<dim>(12,
    [this](const auto& tree, const auto& oracle, MortonKey<dim> node)
    { this->Check(tree, oracle, node); });
}

TYPED_TEST(TestInRadiusSearch, EqualsBruteForceForAllNodesOfSmallTrees)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& coordinates :
    { MakeUniformPoints<dim, double>(20, 601), MakeClusteredPoints<dim, double>(4, 602) })
  {
    const SampleTree<dim, double> made(PointSample<dim, double>{ "few", coordinates });
    const BruteForceNeighbors<dim> oracle(made.Tree);
    ForEachNode(made.Tree, [&](const auto& node) { this->Check(made.Tree, oracle, node.NodeKey); });
  }
}

TYPED_TEST(TestInRadiusSearch, NoRadiusFindsNothingAndAnInfiniteOneAll)
{
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "uniform", MakeUniformPoints<dim, double>(100, 611) });
  const auto leaf = FindLeaf(made.Tree, MortonKey<dim>::Root().GetLastAtMaxDepth(), 0);
  std::vector<Neighbor<dim>> found;
  for (const double radius :
    { -1.0, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    found.resize(1);
    FindLeavesInRadius(made.Tree, leaf.Key, radius, 3, found);
    EXPECT_TRUE(found.empty());
  }
  for (const double radius :
    { std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity() })
  {
    NodeCount count;
    FindLeavesInRadius(made.Tree, leaf.Key, radius, 3, found, count);
    EXPECT_EQ(found.size(), made.Tree.GetNumberOfLeaves() - 1);
    EXPECT_EQ(count.Nodes, made.Tree.GetNumberOfNodes() - 2); // Not the root and the leaf itself.
    FindLeavesInRadius(made.Tree, MortonKey<dim>::Root(), radius, 3, found);
    EXPECT_TRUE(found.empty());
  }
}

TYPED_TEST(TestInRadiusSearch, ToTheCornersAreTheAdjacentLeavesAtLeast)
{
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "clusters", MakeClusteredPoints<dim, double>(50, 621) });
  std::vector<Neighbor<dim>> adjacent;
  std::vector<Neighbor<dim>> found;
  ForEachLeaf(made.Tree,
    [&](const auto& leaf)
    {
      const double side = made.Tree.GetGrid().GetSide(leaf.NodeKey.GetDepth());
      FindAdjacentLeaves(made.Tree, leaf.NodeKey, 3, adjacent);
      FindLeavesInRadius(made.Tree, leaf.NodeKey, std::sqrt(dim) * 0.501 * side, 3, found);
      const auto keys = GetSortedKeys(found);
      const auto adjacentKeys = GetSortedKeys(adjacent);
      EXPECT_TRUE(
        std::includes(keys.begin(), keys.end(), adjacentKeys.begin(), adjacentKeys.end()));
    });
}

TEST(TestInRadiusSearchFacts, EmptySpaceCostsNothing)
{
  // The smallest node, and a ball of a million cells of its size: in it are a few large leaves.
  const SampleTree<3, double> made(PointSample<3, double>{
    "pair", { 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 } });
  const auto leaf =
    FindLeaf(made.Tree, made.Tree.GetGrid().GetKey(Position<3>{ 0.1, 0.1, 0.1 }.data()), 0);
  ASSERT_EQ(leaf.Key.GetDepth(), MortonKey<3>::MaxDepth);
  std::vector<Neighbor<3>> found;
  NodeCount count;
  FindLeavesInRadius(made.Tree, leaf.Key, 60.0 * made.Tree.GetGrid().GetSide(21), 21, found, count);
  EXPECT_GT(found.size(), 40U);
  EXPECT_LT(count.Nodes, 150U);
}

TEST(TestInRadiusSearchFacts, Order)
{
  const SampleTree<2, double> made = MakeThreeDepths();
  const auto expect =
    [&made](std::uint64_t node, double radius, const std::vector<std::uint64_t>& expected)
  {
    std::vector<Neighbor<2>> found;
    FindLeavesInRadius(made.Tree, MortonKey<2>(node), radius, 0, found);
    EXPECT_EQ(GetKeys(found), expected);
  };
  // Around (3, 1), the middle of [2, 4] x [0, 2].
  expect(0b10010, 0.99, {});
  expect(0b10010, 1.0, { 0b10000, 0b110, 0b1001100, 0b1001110 });
  expect(0b10010, 1.5, { 0b10000, 0b10001, 0b110, 0b1001100, 0b1001110 });
  expect(
    0b10010, 3.1, { 0b101, 0b110, 0b10000, 0b10001, 0b1001100, 0b1001101, 0b1001110, 0b1001111 });
}
