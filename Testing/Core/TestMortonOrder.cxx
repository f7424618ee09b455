// SPDX-License-Identifier: BSD-3-Clause
#include "MortonOrder.h"

#include "Dimensions.h"
#include "OnThisThread.h"
#include "PointSamples.h"
#include "Threads.h"
#include "ToldProgress.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

using namespace hashedoctree;

template <typename Dimension>
class TestMortonOrder : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Point = KeyedPoint<Dim>;

  static Buffer<Point> MakePoints(const PointSample<Dim, double>& sample)
  {
    const PointSelection<Dim> selection(sample.GetSpan(), {}, Execution());
    return MakeKeyedPoints(sample.GetSpan(), selection, Grid<Dim>(selection.GetBox()), Execution());
  }

  struct Limits
  {
    std::size_t MaxPointsPerLeaf;
    int MaxDepth;
  };
  static constexpr Limits All{ 1, MortonKey<Dim>::MaxDepth };

  static bool AreSame(const Point& a, const Point& b)
  {
    return a.GetKey() == b.GetKey() && a.GetId() == b.GetId();
  }

  /** Stable. Sorts pairs, since with the thread sanitizer points take far longer to move. */
  static void SortByKey(Point* first, Point* last)
  {
    std::vector<std::pair<std::uint64_t, const Point*>> order;
    const std::vector<Point> points(first, last);
    order.reserve(points.size());
    for (const Point& point : points)
    {
      order.emplace_back(point.GetKey().GetValue(), &point);
    }
    std::sort(order.begin(), order.end());
    std::transform(
      order.begin(), order.end(), first, [](const auto& placed) { return *placed.second; });
  }

  struct Ordering
  {
    Execution On;
    Limits To;
  };

  /** Sorts the points of a sample in each of the ways. */
  static void ExpectSorted(
    const PointSample<Dim, double>& sample, const std::vector<Ordering>& orderings)
  {
    SCOPED_TRACE(sample.Name);
    const Buffer<Point> inOrderOfIds = MakePoints(sample);
    std::vector<Point> expected(
      inOrderOfIds.GetData(), inOrderOfIds.GetData() + inOrderOfIds.GetSize());
    SortByKey(expected.data(), expected.data() + expected.size());
    for (const Ordering& ordering : orderings)
    {
      Buffer<Point> points(inOrderOfIds.GetSize());
      std::copy_n(inOrderOfIds.GetData(), inOrderOfIds.GetSize(), points.GetData());
      SortAlongMortonCurve(points, ordering.To.MaxPointsPerLeaf, ordering.To.MaxDepth, ordering.On);
      ASSERT_EQ(points.GetSize(), expected.size());
      ExpectLeaves(points.GetData(), expected.data(), expected.size(), 0, ordering.To);
    }
  }

  /** Compares the points of a node with those in order, leaf by leaf. */
  static void ExpectLeaves(
    Point* points, const Point* expected, std::size_t count, int depth, const Limits& limits)
  {
    if (std::equal(points, points + count, expected, AreSame))
    {
      return;
    }
    if (count > limits.MaxPointsPerLeaf && depth < limits.MaxDepth)
    {
      while (count > 0)
      {
        const auto isInChild = [=](const Point& point)
        { return point.GetKey().AtDepth(depth + 1) == expected->GetKey().AtDepth(depth + 1); };
        const auto here = static_cast<std::size_t>(
          std::partition_point(expected, expected + count, isInChild) - expected);
        ExpectLeaves(points, expected, here, depth + 1, limits);
        points += here;
        expected += here;
        count -= here;
      }
      return;
    }
    // In a leaf only equal keys have an order, and this keeps it.
    SortByKey(points, points + count);
    const Point* different = std::mismatch(points, points + count, expected, AreSame).first;
    ASSERT_EQ(different, points + count) << "point " << different - points << " of a leaf";
  }
};
TYPED_TEST_SUITE(TestMortonOrder, Dimensions);

