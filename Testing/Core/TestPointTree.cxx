// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include "Dimensions.h"
#include "MakePointTree.h"
#include "OnThisThread.h"
#include "PointSamples.h"
#include "SampleTree.h"
#include "ScarceMemory.h"
#include "SmallNumbersAreZero.h"
#include "Threads.h"
#include "ToldProgress.h"

#include <utility>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace hashedoctree;

template <typename Dimension>
class TestPointTree : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Tree = PointTree<Dim, float>;

  /** Coordinates and boxes of every child of a tree, against the points themselves. */
  static void ExpectSound(const PointSample<Dim, float>& sample, const Tree& tree)
  {
    const Octree<Dim>& octree = tree.GetOctree();
    if (!octree.IsRootInternal())
    {
      ExpectLeaf(sample, tree, 0, static_cast<PointIndex>(tree.GetNumberOfPoints()));
    }
    for (std::size_t block = 0; block < octree.GetNumberOfInternalNodes(); ++block)
    {
      ExpectFork(tree, block);
      for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
      {
        const auto child = octree.GetChild(block, octant);
        const Tree* nested = child.Internal ? nullptr : tree.FindNested(child.FirstPoint);
        if (nested != nullptr)
        {
          ExpectSound(sample, *nested);
        }
        else if (!child.Internal)
        {
          ExpectLeaf(sample, tree, child.FirstPoint, child.LastPoint);
        }
        if (!child.IsEmpty())
        {
          ExpectBox(sample, tree, block, octant);
        }
      }
    }
  }

  static void ExpectLeaf(const PointSample<Dim, float>& sample, const Tree& tree,
    PointIndex firstPoint, PointIndex lastPoint)
  {
    const std::size_t count = lastPoint - firstPoint;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t axis = 0; axis < Dim; ++axis)
      {
        ASSERT_EQ(tree.GetLeafCoordinates(firstPoint)[axis * count + i],
          sample.GetSpan()[tree.GetIds()[firstPoint + i]][axis]);
      }
    }
  }

  /** The fork of a block holds the block's points, and parts them; nothing between the two does. */
  static void ExpectFork(const Tree& tree, std::size_t block)
  {
    const Octree<Dim>& octree = tree.GetOctree();
    std::size_t fork = block;
    for (;;)
    {
      int occupied = 0;
      int internal = 0;
      std::size_t below = 0;
      for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
      {
        const auto child = octree.GetChild(fork, octant);
        occupied += child.IsEmpty() ? 0 : 1;
        internal += child.Internal ? 1 : 0;
        below = child.Internal ? octree.GetChildBlock(fork, octant) : below;
      }
      ASSERT_EQ(tree.IsLink(fork), occupied == 1 && internal == 1);
      if (occupied != 1 || internal != 1)
      {
        break;
      }
      fork = below;
    }
    ASSERT_EQ(tree.GetFork(block), fork);
  }

  /** The box of a child is the smallest one of whole steps that holds the cells of its points. */
  static void ExpectBox(
    const PointSample<Dim, float>& sample, const Tree& tree, std::size_t block, unsigned octant)
  {
    const Octree<Dim>& octree = tree.GetOctree();
    const MortonKey<Dim> parent = octree.GetBlockKey(block);
    const auto child = octree.GetChild(block, octant);
    const double width = std::ldexp(1.0, MortonKey<Dim>::MaxDepth - parent.GetDepth());
    const double step = width / ChildBoxes<Dim>::Steps;
    for (int axis = 0; axis < Dim; ++axis)
    {
      double lower = INFINITY;
      double upper = -INFINITY;
      for (PointIndex i = child.FirstPoint; i < child.LastPoint; ++i)
      {
        const double cell = octree.GetGrid().GetCell(sample.GetSpan()[tree.GetIds()[i]])[axis];
        lower = std::min(lower, cell - width * parent.GetCell()[axis]);
        upper = std::max(upper, cell + 1.0 - width * parent.GetCell()[axis]);
      }
      const ChildBoxes<Dim>& boxes = tree.GetChildBoxes(block);
      ASSERT_EQ(boxes.Lower[axis][octant], std::floor(lower / step));
      ASSERT_EQ(boxes.Upper[axis][octant] + 1, std::ceil(upper / step));
    }
  }
};
TYPED_TEST_SUITE(TestPointTree, Dimensions);

