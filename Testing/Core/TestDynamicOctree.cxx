// SPDX-License-Identifier: BSD-3-Clause
#include "DynamicOctree.h"

#include "DecisionSearch.h"
#include "Dimensions.h"
#include "SampleTree.h"
#include "ScarceMemory.h"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

using namespace hashedoctree;

namespace
{
constexpr FrequencyModel AllModels[] = { FrequencyModel::Leaves, FrequencyModel::Points,
  FrequencyModel::Grid };

/** The ids in each leaf, empty leaves too, in order. */
using LeafIds = std::map<std::uint64_t, std::vector<std::uint32_t>>;

/** Walks all nodes of a dynamic tree from the root, and holds the table against the blocks. */
template <int Dim>
class LeafWalk
{
public:
  explicit LeafWalk(const DynamicOctree<Dim>& tree)
    : Tree(tree)
  {
    if (tree.IsRootInternal())
    {
      const MortonKey<Dim> root = MortonKey<Dim>::Root();
      this->Walk(root, tree.GetTable().Find(root.GetValue())->Block);
    }
    else
    {
      this->AddLeaf(MortonKey<Dim>::Root(), 0, tree.GetNumberOfPoints() != 0);
    }
    EXPECT_EQ(this->Tree.GetTable().GetNumberOfKeys(), this->InternalNodes);
    EXPECT_EQ(this->Tree.GetNumberOfInternalNodes(), this->InternalNodes);
  }
  LeafIds Leaves;

private:
  void Walk(MortonKey<Dim> node, std::uint32_t number)
  {
    ++this->InternalNodes;
    const auto& block = this->Tree.GetBlock(number);
    const auto* entry = this->Tree.GetTable().Find(node.GetValue());
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->Block, number);
    EXPECT_EQ(entry->Internal, block.Internal);
    EXPECT_EQ(entry->Occupied, block.Occupied);
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      const bool occupied = (block.Occupied >> octant & 1U) != 0;
      if ((block.Internal >> octant & 1U) != 0)
      {
        EXPECT_TRUE(occupied);
        this->Walk(node.GetChild(octant), block.Children[octant]);
      }
      else
      {
        this->AddLeaf(node.GetChild(octant), number, occupied);
      }
    }
  }
  void AddLeaf(MortonKey<Dim> leaf, std::uint32_t parentBlock, bool occupied)
  {
    std::vector<std::uint32_t>& ids = this->Leaves[leaf.GetValue()];
    this->Tree.ForEachPoint(
      { leaf, parentBlock, true }, [&ids](std::uint32_t id) { ids.push_back(id); });
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(occupied, !ids.empty());
  }

  const DynamicOctree<Dim>& Tree;
  std::size_t InternalNodes = 0;
};

/** A dynamic tree in the unit cube, and the points that it should hold. */
template <int Dim>
struct ChangingTree
{
  using Options = typename Octree<Dim>::Options;
  static constexpr std::uint32_t MostPoints = 1000;

  explicit ChangingTree(const Options& options)
    : Tree(Grid<Dim>(GetUnitCube()), options)
  {
  }

  static Box<Dim> GetUnitCube()
  {
    Position<Dim> upper;
    upper.fill(1.0);
    return { Position<Dim>{}, upper };
  }

  /** Uniform around the cube, in clusters, or at one of a few places. */
  Position<Dim> MakePosition()
  {
    std::uniform_real_distribution<double> uniform(-0.1, 1.1);
    Position<Dim> x;
    const auto kind = this->Random() % 4;
    const double size = std::ldexp(1.0, -static_cast<int>(this->Random() % 40));
    for (double& coordinate : x)
    {
      coordinate = kind == 0 ? uniform(this->Random)
        : kind == 1          ? static_cast<double>(this->Random() % 3) / 2.0
                             : 0.3 + size * uniform(this->Random);
    }
    return x;
  }

  /** Inserts, erases or moves a point; `growth` of 10 changes of the number insert. */
  void Change(unsigned growth)
  {
    const auto id = static_cast<std::uint32_t>(this->Random() % MostPoints);
    const bool isThere = this->Points.count(id) == 1;
    ASSERT_EQ(this->Tree.HasPoint(id), isThere);
    Position<Dim> x = this->MakePosition();
    const auto kind = this->Random() % 3;
    if (kind == 0)
    {
      if (isThere && this->Random() % 2 == 0)
      {
        x = this->Points[id];
        x[0] += 1e-4;
      }
      ASSERT_EQ(this->Tree.Move(id, x), isThere);
    }
    else if (this->Random() % 10 < growth)
    {
      ASSERT_EQ(this->Tree.Insert(id, x), !isThere);
      x = isThere ? this->Points[id] : x;
    }
    else
    {
      ASSERT_EQ(this->Tree.Erase(id), isThere);
      this->Points.erase(id);
      return;
    }
    if (isThere || kind != 0)
    {
      this->Points[id] = x;
    }
  }