TYPED_TEST(TestMortonOrder, SortsTheSamples)
{
  constexpr int maxDepth = MortonKey<TestFixture::Dim>::MaxDepth;
  std::vector<typename TestFixture::Ordering> orderings{ { Execution(), TestFixture::All } };
  for (const std::size_t maxPointsPerLeaf : { 2U, 7U, 64U, 1000U })
  {
    for (const int depth : { 0, 1, 4, maxDepth })
    {
      orderings.push_back({ Execution(), { maxPointsPerLeaf, depth } });
    }
  }
  for (const auto& sample : MakePointSamples<TestFixture::Dim, double>())
  {
    TestFixture::ExpectSorted(sample, orderings);
  }
}

TYPED_TEST(TestMortonOrder, SortsManyPointsOnAnyThreads)
{
  constexpr int dim = TestFixture::Dim;
  constexpr std::size_t count = 150000; // Beyond what one thread sorts on its own.
  const PointSample<dim, double> uniform{ "uniform", MakeUniformPoints<dim, double>(count, 51) };
  const PointSample<dim, double> clusters{ "clusters",
    MakeClusteredPoints<dim, double>(count, 52) };
  // All but one point in the last digit's cells, far below the first node that holds them all.
  PointSample<dim, double> outlier{ "outlier", MakeUniformPoints<dim, double>(count, 53) };
  for (double& coordinate : outlier.Coordinates)
  {
    coordinate *= 1e-9;
  }
  outlier.Coordinates[0] = 1.0;
  const PointSample<dim, double> coincident{ "coincident", std::vector<double>(dim * count, 2.0) };
  // In few cells, which more depths part at once.
  PointSample<dim, double> diagonal{ "diagonal", MakeUniformPoints<dim, double>(count, 57) };
  for (std::size_t i = 0; i < count; ++i)
  {
    std::fill_n(&diagonal.Coordinates[dim * i], dim, diagonal.Coordinates[dim * i]);
  }
  std::vector<typename TestFixture::Ordering> orderings;
  for (const unsigned threads : { 1U, 2U, 8U })
  {
    orderings.push_back({ Execution(OnThreads(threads)), TestFixture::All });
    orderings.push_back({ Execution(OnThreads(threads)), { 64, 9 } });
  }
  for (const auto& sample : { uniform, clusters, outlier, coincident, diagonal })
  {
    TestFixture::ExpectSorted(sample, orderings);
  }
}

TYPED_TEST(TestMortonOrder, SpareMemoryChangesNothing)
{
  constexpr int dim = TestFixture::Dim;
  constexpr int maxDepth = MortonKey<dim>::MaxDepth;
  constexpr std::size_t count = 100000;
  const PointSample<dim, double> sample{ "clusters", MakeClusteredPoints<dim, double>(count, 55) };
  auto expected = TestFixture::MakePoints(sample);
  SortAlongMortonCurve(expected, 8, maxDepth, Execution());
  // Too little by one point, as much as is used, and more than that.
  for (const std::size_t room : { count - 1, count, count + 1000 })
  {
    const KeyedPoint<dim> untouched(MortonKey<dim>(), MaxNumberOfPoints);
    std::vector<KeyedPoint<dim>> spare(count + 1000, untouched);
    auto points = TestFixture::MakePoints(sample);
    SortAlongMortonCurve(
      points, 8, maxDepth, Execution(), { spare.data(), room * sizeof(untouched) });
    ASSERT_TRUE(std::equal(
      points.GetData(), points.GetData() + count, expected.GetData(), TestFixture::AreSame));
    ASSERT_EQ(TestFixture::AreSame(spare[1], untouched), room < count);
    const auto firstSpared = spare.begin() + static_cast<std::ptrdiff_t>(room < count ? 0 : count);
    EXPECT_TRUE(std::all_of(firstSpared, spare.end(),
      [&](const auto& point) { return TestFixture::AreSame(point, untouched); }));
  }
}