TYPED_TEST(TestPointTree, HoldsThePointsAndTheirBoxes)
{
  constexpr int dim = TestFixture::Dim;
  auto samples = MakePointSamples<dim, float>();
  samples.push_back({ "many", MakeClusteredPoints<dim, float>(20000, 141) });
  for (const auto& sample : samples)
  {
    for (const std::size_t maxPointsPerLeaf : { 1U, 8U })
    {
      SCOPED_TRACE(sample.Name);
      const PointSelection<dim> selection(sample.GetSpan(), {}, Execution());
      for (const unsigned threads : { 1U, 4U })
      {
        const PointTree<dim, float> tree(sample.GetSpan(), selection,
          { maxPointsPerLeaf, MortonKey<dim>::MaxDepth }, Execution(OnThreads(threads)));
        EXPECT_EQ(tree.GetNumberOfPoints(), selection.GetNumberOfPoints());
        TestFixture::ExpectSound(sample, tree);
      }
    }
  }
}

TYPED_TEST(TestPointTree, HoldsAllPointsHoweverTheyAreSharedOutToThreads)
{
  constexpr int dim = TestFixture::Dim;
  constexpr int deepest = MortonKey<dim>::MaxDepth;
  // Half of them in one corner: there are small and large subtrees, and leaves above them. In the
  // smaller corner they are all in one leaf, with a nested tree; fewer, but more than a task has.
  for (const auto& [corner, count] : { std::pair(1e-3, 50000U), std::pair(1e-12, 20000U) })
  {
    PointSample<dim, float> sample{ "halves", MakeUniformPoints<dim, float>(count, 142) };
    const auto dense = MakeUniformPoints<dim, float>(count, 143, 0.0, corner);
    sample.Coordinates.insert(sample.Coordinates.end(), dense.begin(), dense.end());
    const PointSelection<dim> selection(sample.GetSpan(), {}, Execution());
    // Small leaves; leaves of which few make a task; leaves larger than a task, at the last depth;
    // one leaf.
    for (const auto& options : { typename PointTree<dim, float>::Options{ 8, deepest },
           { 5000, deepest }, { 1, 1 }, { 8, 11 / dim }, { 100000, deepest } })
    {
      SCOPED_TRACE(std::to_string(corner) + ", " + std::to_string(options.MaxPointsPerLeaf) + ", " +
        std::to_string(options.MaxDepth));
      for (const unsigned threads : { 1U, 4U })
      {
        const PointTree<dim, float> tree(
          sample.GetSpan(), selection, options, Execution(OnThreads(threads)));
        TestFixture::ExpectSound(sample, tree);
      }
    }
  }
}

TEST(TestPointTreeFacts, TakesAtMost32BytesPerPoint)
{
  // Beside the input: floats, in leaves of 64 as the locator has them. The last is a tree in a
  // leaf.
  std::vector<float> spot = MakeUniformPoints<3, float>(100000, 145, 0.0, 1e-9);
  spot[0] = 1.0F;
  for (const auto& coordinates :
    { MakeUniformPoints<3, float>(100000, 142), MakeSpherePoints<3, float>(100000, 143),
      MakeClusteredPoints<3, float>(100000, 144), spot })
  {
    const PointSpan<3, float> points{ coordinates.data(), 100000 };
    const auto tree = MakePointTree(points, 64);
    // With 64-bit ids there are two of them for each point in the spot, and larger blocks.
    const std::size_t most = sizeof(PointIndex) == 4 ? 32 : 44;
    EXPECT_LE(tree.GetBytes(), most * tree.GetNumberOfPoints());
  }
}

/** Every leaf at the last depth with too many points has a nested tree, unless they
 * are all at one place; the trees hold the ids of the leaf. Returns the number of nested trees. */
template <typename Real>
int ExpectNested(const PointSpan<3, Real>& points, const PointTree<3, Real>& tree)
{
  int count = 0;
  ForEachNode(tree.GetOctree(),
    [&](const auto& node)
    {
      // (Empty leaves begin where the next one does.)
      const bool isFull = !node.Internal && !node.IsEmpty();
      const auto* nested = isFull ? tree.FindNested(node.FirstPoint) : nullptr;
      const PointIndex* ids = tree.GetIds() + node.FirstPoint;
      const bool isAtOnePlace = std::all_of(ids, ids + node.GetNumberOfPoints(),
        [&](PointIndex id) { return std::equal(points[id], points[id] + 3, points[ids[0]]); });
      const bool isLarge = node.GetNumberOfPoints() > tree.GetMostAtLastDepth();
      ASSERT_EQ(nested != nullptr, isFull && isLarge && !isAtOnePlace);
      if (nested != nullptr)
      {
        std::vector<PointIndex> nestedIds(
          nested->GetIds(), nested->GetIds() + nested->GetNumberOfPoints());
        std::sort(nestedIds.begin(), nestedIds.end());
        ASSERT_EQ(nestedIds, std::vector<PointIndex>(ids, ids + node.GetNumberOfPoints()));
        count += 1 + ExpectNested(points, *nested);
      }
    });
  return count;
}