  /** Holds the tree against an octree that is built over the same points. */
  void ExpectAsRebuilt() const
  {
    std::vector<std::uint32_t> ids;
    PointSample<Dim, double> sample;
    for (const auto& [id, x] : this->Points)
    {
      ids.push_back(id);
      for (const double coordinate : x)
      {
        sample.Coordinates.push_back(std::clamp(coordinate, 0.0, 1.0));
      }
    }
    const PointSelection<Dim> selection(sample.GetSpan(), GetUnitCube(), Execution());
    const Octree<Dim> rebuilt(sample.GetSpan(), selection, this->Tree.GetOptions(), Execution());

    LeafIds expected;
    ForEachLeaf(rebuilt,
      [&](const auto& leaf)
      {
        std::vector<std::uint32_t>& here = expected[leaf.NodeKey.GetValue()];
        for (PointIndex place = leaf.FirstPoint; place < leaf.LastPoint; ++place)
        {
          here.push_back(ids[rebuilt.GetPointIds()[place]]);
        }
        std::sort(here.begin(), here.end());
      });
    ASSERT_EQ(LeafWalk<Dim>(this->Tree).Leaves, expected);
    this->ExpectCountsOf(rebuilt);
    this->ExpectSearchesAsIn(rebuilt);
  }

  DynamicOctree<Dim> Tree;
  std::map<std::uint32_t, Position<Dim>> Points;
  std::mt19937 Random{ 191 };

private:
  void ExpectCountsOf(const Octree<Dim>& rebuilt) const
  {
    const DepthCounts& counts = rebuilt.GetDepthCounts();
    ASSERT_EQ(this->Tree.GetNumberOfPoints(), rebuilt.GetNumberOfPoints());
    ASSERT_EQ(this->Tree.GetNumberOfInternalNodes(), rebuilt.GetNumberOfInternalNodes());
    ASSERT_EQ(this->Tree.GetDeepestDepth(), rebuilt.GetDeepestDepth());
    ASSERT_EQ(this->Tree.GetDepthCounts().Leaves, counts.Leaves);
    ASSERT_EQ(this->Tree.GetDepthCounts().EmptyLeaves, counts.EmptyLeaves);
    ASSERT_EQ(this->Tree.GetDepthCounts().Points, counts.Points);
    for (const FrequencyModel model : AllModels)
    {
      ASSERT_EQ(
        this->Tree.GetStartDepth(model), GetMedianDepth(GetDepthHistogram(counts, model, Dim)));
    }
  }

  void ExpectSearchesAsIn(const Octree<Dim>& rebuilt) const
  {
    const DepthDecisionTree decisions(rebuilt.GetDepthCounts().Leaves);
    std::mt19937 random(192);
    for (int trial = 0; trial < 4; ++trial)
    {
      Position<Dim> x;
      for (double& coordinate : x)
      {
        coordinate = static_cast<double>(random() % 1000) / (trial % 2 == 0 ? 1000.0 : 3000.0);
      }
      const MortonKey<Dim> key = this->Tree.GetGrid().GetKey(x.data());
      for (int startDepth = 0; startDepth <= MortonKey<Dim>::MaxDepth; ++startDepth)
      {
        NodeCount count;
        const auto found = FindLeaf(this->Tree, key, startDepth, count, EmptyOctants::Missing);
        const auto expected = FindLeaf(rebuilt, key, startDepth, EmptyOctants::Missing);
        ASSERT_EQ(found.Key, expected.Key);
        ASSERT_EQ(found.Exists, expected.Exists);
        ASSERT_EQ(count.Nodes, CountExaminedNodes(rebuilt, key, startDepth));
      }
      NodeCount count;
      ASSERT_EQ(FindLeaf(this->Tree, key, decisions, count).Key, FindLeaf(rebuilt, key, 0).Key);
    }
  }
};
}