TYPED_TEST(TestMortonOrder, PointsInOrderAreLeftAsTheyAre)
{
  constexpr int dim = TestFixture::Dim;
  constexpr int maxDepth = MortonKey<dim>::MaxDepth;
  constexpr std::size_t count = 100000;
  auto expected = TestFixture::MakePoints({ "uniform", MakeUniformPoints<dim, double>(count, 57) });
  SortAlongMortonCurve(expected, 1, maxDepth, Execution());
  const KeyedPoint<dim> untouched(MortonKey<dim>(), MaxNumberOfPoints);
  // All in order, then all but two neighbours, beside the border between two chunks, too.
  for (const std::size_t swapped :
    { std::size_t(0), std::size_t(1), 16384 - std::size_t(1), std::size_t(16384), count - 1 })
  {
    Buffer<KeyedPoint<dim>> points(count);
    std::copy_n(expected.GetData(), count, points.GetData());
    std::swap(points[swapped], points[swapped == 0 ? 0 : swapped - 1]);
    std::vector<KeyedPoint<dim>> spare(count, untouched);
    ToldProgress told;
    SortAlongMortonCurve(
      points, 1, maxDepth, told.MakeExecution(), { spare.data(), count * sizeof(untouched) });
    EXPECT_TRUE(std::equal(
      points.GetData(), points.GetData() + count, expected.GetData(), TestFixture::AreSame));
    EXPECT_EQ(TestFixture::AreSame(spare[0], untouched), swapped == 0);
    told.ExpectToRise(2);
    EXPECT_EQ(told.GetFractions().back(), 1.0);
  }
}

TYPED_TEST(TestMortonOrder, CanBeInterrupted)
{
  constexpr int dim = TestFixture::Dim;
  auto points = TestFixture::MakePoints({ "uniform", MakeUniformPoints<dim, double>(300000, 54) });
  int answers = 0;
  const Execution execution(OnThisThread, [&answers](double) { return ++answers < 2; });
  EXPECT_THROW(SortAlongMortonCurve(points, 1, MortonKey<dim>::MaxDepth, execution), Interrupted);
}

TEST(TestMortonOrderOfClusters, LargeOnesAreNotSortedWithoutALook)
{
  constexpr std::size_t count = 300000;
  constexpr std::size_t clusters = 16; // Of which each would be a fair share for one thread.
  Buffer<KeyedPoint<3>> points(clusters * count);
  std::mt19937_64 random(56);
  const std::uint64_t root = MortonKey<3>::Root().GetFirstAtMaxDepth().GetValue();
  for (std::size_t i = 0; i < points.GetSize(); ++i)
  {
    const std::uint64_t key = root | (i % clusters) << 57U | random() >> 24U;
    points.GetData()[i] = KeyedPoint<3>(MortonKey<3>(key), static_cast<PointIndex>(i));
  }
  std::size_t reports = 0;
  const Execution execution(OnThisThread, [&reports](double) { return ++reports > 0; });
  SortAlongMortonCurve(points, 64, MortonKey<3>::MaxDepth, execution);
  EXPECT_GT(reports, 3 * clusters); // 28 when each is sorted by one thread.
}

TEST(TestMortonOrderOfManyPoints, SmallNodesAreNotAllSortedWithoutALook)
{
  // More than the tasks between two reports have, in nodes for one thread each.
  Buffer<KeyedPoint<3>> points(700000);
  std::mt19937_64 random(58);
  const std::uint64_t root = MortonKey<3>::Root().GetFirstAtMaxDepth().GetValue();
  for (std::size_t i = 0; i < points.GetSize(); ++i)
  {
    const MortonKey<3> key(root | random() >> 1U);
    points.GetData()[i] = KeyedPoint<3>(key, static_cast<PointIndex>(i));
  }
  ToldProgress told;
  SortAlongMortonCurve(points, 1, MortonKey<3>::MaxDepth, told.MakeExecution());
  told.ExpectToRise(3);
  const std::vector<double>& fractions = told.GetFractions();
  EXPECT_TRUE(std::any_of(fractions.begin(), fractions.end(),
    [](double fraction) { return 0.0 < fraction && fraction < 1.0; }));
}
