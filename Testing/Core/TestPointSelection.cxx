// SPDX-License-Identifier: BSD-3-Clause
#include "PointSelection.h"

#include "Dimensions.h"
#include "PointIndex.h"
#include "PointSamples.h"
#include "Threads.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

using namespace hashedoctree;

template <typename Dimension>
class TestPointSelection : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestPointSelection, Dimensions);

TYPED_TEST(TestPointSelection, AgreesWithAPlainCount)
{
  constexpr int dim = TypeParam::value;
  for (const auto& sample : MakePointSamples<dim, float>())
  {
    SCOPED_TRACE(sample.Name);
    const auto points = sample.GetSpan();
    Box<dim> box;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      bool finite = true;
      for (int axis = 0; axis < dim; ++axis)
      {
        finite = finite && std::isfinite(points[i][axis]);
      }
      if (finite)
      {
        Position<dim> x;
        std::copy(points[i], points[i] + dim, x.begin());
        box.Add(Box<dim>(x, x));
        ++kept;
      }
    }
    const PointSelection<dim> selection(points, {}, Execution());
    EXPECT_EQ(selection.GetNumberOfPoints(), kept);
    EXPECT_EQ(selection.GetNumberOfSkippedPoints(), points.Count - kept);
    EXPECT_EQ(selection.GetNumberOfOutsidePoints(), 0U);
    EXPECT_EQ(selection.GetBox().Lower, box.Lower);
    EXPECT_EQ(selection.GetBox().Upper, box.Upper);
  }
}

TEST(TestPointSelectionFacts, FacesOfAGivenBoxAreInside)
{
  const std::vector<double> x{ 0.0, 1.0, 0.5, -1e-12, 1.0 + 1e-12, NAN, INFINITY };
  const PointSelection<1> selection(
    PointSpan<1, double>{ x.data(), x.size() }, Box<1>({ 0.0 }, { 1.0 }), Execution());
  EXPECT_EQ(selection.GetNumberOfPoints(), 3U);
  EXPECT_EQ(selection.GetNumberOfOutsidePoints(), 2U);
  EXPECT_EQ(selection.GetNumberOfSkippedPoints(), 2U);
  EXPECT_EQ(selection.GetBox().Lower[0], 0.0);
  EXPECT_EQ(selection.GetBox().Upper[0], 1.0);
  EXPECT_TRUE(selection.Keeps(&x[1]));
  EXPECT_FALSE(selection.Keeps(&x[3]));
  EXPECT_FALSE(selection.Keeps(&x[5]));
}

TYPED_TEST(TestPointSelection, GivenBoxesHoldAPartOfThePoints)
{
  constexpr int dim = TypeParam::value;
  // All of them finite.
  const PointSample<dim, float> sample{ "uniform", MakeUniformPoints<dim, float>(1000, 32) };
  Position<dim> lower{};
  Position<dim> upper;
  upper.fill(0.75);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < 1000; ++i)
  {
    const float* x = sample.GetSpan()[i];
    inside += std::all_of(x, x + dim, [](float c) { return c <= 0.75F; }) ? 1 : 0;
  }
  const PointSelection<dim> selection(
    sample.GetSpan(), Box<dim>(lower, upper), Execution(OnThreads(2)));
  EXPECT_EQ(selection.GetNumberOfPoints(), inside);
  EXPECT_EQ(selection.GetNumberOfOutsidePoints(), 1000 - inside);
  EXPECT_EQ(selection.GetBox().Lower, lower);
  EXPECT_EQ(selection.GetBox().Upper, upper);
}

TEST(TestPointSelectionFacts, HugeCoordinatesCountAsNotFinite)
{
  const double most = Grid<1>::MaxCoordinate;
  const std::vector<double> x{ most, -most, std::nextafter(most, INFINITY) };
  const PointSelection<1> selection(PointSpan<1, double>{ x.data(), x.size() }, {}, Execution());
  EXPECT_EQ(selection.GetNumberOfPoints(), 2U);
  EXPECT_EQ(selection.GetNumberOfSkippedPoints(), 1U);
}

TEST(TestPointSelectionFacts, BadBoxesAreRefused)
{
  const double x = 0.5;
  const PointSpan<1, double> points{ &x, 1 };
  const auto getProblem = [&points](double lower, double upper) -> std::string
  {
    try
    {
      PointSelection<1>(points, Box<1>({ lower }, { upper }), Execution());
    }
    catch (const std::invalid_argument& problem)
    {
      return problem.what();
    }
    return "";
  };
  EXPECT_EQ(
    getProblem(1.0, 0.0), "The given bounds are from 1 to 0 on axis x; give the lower one first.");
  for (const auto& [lower, upper] : { std::pair(NAN, 1.0F), { 0.0F, NAN }, { 0.0F, INFINITY } })
  {
    EXPECT_NE(
      getProblem(lower, upper).find("; give finite ones, not beyond 4.49"), std::string::npos)
      << getProblem(lower, upper);
  }
  EXPECT_EQ(getProblem(0.5, 0.5), "");
}

TEST(TestPointSelectionFacts, TooManyPointsAreRefused)
{
  const float x = 0.0F;
  const PointSpan<1, float> points{ &x, MaxNumberOfPoints + 1 };
  EXPECT_THROW(PointSelection<1>(points, {}, Execution()), std::length_error);
}

TEST(TestPointSelectionFacts, ThreadsDoNotMatter)
{
  constexpr std::size_t count = 5 * PointSelection<2>::ChunkSize + 1;
  PointSample<2, float> sample{ "", MakeUniformPoints<2, float>(count, 31) };
  sample.Coordinates[2 * PointSelection<2>::ChunkSize] = NAN;
  const PointSelection<2> one(sample.GetSpan(), {}, Execution());
  const PointSelection<2> eight(sample.GetSpan(), {}, Execution(OnThreads(8)));
  EXPECT_EQ(one.GetBox().Lower, eight.GetBox().Lower);
  EXPECT_EQ(one.GetBox().Upper, eight.GetBox().Upper);
  for (std::size_t chunk = 0; chunk <= 6; ++chunk)
  {
    EXPECT_EQ(one.GetFirstOfChunk(chunk), eight.GetFirstOfChunk(chunk));
  }
  EXPECT_EQ(one.GetFirstOfChunk(1), PointSelection<2>::ChunkSize);
  EXPECT_EQ(one.GetFirstOfChunk(2), 2 * PointSelection<2>::ChunkSize - 1);
}
