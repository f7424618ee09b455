// SPDX-License-Identifier: BSD-3-Clause
#include "BrotherChildOctree.h"
#include "NodePool.h"
#include "PaperHashedOctree.h"
#include "PointerOctree.h"
#include "TopDownSearch.h"

#include "BruteForceNeighbors.h"
#include "Dimensions.h"
#include "NeighborCases.h"
#include "Sanitized.h"

#include <cstdlib>
#include <set>
#include <type_traits>

using namespace hashedoctree;

/** The trees that Testing/Benchmarks compares ours with: that they have the same leaves, and that
 * their searches find what brute force does. */
template <typename Dimension>
class TestPaperBaselines : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Key = MortonKey<Dim>;
  using Leaf = typename Octree<Dim>::Node;

  /** Radii within the node, beyond its neighbours and beyond the root. */
  static std::vector<double> GetRadii(double side, double rootSide)
  {
    return { 0.0, 0.49 * side, 0.5 * side, side, 1.49 * side, 1.5 * side, 2.0 * side, 7.3 * side,
      0.3 * rootSide, 3.0 * rootSide };
  }

  template <typename Node>
  static void CheckData(const Octree<Dim>& tree, const Leaf& leaf, const Node& node)
  {
    ASSERT_TRUE(node.IsLeaf());
    ASSERT_EQ(node.Data == nullptr, leaf.IsEmpty());
    if (!leaf.IsEmpty())
    {
      ASSERT_EQ(node.Data->GetId(), tree.GetPointIds()[leaf.FirstPoint]);
    }
  }

  template <typename Placed>
  static std::vector<std::uint64_t> GetSortedKeysOf(const std::vector<Placed>& nodes)
  {
    std::vector<std::uint64_t> keys;
    keys.reserve(nodes.size());
    for (const auto& node : nodes)
    {
      EXPECT_TRUE(node.Node->IsLeaf());
      keys.push_back(node.GetKey().GetValue());
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  static std::vector<std::uint64_t> GetSortedValues(const std::vector<Key>& found)
  {
    std::vector<std::uint64_t> keys;
    keys.reserve(found.size());
    for (const Key key : found)
    {
      keys.push_back(key.GetValue());
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  /** Calls function(leaf) for a few leaves other than the root. */
  template <typename Function>
  static void ForSomeLeaves(const Octree<Dim>& tree, const Function& function)
  {
    for (const Key key : PickNodes(tree, 12))
    {
      if (key != Key::Root() && !tree.FindNode(key)->Internal)
      {
        function(key);
      }
    }
  }

  template <typename Pointers>
  static void CheckTopDown(const Octree<Dim>& tree, const BruteForceNeighbors<Dim>& oracle,
    const Pointers& pointers, const PlacedNode<Dim, typename Pointers::Node>& leaf)
  {
    const Grid<Dim>& grid = tree.GetGrid();
    std::vector<PlacedNode<Dim, typename Pointers::Node>> found(1);
    FindAdjacentTopDown(pointers, leaf, found);
    ASSERT_EQ(GetSortedKeysOf(found), oracle.FindAdjacent(leaf.GetKey(), EmptyOctants::Leaves));
    for (const double radius : GetRadii(grid.GetSide(leaf.Depth), grid.GetSide()))
    {
      FindInRadiusTopDown(pointers, grid, leaf, radius, found);
      ASSERT_EQ(GetSortedKeysOf(found),
        oracle.FindInRadius(leaf.GetKey(), radius, grid.GetSide(), EmptyOctants::Leaves))
        << radius / grid.GetSide(leaf.Depth);
    }
  }

  template <typename Pointers>
  static void CheckPointers(const Octree<Dim>& tree, const BruteForceNeighbors<Dim>& oracle,
    const SortedPoints<Dim>& points)
  {
    const Pointers pointers(points);
    ASSERT_EQ(pointers.GetBytes(), tree.GetNumberOfNodes() * sizeof(typename Pointers::Node));
    ForEachLeaf(tree,
      [&](const Leaf& leaf)
      {
        for (const Key key :
          { leaf.NodeKey.GetFirstAtMaxDepth(), leaf.NodeKey.GetLastAtMaxDepth() })
        {
          const auto found = pointers.FindLeaf(key.GetCell());
          ASSERT_EQ(found.GetKey(), leaf.NodeKey);
          CheckData(tree, leaf, *found.Node);
        }
      });
    ForSomeLeaves(tree,
      [&](Key key) {
        CheckTopDown(tree, oracle, pointers, pointers.FindLeaf(key.GetFirstAtMaxDepth().GetCell()));
      });
  }

  template <typename Hash>
  static void CheckHashed(const Octree<Dim>& tree, const BruteForceNeighbors<Dim>& oracle,
    const SortedPoints<Dim>& points, const Hash& hash)
  {
    using Hashed = PaperHashedOctree<Dim, Hash>;
    const Hashed hashed(points, hash);
    ASSERT_EQ(hashed.CountLeaves(), tree.GetDepthCounts().Leaves);
    ASSERT_GE(hashed.GetBytes(), tree.GetNumberOfNodes() * sizeof(typename Hashed::Node));
    ForEachNode(tree,
      [&](const Leaf& node) { ASSERT_EQ(hashed.Find(node.NodeKey)->IsLeaf(), !node.Internal); });
    ForEachLeaf(tree,
      [&](const Leaf& leaf)
      {
        for (int startDepth = 0; startDepth <= Key::MaxDepth; startDepth += 5)
        {
          NodeCount count;
          const auto* found = hashed.FindLeaf(leaf.NodeKey.GetLastAtMaxDepth(), startDepth, count);
          ASSERT_EQ(found->Key, leaf.NodeKey.GetValue());
          ASSERT_EQ(count.Nodes, 1U + std::abs(leaf.NodeKey.GetDepth() - startDepth)) << "E3";
          CheckData(tree, leaf, *found);
        }
      });
    const Grid<Dim>& grid = tree.GetGrid();
    std::vector<Key> found(1);
    ForSomeLeaves(tree,
      [&](Key key)
      {
        CheckTopDown(tree, oracle, hashed, { hashed.Find(key), key.GetCell(), key.GetDepth() });
        const std::array<int, 3> startDepths{ 0, 4, Key::MaxDepth };
        const auto adjacent = oracle.FindAdjacent(key, EmptyOctants::Leaves);
        for (const int startDepth : startDepths)
        {
          NodeCount count;
          hashed.FindAdjacent(key, startDepth, found, count);
          ASSERT_EQ(GetSortedValues(found), adjacent);
          ASSERT_EQ(
            count.Nodes, CountLooks(hashed, key, key, startDepth, found, [](Key) { return true; }));
        }
        for (const double radius : GetRadii(grid.GetSide(key.GetDepth()), grid.GetSide()))
        {
          const auto inRadius =
            oracle.FindInRadius(key, radius, grid.GetSide(), EmptyOctants::Leaves);
          const NodeBall<Dim> ball(grid, key, radius);
          const auto meets = [&ball](Key cell)
          { return ball.Meets(cell.GetCell(), cell.GetDepth()); };
          for (const int startDepth : startDepths)
          {
            NodeCount count;
            hashed.FindInRadius(key, radius, startDepth, found, count);
            ASSERT_EQ(GetSortedValues(found), inRadius);
            const Key middle = FindMiddle(grid, key, radius);
            ASSERT_EQ(count.Nodes, CountLooks(hashed, middle, key, startDepth, found, meets));
          }
        }
      });
  }

  /** The ancestor of a node around which an in-radius search begins (E14): the node itself, or,
   * where the ball reaches beyond the cells around it, the deepest that is wider than the radius.
   */
  static Key FindMiddle(const Grid<Dim>& grid, Key node, double radius)
  {
    const double ofRoot = radius / grid.GetSide();
    Key middle = node;
    if (std::ldexp(ofRoot, node.GetDepth()) >= 1.5)
    {
      while (middle != Key::Root() && std::ldexp(ofRoot, middle.GetDepth()) >= 1.0)
      {
        middle = middle.GetParent();
      }
    }
    return middle;
  }

  /** The looks of Algorithm 2, counted anew: one for each cell around the middle that is wanted,
   * with a direct search where there is no node, and one for each node on the way down to what was
   * found. */
  template <typename Hashed, typename Wanted>
  static std::uint64_t CountLooks(const Hashed& hashed, Key middle, Key node, int startDepth,
    const std::vector<Key>& found, const Wanted& isWanted)
  {
    NodeCount count;
    ForEachCellAround(middle,
      [&](Key cell, const auto&)
      {
        if (cell == node || !isWanted(cell))
        {
          return;
        }
        count.AddNode();
        if (hashed.Find(cell) == nullptr)
        {
          const int start = std::min(startDepth, middle.GetDepth() - 1);
          hashed.FindLeaf(cell.GetFirstAtMaxDepth(), start, count);
        }
      });
    std::set<std::uint64_t> wayDown;
    for (Key leaf : found)
    {
      for (; leaf.GetDepth() > middle.GetDepth(); leaf = leaf.GetParent())
      {
        wayDown.insert(leaf.GetValue());
      }
    }
    return count.Nodes + wayDown.size();
  }

  /** Calls function(tree, oracle, points) for trees over all samples that have points. */
  template <typename Function>
  static void ForEachTree(const Function& function)
  {
    for (const auto& sample : MakePointSamples<Dim, double>())
    {
      for (const std::size_t maxPointsPerLeaf : { 1U, 3U })
      {
        SCOPED_TRACE(sample.Name);
        const SampleTree<Dim, double> made(sample, { maxPointsPerLeaf, Key::MaxDepth });
        if (made.Selection.GetNumberOfPoints() != 0)
        {
          const SortedPoints<Dim> points(sample.GetSpan(), made.Selection, maxPointsPerLeaf);
          function(made.Tree, BruteForceNeighbors<Dim>(made.Tree), points);
        }
      }
    }
  }
};
// The paper has two and three, which is what a sanitizer is given time for.
using PaperDimensions =
  ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
using TestedDimensions = std::conditional_t<Sanitized, PaperDimensions, Dimensions>;
TYPED_TEST_SUITE(TestPaperBaselines, TestedDimensions);

TYPED_TEST(TestPaperBaselines, PointerOctree)
{
  constexpr int dim = TestFixture::Dim;
  this->ForEachTree([](const auto& tree, const auto& oracle, const auto& points)
    { TestFixture::template CheckPointers<PointerOctree<dim>>(tree, oracle, points); });
}

TYPED_TEST(TestPaperBaselines, BrotherChildOctree)
{
  constexpr int dim = TestFixture::Dim;
  this->ForEachTree(
    [](const auto& tree, const auto& oracle, const auto& points)
    {
      using Plain = BrotherChildOctree<dim, ParentPointers::No>;
      using WithParents = BrotherChildOctree<dim, ParentPointers::Yes>;
      TestFixture::template CheckPointers<Plain>(tree, oracle, points);
      TestFixture::template CheckPointers<WithParents>(tree, oracle, points);
    });
}

TYPED_TEST(TestPaperBaselines, PaperHashedOctree)
{
  this->ForEachTree(
    [](const auto& tree, const auto& oracle, const auto& points)
    {
      // So few slots that most nodes stand behind them, and as many as there are nodes.
      TestFixture::CheckHashed(tree, oracle, points, LowBitsHash(tree.GetNumberOfNodes() / 16));
      TestFixture::CheckHashed(tree, oracle, points, MixingHash(tree.GetNumberOfNodes() / 2));
    });
}

TEST(TestPaperBaselinesFacts, BytesOfNodesAreThePapers)
{
  // README, row 2, with pointers of eight bytes: the paper's 48 and 24 are with four and some
  // overhead.
  EXPECT_EQ(sizeof(PointerOctree<3>::Node), 72U);
  EXPECT_EQ(sizeof(BrotherChildOctree<3, ParentPointers::No>::Node), 24U);
  EXPECT_EQ(sizeof(BrotherChildOctree<3, ParentPointers::Yes>::Node), 32U);
  EXPECT_EQ(sizeof(PaperHashedOctree<3, LowBitsHash>::Node), 24U);
  EXPECT_EQ(GetPaperHash().GetNumberOfSlots(), std::size_t(1) << 21);
}

TEST(TestPaperBaselinesFacts, ProbesOfAChain)
{
  struct Node
  {
    std::uint64_t Key;
    std::uint32_t Next;
  };
  const LowBitsHash hash(100);
  const std::size_t slots = hash.GetNumberOfSlots();
  ChainedNodeTable<Node, LowBitsHash> table(hash);
  for (const std::size_t key : { std::size_t(7), 7 + slots, 7 + 2 * slots, std::size_t(9) })
  {
    table.Insert({ key, 0 });
  }
  EXPECT_EQ(table.GetProbeLengths(), (std::vector<std::size_t>{ 2, 1, 1 }));
}

TEST(TestPaperBaselinesFacts, FamiliesOfAPoolStayWhereTheyAre)
{
  NodePool<int, 4> pool;
  std::vector<int*> families;
  for (int i = 0; i < 100000; ++i)
  {
    families.push_back(pool.AddSiblings());
    std::fill_n(families.back(), 4, i);
  }
  for (int i = 0; i < 100000; ++i)
  {
    ASSERT_EQ(std::count(families[i], families[i] + 4, i), 4) << i;
  }
  EXPECT_EQ(pool.GetBytes(), 400000 * sizeof(int));
}