TEST(TestPointTreeFacts, LeavesAtTheLastDepthHaveTreesOfTheirOwn)
{
  // Dense spots inside dense spots, each far smaller than a cell of the last depth around it, and
  // points at one place.
  std::vector<double> coordinates{ 1.0, 1.0, 1.0 };
  for (const double size : { 1e-8, 1e-16, 1e-24 })
  {
    const auto spot = MakeUniformPoints<3, double>(200, 146, 0.0, size);
    coordinates.insert(coordinates.end(), spot.begin(), spot.end());
  }
  coordinates.insert(coordinates.end(), std::size_t(3) * 50, 0.5);
  const PointSpan<3, double> points{ coordinates.data(), coordinates.size() / 3 };
  const auto tree = MakePointTree(points, 8);
  EXPECT_EQ(ExpectNested(points, tree), 3);
  EXPECT_GT(tree.GetBytes(),
    tree.FindNested(0)->GetBytes() + tree.GetOctree().GetTreeBytes() +
      tree.GetOctree().GetOrderBytes() + coordinates.size() * sizeof(double));

  // Where less depth is asked for, leaves are as large as they get.
  EXPECT_EQ(MakePointTree(points, 8, 20).FindNested(0), nullptr);
}

TEST(TestPointTreeFacts, LeavesAtTheLastDepthHoldFourTimesAsManyPointsWithoutATree)
{
  for (const auto& [maxPointsPerLeaf, most] :
    { std::pair<std::size_t, std::size_t>{ 1, 32 }, { 8, 32 }, { 9, 36 }, { 64, 256 } })
  {
    for (const std::size_t count : { most, most + 1 })
    {
      std::vector<double> coordinates = MakeUniformPoints<3, double>(count, 151, 0.0, 1e-8);
      coordinates.insert(coordinates.end(), 3, 1.0);
      const PointSpan<3, double> points{ coordinates.data(), count + 1 };
      const auto tree = MakePointTree(points, maxPointsPerLeaf);
      EXPECT_EQ(tree.FindNested(0) != nullptr, count > most) << maxPointsPerLeaf << " per leaf";
    }
  }
}

#if defined(__SSE2__) // Elsewhere the mode is set in other ways.
TEST(TestPointTreeFacts, NestedTreesEndWhereDifferencesAreFlushedToZero)
{
  std::vector<double> coordinates = MakeUniformPoints<3, double>(300, 150, 0.0, 1e-310);
  coordinates.insert(coordinates.end(), 3, 1.0);
  const PointSpan<3, double> points{ coordinates.data(), 301 };
  const unsigned mode = _MM_GET_FLUSH_ZERO_MODE();
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  const auto tree = MakePointTree(points, 8);
  _MM_SET_FLUSH_ZERO_MODE(mode);
  EXPECT_EQ(tree.GetNumberOfPoints(), 301U);
  EXPECT_EQ(tree.FindNested(0), nullptr);
}

TEST(TestPointTreeFacts, FloatsArePartedByWhatTheyDifferByInDouble)
{
  // All are floats that no processor takes for zero, but for their differences.
  std::vector<float> coordinates{ -1e-29F, -1e-29F, -1e-29F, 1e-29F, 1e-29F, 1e-29F };
  for (int i = 0; i < 40; ++i)
  {
    const float x = 1e-36F * (1.0F + 1e-4F * static_cast<float>(i));
    coordinates.insert(coordinates.end(), { x, 1e-36F, 1e-36F });
  }
  const PointSpan<3, float> points{ coordinates.data(), 42 };
  const SmallNumbersAreZero mode;
  const auto tree = MakePointTree(points, 8);
  EXPECT_NE(tree.FindNested(1), nullptr);
}
#endif

/** Of many points near each other, whose leaf has a tree, and one far away. */
PointTree<3, float> MakeTreeWithNested()
{
  std::vector<float> coordinates = MakeUniformPoints<3, float>(2000, 147, 0.0, 1e-9);
  coordinates.insert(coordinates.end(), 3, 1.0F);
  return MakePointTree(PointSpan<3, float>{ coordinates.data(), 2001 }, 8);
}

