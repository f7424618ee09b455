// SPDX-License-Identifier: BSD-3-Clause
#include "MortonOrder.h"

#include "Dimensions.h"
#include "PointSamples.h"
#include "Threads.h"

#include <algorithm>

using namespace hashedoctree;

template <typename Dimension>
class TestMortonOrder : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Point = CodedPoint<Dim>;

  static Buffer<Point> Encode(const PointSample<Dim, double>& sample)
  {
    const PointSelection<Dim> selection(sample.GetSpan(), {}, Execution());
    return EncodePoints(sample.GetSpan(), selection, Grid<Dim>(selection.GetBox()), Execution());
  }

  struct Limits
  {
    std::size_t MaxPointsPerLeaf;
    int MaxDepth;
  };
  static constexpr Limits All{ 1, MortonKey<Dim>::MaxDepth };

  static void SortByKey(Point* first, Point* last)
  {
    std::stable_sort(first, last, [](const Point& a, const Point& b) { return a.Key < b.Key; });
  }

  static void ExpectSorted(
    const PointSample<Dim, double>& sample, const Execution& execution, const Limits& limits = All)
  {
    SCOPED_TRACE(sample.Name);
    Buffer<Point> points = Encode(sample);
    std::vector<Point> expected(points.GetData(), points.GetData() + points.GetSize());
    SortByKey(expected.data(), expected.data() + expected.size());
    SortAlongMortonCurve(points, limits.MaxPointsPerLeaf, limits.MaxDepth, execution);
    ASSERT_EQ(points.GetSize(), expected.size());
    ExpectLeaves(points.GetData(), expected.data(), expected.size(), 0, limits);
  }

  /** Compares the points of a node with those in order, leaf by leaf. */
  static void ExpectLeaves(
    Point* points, const Point* expected, std::size_t count, int depth, const Limits& limits)
  {
    if (count > limits.MaxPointsPerLeaf && depth < limits.MaxDepth)
    {
      while (count > 0)
      {
        const auto isInChild = [=](const Point& point)
        { return point.Key.AtDepth(depth + 1) == expected->Key.AtDepth(depth + 1); };
        const auto here = static_cast<std::size_t>(
          std::find_if_not(expected, expected + count, isInChild) - expected);
        ExpectLeaves(points, expected, here, depth + 1, limits);
        points += here;
        expected += here;
        count -= here;
      }
      return;
    }
    // In a leaf only equal keys have an order, and this keeps it.
    SortByKey(points, points + count);
    for (std::size_t i = 0; i < count; ++i)
    {
      ASSERT_EQ(points[i].Key, expected[i].Key) << i;
      ASSERT_EQ(points[i].Id, expected[i].Id) << i;
    }
  }
};
TYPED_TEST_SUITE(TestMortonOrder, Dimensions);

TYPED_TEST(TestMortonOrder, SortsTheSamples)
{
  for (const auto& sample : MakePointSamples<TestFixture::Dim, double>())
  {
    TestFixture::ExpectSorted(sample, Execution());
  }
}

TYPED_TEST(TestMortonOrder, SortsTheSamplesIntoLeaves)
{
  constexpr int maxDepth = MortonKey<TestFixture::Dim>::MaxDepth;
  for (const auto& sample : MakePointSamples<TestFixture::Dim, double>())
  {
    for (const std::size_t bucket : { 2U, 7U, 64U, 1000U })
    {
      for (const int depth : { 0, 1, 4, maxDepth })
      {
        TestFixture::ExpectSorted(sample, Execution(), { bucket, depth });
      }
    }
  }
}

TYPED_TEST(TestMortonOrder, SortsManyPointsOnAnyThreads)
{
  constexpr int dim = TestFixture::Dim;
  constexpr std::size_t count = 300000; // Beyond what one thread sorts on its own.
  const PointSample<dim, double> uniform{ "uniform", MakeUniformPoints<dim, double>(count, 51) };
  const PointSample<dim, double> clusters{ "clusters",
    MakeClusteredPoints<dim, double>(count, 52) };
  // All but one point in the last digit's cells, so that every digit is looked at.
  PointSample<dim, double> outlier{ "outlier", MakeUniformPoints<dim, double>(count, 53) };
  for (double& coordinate : outlier.Coordinates)
  {
    coordinate *= 1e-9;
  }
  outlier.Coordinates[0] = 1.0;
  const PointSample<dim, double> coincident{ "coincident", std::vector<double>(dim * count, 2.0) };
  for (const unsigned threads : { 1U, 2U, 8U })
  {
    for (const auto& sample : { uniform, clusters, outlier, coincident })
    {
      TestFixture::ExpectSorted(sample, Execution(OnThreads(threads)));
      TestFixture::ExpectSorted(sample, Execution(OnThreads(threads)), { 64, 9 });
    }
  }
}

TYPED_TEST(TestMortonOrder, CanBeInterrupted)
{
  constexpr int dim = TestFixture::Dim;
  auto points = TestFixture::Encode({ "uniform", MakeUniformPoints<dim, double>(300000, 54) });
  int answers = 0;
  const Execution execution(OnThreads(1), [&answers](double) { return ++answers < 2; });
  EXPECT_THROW(SortAlongMortonCurve(points, 1, MortonKey<dim>::MaxDepth, execution), Interrupted);
}
