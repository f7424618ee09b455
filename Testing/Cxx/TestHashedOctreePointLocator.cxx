// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "Sanitized.h"
#include "TestedLocator.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStructuredGrid.h"

#include <cmath>
#include <random>

namespace
{
using Position = TestedLocator::Position;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/** Positions on, near and between points, in the box, on its corners, beside it, and far away; and
 * some that are none. */
template <typename Real>
std::vector<Position> MakeQueries(const PointSample<3, Real>& sample, std::size_t count)
{
  const auto span = sample.GetSpan();
  const hashedoctree::Box<3> box = BruteForceSearch<3, Real>(span).GetBox();
  const bool isEmpty = box.Lower[0] > box.Upper[0];
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Position middle{};
  double side = 1.0;
  for (std::size_t axis = 0; axis < 3 && !isEmpty; ++axis)
  {
    middle[axis] = box.Lower[axis] + (box.Upper[axis] - box.Lower[axis]) / 2;
    side = axis == 0 ? 0.0 : side;
    side = std::max(side, box.Upper[axis] - box.Lower[axis]);
  }
  side = side > 0.0 ? side : 1.0;

  std::vector<Position> queries{ middle };
  const auto addAround = [&](const Position& x, double distance)
  {
    Position query = x;
    for (double& coordinate : query)
    {
      coordinate += distance * uniform(random);
    }
    queries.push_back(query);
  };
  for (std::size_t i = 0; i < span.Count; i += 1 + span.Count / count)
  {
    const Real* p = span[i];
    const Real* q = span[(i * 7 + 3) % span.Count];
    const Position x{ static_cast<double>(p[0]), static_cast<double>(p[1]),
      static_cast<double>(p[2]) };
    queries.push_back(x);
    addAround(x, 1e-2 * side);
    addAround(x, 1e-6 * side);
    queries.push_back({ (x[0] + static_cast<double>(q[0])) / 2,
      (x[1] + static_cast<double>(q[1])) / 2, (x[2] + static_cast<double>(q[2])) / 2 });
  }
  if (!isEmpty)
  {
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      queries.push_back({ (corner & 1U) != 0 ? box.Upper[0] : box.Lower[0],
        (corner & 2U) != 0 ? box.Upper[1] : box.Lower[1],
        (corner & 4U) != 0 ? box.Upper[2] : box.Lower[2] });
    }
  }
  for (const double widths : { 0.5, 0.5, 1.5, 10.0, 1e3, 1e6, 1e6 })
  {
    addAround(middle, widths * side);
  }
  queries.push_back({ middle[0] + 1e6 * side, middle[1], middle[2] });
  queries.push_back({ middle[0], middle[1] - 1e6 * side, box.Upper[2] });
  queries.push_back({ NotANumber, middle[1], middle[2] });
  queries.push_back({ middle[0], Infinity, middle[2] });
  queries.push_back({ middle[0], middle[1], -Infinity });
  return queries;
}

/** None, those that end at a point or just before it, and larger ones. */
std::vector<double> MakeRadii(const std::vector<OracleFound>& all)
{
  std::vector<double> radii{ 0.0, -1.0, NotANumber, Infinity };
  for (const std::size_t i : { std::size_t(0), all.size() / 20 })
  {
    if (i < all.size())
    {
      const double radius = std::sqrt(all[i].Dist2);
      radii.insert(
        radii.end(), { radius, std::nextafter(radius, 0.0), std::nextafter(radius, Infinity) });
    }
  }
  if (!all.empty())
  {
    radii.push_back(std::sqrt(all[all.size() / 2].Dist2));
  }
  return radii;
}

/** Every property that changes where a search starts; none may change an answer. With a sanitizer
 * every seventh depth from `first` on, so that all have their turn in seven queries. */
void ExpectAnswersFromAllStartDepths(
  TestedLocator& locator, const Position& x, const std::vector<OracleFound>& all, int first)
{
  using Class = vtkHashedOctreePointLocator;
  const std::vector<double> radii = MakeRadii(all);
  for (const int model : { Class::Median, Class::Mean, Class::Root, Class::Local })
  {
    for (const int frequency : { Class::Leaves, Class::Points, Class::Grid })
    {
      locator->SetStartDepthModel(model);
      locator->SetFrequencyModel(frequency);
      ASSERT_NO_FATAL_FAILURE(locator.ExpectAnswers(x, all, radii))
        << "models " << model << " " << frequency;
    }
  }
  locator->SetStartDepthModel(Class::Fixed);
  constexpr int step = Sanitized ? 7 : 1;
  for (int depth = first % step; depth <= 21; depth += step)
  {
    locator->SetFixedStartDepth(depth);
    ASSERT_EQ(locator->GetStartDepth(), depth);
    ASSERT_NO_FATAL_FAILURE(locator.ExpectAnswers(x, all, radii)) << "start depth " << depth;
  }
}