TEST(TestPointTreeFacts, NestedTreesStartWhereTheModelSays)
{
  PointTree<3, float> tree = MakeTreeWithNested();
  const StartDepths<3>& starts = tree.FindNested(0)->GetStartDepths();
  EXPECT_GT(starts.GetOfTree(), 1);
  EXPECT_LT(starts.GetOfTree(), tree.GetStartDepths().GetOfTree());
  tree.SetStartDepths({ StartDepthModel::Fixed, FrequencyModel::Leaves, 17 });
  EXPECT_EQ(starts.GetOfTree(), 17);
  EXPECT_EQ(tree.GetStartDepths().GetOfTree(), 17);
  // Those of all nested trees together would outgrow the points.
  const std::size_t bytes = tree.GetBytes();
  tree.SetStartDepths({ StartDepthModel::Local, FrequencyModel::Leaves, 0 });
  EXPECT_EQ(starts.GetBytes(), 0U);
  EXPECT_GT(starts.GetOfTree(), 1);
  EXPECT_EQ(tree.GetBytes(), bytes + 4096);
}

TEST(TestPointTreeFacts, StartDepthsStayWhereMemoryIsOut)
{
  PointTree<3, float> tree = MakeTreeWithNested();
  ASSERT_NE(tree.FindNested(0), nullptr);
  const int before = tree.GetStartDepths().GetOfTree();
  const std::size_t failures = TryUntilDone(
    [&tree] {
      tree.SetStartDepths({ StartDepthModel::Root, FrequencyModel::Leaves, 0 });
    },
    [&tree, before] { EXPECT_EQ(tree.GetStartDepths().GetOfTree(), before); });
  EXPECT_GT(failures, 1U);
  EXPECT_EQ(tree.GetStartDepths().GetOfTree(), 0);
}

TEST(TestPointTreeFacts, LeavesMayHoldAnyNumberOfPoints)
{
  const std::size_t most = std::size_t(1) << 62; // Four times as many are no number.
  const auto coordinates = MakeUniformPoints<3, float>(1000, 148);
  const PointSpan<3, float> points{ coordinates.data(), 1000 };
  const auto tree = MakePointTree(points, most);
  EXPECT_GE(tree.GetMostAtLastDepth(), most);
}

TEST(TestPointTreeFacts, ProgressRisesFromOneNestedTreeToTheNext)
{
  std::vector<double> coordinates{ 1.0, 1.0, 1.0 };
  for (const double corner : { 0.0, 0.5 })
  {
    const auto spot = MakeUniformPoints<3, double>(60000, 149, corner, corner + 1e-9);
    coordinates.insert(coordinates.end(), spot.begin(), spot.end());
  }
  const PointSpan<3, double> points{ coordinates.data(), coordinates.size() / 3 };
  ToldProgress told;
  const PointTree<3, double> tree(
    points, PointSelection<3>(points, {}, Execution()), { 16, 21 }, told.MakeExecution());
  EXPECT_EQ(ExpectNested(points, tree), 2);
  told.ExpectToRise(10);
}

TEST(TestPointTreeFacts, ProgressRisesInALargeLeafWithATree)
{
  // Its points are more than the 524288 between two reports. Others are told of before.
  std::vector<float> coordinates = MakeUniformPoints<3, float>(600000, 152, 0.0, 1e-9);
  const auto others = MakeUniformPoints<3, float>(10000, 153);
  coordinates.insert(coordinates.end(), others.begin(), others.end());
  const PointSpan<3, float> points{ coordinates.data(), 610000 };
  ToldProgress told;
  const PointTree<3, float> tree(
    points, PointSelection<3>(points, {}, Execution()), { 1000, 21 }, told.MakeExecution());
  EXPECT_NE(tree.FindNested(0), nullptr);
  told.ExpectToRise(10);
}

TEST(TestPointTreeFacts, CanBeInterrupted)
{
  const auto coordinates = MakeUniformPoints<3, float>(50000, 145);
  const PointSpan<3, float> points{ coordinates.data(), 50000 };
  const PointSelection<3> selection(points, {}, Execution());
  for (const double stop : { 0.0, 0.3, 0.7, 0.9 })
  {
    const Execution execution(OnThisThread, [stop](double fraction) { return fraction < stop; });
    EXPECT_THROW((PointTree<3, float>(points, selection, { 8, 21 }, execution)), Interrupted);
  }
}