template <typename Dimension>
class TestDynamicOctree : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Random changes, with a rebuilt tree beside at times; the tree grows and shrinks in turns. */
  static void ExpectAsRebuilt(const typename Octree<Dim>::Options& options, int changes)
  {
    ChangingTree<Dim> changing(options);
    SCOPED_TRACE("seed 191, points per leaf " + std::to_string(options.MaxPointsPerLeaf) +
      ", depth " + std::to_string(options.MaxDepth));
    changing.ExpectAsRebuilt();
    for (int change = 1; change <= changes; ++change)
    {
      ASSERT_NO_FATAL_FAILURE(changing.Change(change / 7500 % 2 == 0 ? 8 : 1));
      if (change % 300 == 0 || change < 20)
      {
        ASSERT_NO_FATAL_FAILURE(changing.ExpectAsRebuilt()) << "after change " << change;
      }
    }
    for (std::uint32_t id = 0; id < ChangingTree<Dim>::MostPoints; ++id)
    {
      ASSERT_EQ(changing.Tree.Erase(id), changing.Points.erase(id) == 1);
    }
    changing.ExpectAsRebuilt();
  }
};
TYPED_TEST_SUITE(TestDynamicOctree, Dimensions);

TYPED_TEST(TestDynamicOctree, EqualsTheRebuiltTreeAfterRandomChanges)
{
  constexpr int deepest = MortonKey<TestFixture::Dim>::MaxDepth;
  TestFixture::ExpectAsRebuilt({ 1, deepest }, 100000);
  TestFixture::ExpectAsRebuilt({ 2, deepest }, 20000);
  TestFixture::ExpectAsRebuilt({ 5, deepest }, 20000);
}

TYPED_TEST(TestDynamicOctree, EqualsTheRebuiltTreeOfLittleDepth)
{
  for (const int maxDepth : { 0, 1, 4 })
  {
    TestFixture::ExpectAsRebuilt({ 2, maxDepth }, 5000);
  }
}

TYPED_TEST(TestDynamicOctree, StartsAsOneEmptyLeaf)
{
  constexpr int dim = TestFixture::Dim;
  const DynamicOctree<dim> tree{ Grid<dim>() };
  EXPECT_FALSE(tree.IsRootInternal());
  EXPECT_EQ(tree.GetNumberOfPoints(), 0U);
  EXPECT_EQ(tree.GetNumberOfInternalNodes(), 0U);
  EXPECT_EQ(tree.GetOptions().MaxPointsPerLeaf, 1U);
  EXPECT_FALSE(tree.HasPoint(0));
  const auto leaf =
    FindLeaf(tree, MortonKey<dim>::Root().GetFirstAtMaxDepth(), 5, EmptyOctants::Missing);
  EXPECT_EQ(leaf.Key, MortonKey<dim>::Root());
  EXPECT_FALSE(leaf.Exists);
}

TYPED_TEST(TestDynamicOctree, RefusesWhatIsNoPositionAndChangesNothing)
{
  constexpr int dim = TestFixture::Dim;
  ChangingTree<dim> changing({});
  for (int change = 0; change < 300; ++change)
  {
    changing.Change(9);
  }
  const std::uint32_t there = changing.Points.begin()->first;
  for (const double broken : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    Position<dim> x{};
    x.back() = broken;
    EXPECT_THROW(changing.Tree.Insert(1000, x), std::invalid_argument);
    EXPECT_THROW(changing.Tree.Move(there, x), std::invalid_argument);
  }
  EXPECT_THROW(
    changing.Tree.Insert(DynamicOctree<dim>::NoPoint, Position<dim>{}), std::invalid_argument);
  EXPECT_FALSE(changing.Tree.Erase(DynamicOctree<dim>::NoPoint));
  changing.ExpectAsRebuilt();
}

TYPED_TEST(TestDynamicOctree, ErasingOneOfAPairCollapsesTheWholeChain)
{
  constexpr int dim = TestFixture::Dim;
  constexpr int deepest = MortonKey<dim>::MaxDepth;
  DynamicOctree<dim> tree{ Grid<dim>(ChangingTree<dim>::GetUnitCube()) };
  tree.Insert(7, Position<dim>{});
  tree.Insert(8, Position<dim>{});
  EXPECT_EQ(tree.GetDeepestDepth(), deepest);
  EXPECT_EQ(tree.GetNumberOfInternalNodes(), static_cast<std::size_t>(deepest));
  const std::size_t bytes = tree.GetTreeBytes();
  EXPECT_GT(bytes, tree.GetTable().GetBytes());
  for (int again = 0; again < 1000; ++again)
  {
    tree.Erase(again % 2 == 0 ? 7 : 8);
    ASSERT_EQ(tree.GetDeepestDepth(), 0);
    ASSERT_FALSE(tree.IsRootInternal());
    tree.Insert(again % 2 == 0 ? 7 : 8, Position<dim>{});
  }
  EXPECT_EQ(tree.GetTreeBytes(), bytes) << "blocks are used again";
}