template <typename Real>
void ExpectAnswersOfSample(
  const PointSample<3, Real>& sample, std::size_t numberOfQueries, int maxPointsPerLeaf)
{
  SCOPED_TRACE(sample.Name + ", " + std::to_string(maxPointsPerLeaf) + " points per leaf");
  const BruteForceSearch<3, Real> oracle(sample.GetSpan());
  TestedLocator locator(MakePolyData(sample.Coordinates));
  locator->SetMaxPointsPerLeaf(maxPointsPerLeaf);
  locator->BuildLocator();
  locator.Warnings.clear(); // Told of in another test.
  int query = 0;
  for (const Position& x : MakeQueries(sample, numberOfQueries))
  {
    SCOPED_TRACE(::testing::PrintToString(x));
    const std::vector<OracleFound> all = oracle.FindAll(x);
    ASSERT_NO_FATAL_FAILURE(ExpectAnswersFromAllStartDepths(locator, x, all, query++));
    ASSERT_EQ(locator.FindClosest(VTK_INT_MAX, x), GetIds(all, all.size()));
  }
}
}

template <typename Real>
class TestHashedOctreePointLocator : public ::testing::Test
{
};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TestHashedOctreePointLocator, Reals);

TYPED_TEST(TestHashedOctreePointLocator, AnswersAsTheOracleOnTheStandingSamples)
{
  for (const auto& sample : MakePointSamples<3, TypeParam>())
  {
    ExpectAnswersOfSample(sample, Sanitized ? 1 : 4, 1);
    ExpectAnswersOfSample(sample, Sanitized ? 1 : 2, 16);
  }
}

TYPED_TEST(TestHashedOctreePointLocator, BoxesHoldWhatTheOracleFindsInThem)
{
  for (const auto& sample : MakePointSamples<3, TypeParam>())
  {
    SCOPED_TRACE(sample.Name);
    const BruteForceSearch<3, TypeParam> oracle(sample.GetSpan());
    TestedLocator locator(MakePolyData(sample.Coordinates));
    locator->SetMaxPointsPerLeaf(2);
    locator->BuildLocator();
    locator.Warnings.clear(); // Told of in another test.
    const std::vector<Position> corners = MakeQueries(sample, 3);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      ASSERT_NO_FATAL_FAILURE(
        locator.ExpectBoxes(oracle, corners[i], corners[(i * 5 + 2) % corners.size()]));
    }
  }
}

TYPED_TEST(TestHashedOctreePointLocator, AnswersAsTheOracleFarFromTheOrigin)
{
  std::vector<TypeParam> offset = MakeUniformPoints<3, TypeParam>(800, 11);
  std::vector<TypeParam> tiny = MakeClusteredPoints<3, TypeParam>(600, 12);
  for (TypeParam& x : offset)
  {
    x = static_cast<TypeParam>(x + 1e6);
  }
  for (TypeParam& x : tiny)
  {
    x = static_cast<TypeParam>(x * 1e-3 - 1e6);
  }
  ExpectAnswersOfSample(PointSample<3, TypeParam>{ "unit cube at 1e6", offset }, 4, 8);
  ExpectAnswersOfSample(PointSample<3, TypeParam>{ "clusters at -1e6", tiny }, 4, 8);
}

TYPED_TEST(TestHashedOctreePointLocator, AnswersAsTheOracleBesideAnOutlier)
{
  std::vector<TypeParam> outlier = MakeUniformPoints<3, TypeParam>(2000, 13, 0.0, 1e-9);
  outlier.insert(outlier.end(), 3, TypeParam(1));
  ExpectAnswersOfSample(PointSample<3, TypeParam>{ "outlier", outlier }, Sanitized ? 1 : 3, 16);
}

TYPED_TEST(TestHashedOctreePointLocator, AnswersAsTheOracleOnManyRandomPoints)
{
  const std::size_t count = Sanitized ? 2000 : 20000;
  for (const auto& sample :
    { PointSample<3, TypeParam>{ "uniform", MakeUniformPoints<3, TypeParam>(count, 14) },
      PointSample<3, TypeParam>{ "sphere", MakeSpherePoints<3, TypeParam>(count, 15) },
      PointSample<3, TypeParam>{ "clusters", MakeClusteredPoints<3, TypeParam>(count, 16) } })
  {
    SCOPED_TRACE(sample.Name);
    const BruteForceSearch<3, TypeParam> oracle(sample.GetSpan());
    TestedLocator locator(MakePolyData(sample.Coordinates));
    for (const Position& x : MakeQueries(sample, Sanitized ? 5 : 30))
    {
      const auto all = oracle.FindAll(x);
      ASSERT_EQ(locator->FindClosestPoint(x.data()), all.empty() ? -1 : all[0].Id);
      for (const int n : { 1, 8, 32, 500 })
      {
        ASSERT_EQ(locator.FindClosest(n, x), GetIds(all, static_cast<std::size_t>(n)));
      }
      for (const double radius : MakeRadii(all))
      {
        auto ids = GetIds(all, CountWithin(all, radius));
        std::sort(ids.begin(), ids.end());
        ASSERT_EQ(locator.FindWithin(radius, x), ids);
      }
    }
  }
}

