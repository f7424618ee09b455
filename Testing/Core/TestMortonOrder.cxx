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

  static Buffer<CodedPoint<Dim>> Encode(const PointSample<Dim, double>& sample)
  {
    const PointSelection<Dim> selection(sample.GetSpan(), {}, Execution());
    return EncodePoints(sample.GetSpan(), selection, Grid<Dim>(selection.GetBox()), Execution());
  }

  static void ExpectSorted(const PointSample<Dim, double>& sample, const Execution& execution)
  {
    SCOPED_TRACE(sample.Name);
    Buffer<CodedPoint<Dim>> points = Encode(sample);
    std::vector<CodedPoint<Dim>> expected(points.GetData(), points.GetData() + points.GetSize());
    std::stable_sort(
      expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.Key < b.Key; });
    SortAlongMortonCurve(points, execution);
    ASSERT_EQ(points.GetSize(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
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
    }
  }
}

TYPED_TEST(TestMortonOrder, CanBeInterrupted)
{
  constexpr int dim = TestFixture::Dim;
  auto points = TestFixture::Encode({ "uniform", MakeUniformPoints<dim, double>(300000, 54) });
  int answers = 0;
  const Execution execution(OnThreads(1), [&answers](double) { return ++answers < 2; });
  EXPECT_THROW(SortAlongMortonCurve(points, execution), Interrupted);
}