TYPED_TEST(TestDynamicOctree, MovesMakeRoomForMoreNodes)
{
  constexpr int dim = TestFixture::Dim;
  ChangingTree<dim> changing({});
  for (std::uint32_t id = 0; id < 100; ++id)
  {
    changing.Points[id].fill(id / 100.0);
    changing.Tree.Insert(id, changing.Points[id]);
  }
  for (std::uint32_t id = 0; id < 100; id += 2)
  {
    changing.Points[id] = changing.Points[id + 1];
    changing.Tree.Move(id, changing.Points[id]);
    ASSERT_LE(changing.Tree.GetTable().GetLoadFactor(), 0.5);
  }
  changing.ExpectAsRebuilt();
}

TYPED_TEST(TestDynamicOctree, ChangesDoNotBeginWhereMemoryIsOut)
{
  constexpr int dim = TestFixture::Dim;
  ChangingTree<dim> changing({});
  Position<dim> corner{};
  Position<dim> middle;
  middle.fill(0.5);
  changing.Points[0] = corner;
  changing.Tree.Insert(0, corner);
  /** A change that was refused must have left no trace. */
  const auto tryUntilDone = [&changing](const auto& change)
  { return TryUntilDone(change, [&changing] { changing.ExpectAsRebuilt(); }); };
  EXPECT_GT(tryUntilDone([&] { changing.Tree.Insert(1, corner); }), 1U);
  changing.Points[1] = corner;
  changing.ExpectAsRebuilt();
  EXPECT_GT(tryUntilDone([&] { changing.Tree.Move(1, middle); }), 0U);
  changing.Points[1] = middle;
  changing.ExpectAsRebuilt();
  EXPECT_GT(tryUntilDone([&] { changing.Tree.Erase(0); }), 0U);
  changing.Points.erase(0);
  changing.ExpectAsRebuilt();
}

TYPED_TEST(TestDynamicOctree, MovesDoNotBeginWhereMemoryIsOutForTheTable)
{
  constexpr int dim = TestFixture::Dim;
  ChangingTree<dim> changing({});
  const auto coordinates = MakeUniformPoints<dim, double>(1000, 83);
  std::uint32_t count = 0;
  const auto getNext = [&]
  {
    Position<dim> x;
    std::copy_n(coordinates.begin() + dim * count, dim, x.begin());
    return x;
  };
  const auto isFull = [&changing]
  {
    const auto& table = changing.Tree.GetTable();
    return !table.HasRoom(table.GetNumberOfKeys() + MortonKey<dim>::MaxDepth);
  };
  while (count < 10 || !isFull())
  {
    changing.Points[count] = getNext();
    changing.Tree.Insert(count, changing.Points[count]);
    ++count;
  }
  const Position<dim> far = getNext();
  EXPECT_GT(
    TryUntilDone([&] { changing.Tree.Move(0, far); }, [&] { changing.ExpectAsRebuilt(); }), 0U);
  EXPECT_FALSE(isFull());
  changing.Points[0] = far;
  changing.ExpectAsRebuilt();
}

TEST(TestDynamicOctreeFacts, ManyPointsAtOnePlaceCostNoMore)
{
  // Were lists walked, this would take minutes.
  DynamicOctree<3> tree{ Grid<3>() };
  constexpr std::uint32_t count = 200000;
  for (std::uint32_t id = 0; id < count; ++id)
  {
    tree.Insert(id, { 0.5, 0.5, 0.5 });
  }
  EXPECT_EQ(tree.GetDepthCounts().Points.back(), count);
  for (std::uint32_t id = 0; id + 1 < count; ++id)
  {
    tree.Erase(id);
  }
  EXPECT_EQ(tree.GetDepthCounts().Points, DepthHistogram{ 1 });
}

TEST(TestDynamicOctreeFacts, PositionsOutsideGoToTheNearestCell)
{
  DynamicOctree<2> tree(Grid<2>(Box<2>({ 1.0, 1.0 }, { 3.0, 3.0 })), { 1, 1 });
  tree.Insert(0, { -1e308, 2.5 });
  tree.Insert(1, { 1e308, -1e308 });
  std::vector<std::uint32_t> ids;
  for (const Position<2>& x : { Position<2>{ 1.0, 2.9 }, Position<2>{ 2.9, 1.0 } })
  {
    tree.ForEachPoint(FindLeaf(tree, tree.GetGrid().GetKey(x.data()), 0),
      [&ids](std::uint32_t id) { ids.push_back(id); });
  }
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{ 0, 1 }));
}