TEST(TestHashedOctreePointLocatorTies, TheSmallestIdWins)
{
  // Corners of a cube, in an order that no walk through a tree has.
  const std::vector<unsigned> corners{ 5, 3, 0, 6, 7, 1, 4, 2, 5, 3, 0, 6, 7, 1, 4, 2 };
  std::vector<float> coordinates;
  for (const unsigned corner : corners)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      coordinates.push_back((corner >> axis & 1U) != 0 ? 1.0F : -1.0F);
    }
  }
  TestedLocator locator(MakePolyData(coordinates));
  for (const int maxPointsPerLeaf : { 1, 2, 16 })
  {
    locator->SetMaxPointsPerLeaf(maxPointsPerLeaf);
    EXPECT_EQ(locator->FindClosestPoint(0, 0, 0), 0);
    EXPECT_EQ(locator.FindClosest(5, { 0, 0, 0 }), (TestedLocator::Ids{ 0, 1, 2, 3, 4 }));
    EXPECT_EQ(locator.FindClosest(3, { -1, -1, -1 }), (TestedLocator::Ids{ 2, 10, 5 }));
    double dist2 = 0.0;
    const double center[3] = { 0, 0, 0 };
    EXPECT_EQ(locator->FindClosestPointWithinRadius(2.0, center, dist2), 0);
    EXPECT_EQ(dist2, 3.0);
  }
}

TEST(TestHashedOctreePointLocatorForms, CoordinatesMayBeGivenOneByOne)
{
  TestedLocator locator(MakePolyData<double>({ 0, 0, 0, 1, 0, 0, 0, 3, 0 }));
  vtkNew<vtkIdList> ids;
  EXPECT_EQ(locator->FindClosestPoint(0.9, 0, 0), 1);
  locator->FindClosestNPoints(2, 0.9, 0, 0, ids);
  EXPECT_EQ(TestedLocator::Ids(ids->begin(), ids->end()), (TestedLocator::Ids{ 1, 0 }));
  locator->FindPointsWithinRadius(0.1, 0, 3, 0, ids);
  EXPECT_EQ(TestedLocator::Ids(ids->begin(), ids->end()), TestedLocator::Ids{ 2 });
}

/** The answers on a data set must be those on its points. */
class TestHashedOctreePointLocatorDataSets : public ::testing::Test
{
protected:
  void ExpectAnswersOn(vtkDataSet* dataSet)
  {
    PointSample<3, double> sample;
    for (vtkIdType i = 0; i < dataSet->GetNumberOfPoints(); ++i)
    {
      const double* x = dataSet->GetPoint(i);
      sample.Coordinates.insert(sample.Coordinates.end(), x, x + 3);
    }
    const BruteForceSearch<3, double> oracle(sample.GetSpan());
    TestedLocator locator(dataSet);
    ASSERT_GT(dataSet->GetNumberOfPoints(), 0);
    for (const Position& x : MakeQueries(sample, 5))
    {
      const auto all = oracle.FindAll(x);
      ASSERT_NO_FATAL_FAILURE(locator.ExpectAnswers(x, all, MakeRadii(all)));
    }
  }
};

TEST_F(TestHashedOctreePointLocatorDataSets, ImageDataHasImplicitPoints)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(-2, 5, 3, 9, 0, 11);
  image->SetOrigin(0.1, -7.0, 1e3);
  image->SetSpacing(0.3, 1.7, 1e-3);
  ExpectAnswersOn(image);
}

TEST_F(TestHashedOctreePointLocatorDataSets, RectilinearGridHasImplicitPoints)
{
  vtkNew<vtkRectilinearGrid> grid;
  vtkNew<vtkDoubleArray> coordinates;
  for (const double x : { -1.0, 0.0, 0.1, 0.11, 5.0 })
  {
    coordinates->InsertNextValue(x);
  }
  grid->SetDimensions(5, 5, 5);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  ExpectAnswersOn(grid);
}

TEST_F(TestHashedOctreePointLocatorDataSets, PointsMayBeOfAnyTypeAndLayout)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(4, 4, 4);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_INT);
  vtkNew<vtkSOADataArrayTemplate<double>> columns;
  columns->SetNumberOfComponents(3);
  for (int i = 0; i < 64; ++i)
  {
    const int x[3] = { i % 4, 7 * (i / 4 % 4), -(i / 16) };
    points->InsertNextPoint(x[0], x[1], x[2]);
    columns->InsertNextTuple3(std::sin(i), std::cos(2.0 * i), 1e-3 * i);
  }
  grid->SetPoints(points);
  ExpectAnswersOn(grid);
  points->SetData(columns);
  ExpectAnswersOn(grid);
}
