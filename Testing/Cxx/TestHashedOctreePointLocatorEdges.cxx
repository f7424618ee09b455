// SPDX-License-Identifier: BSD-3-Clause

// The contract in the header of the locator, line by line.
#include "PointSamples.h"
#include "TestedLocator.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
using Ids = TestedLocator::Ids;
using Position = TestedLocator::Position;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

void ExpectNoTree(TestedLocator& locator)
{
  locator.ExpectToFindNothing();
  EXPECT_EQ(locator->GetLevel(), 0);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 0);
  EXPECT_GT(locator->GetBounds()[0], locator->GetBounds()[1]);
}

Ids MakeIds(std::int64_t count)
{
  Ids ids;
  for (std::int64_t i = 0; i < count; ++i)
  {
    ids.push_back(i);
  }
  return ids;
}
}

TEST(TestHashedOctreePointLocatorEdges, WithoutPointsNothingIsFoundSilently)
{
  TestedLocator ofNoArray(vtkSmartPointer<vtkPolyData>::New());
  ExpectNoTree(ofNoArray);
  TestedLocator ofNoPoints(MakePolyData<float>({}));
  ExpectNoTree(ofNoPoints);
  TestedLocator ofNoImage(vtkSmartPointer<vtkImageData>::New());
  ExpectNoTree(ofNoImage);
}

TEST(TestHashedOctreePointLocatorEdges, NoDataSetIsAnErrorOfTheBuild)
{
  TestedLocator locator;
  ExpectNoTree(locator);
  locator.ExpectError("SetDataSet()");
  ExpectNoTree(locator);
  locator->Modified();
  ExpectNoTree(locator);
  locator.ExpectError("SetDataSet()");
  locator->SetDataSet(MakePolyData<float>({ 0, 0, 0, 5, 0, 0 }));
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 1);
}

TEST(TestHashedOctreePointLocatorEdges, NothingToPutAnswersIntoIsAnError)
{
  TestedLocator locator(MakePolyData<float>({ 0, 0, 0, 5, 0, 0 }));
  const double origin[3] = { 0, 0, 0 };
  const double box[6] = { 0, 1, 0, 1, 0, 1 };
  locator->FindClosestNPoints(2, origin, nullptr);
  locator->FindPointsWithinRadius(1.0, origin, nullptr);
  locator->FindPointsWithinBox(box, nullptr);
  ASSERT_EQ(locator.Errors.size(), 3U);
  for (const std::string& error : locator.Errors)
  {
    EXPECT_NE(error.find("needs a list"), std::string::npos) << error;
  }
  locator->GenerateRepresentation(0, nullptr);
  ASSERT_EQ(locator.Errors.size(), 4U);
  EXPECT_NE(locator.Errors[3].find("needs a vtkPolyData"), std::string::npos) << locator.Errors[3];
  locator.Errors.clear();
}

TEST(TestHashedOctreePointLocatorEdges, PointsWithoutThreeCoordinatesAreAnError)
{
  for (const int components : { 1, 2, 4 })
  {
    const auto cloud = MakePolyData<float>({ 0, 0, 0, 5, 0, 0, 0, 5, 0, 0, 0, 5 });
    cloud->GetPoints()->GetData()->SetNumberOfComponents(components);
    TestedLocator locator(cloud);
    EXPECT_EQ(locator->FindClosestPoint(1, 2, 3), -1);
    locator.ExpectError("three components");
    locator.ExpectToFindNothing();
    cloud->GetPoints()->GetData()->SetNumberOfComponents(3);
    cloud->Modified();
    EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 1);
  }
}

TEST(TestHashedOctreePointLocatorEdges, GhostAndHiddenPointsAreLikeAllOthers)
{
  const auto cloud = MakePolyData<float>({ 0, 0, 0, 1, 0, 0, 2, 0, 0 });
  vtkUnsignedCharArray* ghosts = cloud->AllocatePointGhostArray();
  ghosts->SetValue(1, vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->SetValue(2, vtkDataSetAttributes::HIDDENPOINT);
  ASSERT_EQ(cloud->GetPointGhostArray(), ghosts);
  TestedLocator locator(cloud);
  for (vtkIdType id = 0; id < 3; ++id)
  {
    EXPECT_EQ(locator->FindClosestPoint(static_cast<double>(id), 0, 0), id);
  }
  EXPECT_EQ(locator.FindClosest(3, { 2, 0, 0 }), Ids({ 2, 1, 0 }));
  EXPECT_EQ(locator.FindWithin(1.0, { 2, 0, 0 }), Ids({ 1, 2 }));
}

TEST(TestHashedOctreePointLocatorEdges, DataMayChangeAfterABuild)
{
  const auto cloud = MakePolyData<float>({ 0, 0, 0, 5, 0, 0 });
  TestedLocator locator(cloud);
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 1);
  EXPECT_EQ(locator->GetBounds()[1], 5.0);

  cloud->GetPoints()->SetPoint(1, -9, 0, 0);
  cloud->GetPoints()->Modified();
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 0);
  EXPECT_EQ(locator->GetBounds()[0], -9.0);

  cloud->SetPoints(MakePolyData<double>({ 1e300, 0, 0 })->GetPoints());
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 0);
  EXPECT_EQ(locator.FindClosest(9, { 0, 0, 0 }), Ids{ 0 });

  cloud->GetPoints()->InsertNextPoint(4, 0, 0);
  cloud->Modified();
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 1);
}

TEST(TestHashedOctreePointLocatorEdges, DataMayBeEmptiedAfterABuild)
{
  for (int way = 0; way < 7; ++way)
  {
    SCOPED_TRACE(way);
    const auto cloud = MakePolyData(MakeUniformPoints<3, float>(100, 21));
    TestedLocator locator(cloud);
    EXPECT_EQ(locator.FindWithin(Infinity, { 0, 0, 0 }).size(), 100U);
    if (way == 0)
    {
      cloud->Initialize();
    }
    else if (way == 1)
    {
      cloud->SetPoints(nullptr);
    }
    else if (way == 2)
    {
      cloud->GetPoints()->Reset();
      cloud->GetPoints()->Modified();
    }
    else if (way == 3)
    {
      locator->SetDataSet(nullptr);
    }
    else if (way == 4)
    {
      cloud->GetPoints()->SetDataType(VTK_DOUBLE); // A new array.
    }
    else if (way == 5)
    {
      cloud->GetPoints()->Initialize();
    }
    else
    {
      locator->SetDataSet(MakePolyData<double>({}));
    }
    ExpectNoTree(locator);
    if (locator->GetDataSet() == nullptr)
    {
      locator.ExpectError("SetDataSet()");
    }
  }
}

TEST(TestHashedOctreePointLocatorEdges, WhoHearsOfAChangeMayAskAtOnce)
{
  struct Listener
  {
    TestedLocator& Asked;
    vtkIdType Found = -2;
    void Ask() { this->Found = this->Asked->FindClosestPoint(4, 0, 0); }
  };
  for (const bool pointsStay : { false, true })
  {
    // A point set that is initialized says so, and only then lets its points go.
    const auto cloud = MakePolyData<float>({ 0, 0, 0, 5, 0, 0 });
    const vtkSmartPointer<vtkPoints> points = pointsStay ? cloud->GetPoints() : nullptr;
    TestedLocator locator(cloud);
    Listener listener{ locator };
    const auto tag = cloud->AddObserver(vtkCommand::ModifiedEvent, &listener, &Listener::Ask);
    cloud->Initialize();
    EXPECT_EQ(listener.Found, 1);
    cloud->RemoveObserver(tag);
    ExpectNoTree(locator);
  }
}

TEST(TestHashedOctreePointLocatorEdges, AnotherDataSetMayTakeItsPlace)
{
  TestedLocator locator(MakePolyData<float>({ 0, 0, 0, 5, 0, 0 }));
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 1);
  locator->SetDataSet(MakePolyData<double>({ 4, 0, 0, 5, 0, 0 }));
  EXPECT_EQ(locator->FindClosestPoint(4, 0, 0), 0);
}

TEST(TestHashedOctreePointLocatorEdges, OnePoint)
{
  TestedLocator locator(MakePolyData<float>({ 1, 2, 3 }));
  for (const Position& x : { Position{ 1, 2, 3 }, Position{ -1e30, 0, 4 }, Position{ 0, 0, 0 } })
  {
    EXPECT_EQ(locator->FindClosestPoint(x.data()), 0);
    EXPECT_EQ(locator.FindClosest(3, x), Ids{ 0 });
    EXPECT_EQ(locator.FindWithin(Infinity, x), Ids{ 0 });
  }
  EXPECT_EQ(locator->GetLevel(), 0);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 1);
}

TEST(TestHashedOctreePointLocatorEdges, AllPointsEqual)
{
  std::vector<double> coordinates;
  for (int i = 0; i < 1000; ++i)
  {
    coordinates.insert(coordinates.end(), { -7.0, 0.25, 1e6 });
  }
  TestedLocator locator(MakePolyData(coordinates));
  for (const Position& x : { Position{ -7, 0.25, 1e6 }, Position{ 3, 0, 0 } })
  {
    EXPECT_EQ(locator->FindClosestPoint(x.data()), 0);
    EXPECT_EQ(locator.FindClosest(4, x), MakeIds(4));
    EXPECT_EQ(locator.FindWithin(1e7, x), MakeIds(1000));
  }
  EXPECT_EQ(locator.FindWithin(0.0, { -7, 0.25, 1e6 }), MakeIds(1000));
  EXPECT_EQ(locator.FindWithin(0.0, { -7, 0.25, 1e6 + 1e-9 }), Ids());
}

TEST(TestHashedOctreePointLocatorEdges, PointsThatAreNotFiniteAreSkippedWithOneWarning)
{
  std::vector<double> coordinates = MakeUniformPoints<3, double>(50, 22);
  coordinates[3 * 7 + 1] = NotANumber;
  coordinates[3 * 20] = Infinity;
  coordinates[3 * 49 + 2] = -Infinity;
  const auto cloud = MakePolyData(coordinates);
  TestedLocator locator(cloud);
  const Ids found = locator.FindWithin(Infinity, { 0, 0, 0 });
  EXPECT_EQ(found.size(), 47U);
  for (const std::int64_t id : { 7, 20, 49 })
  {
    EXPECT_EQ(std::count(found.begin(), found.end(), id), 0);
  }
  EXPECT_EQ(locator.FindClosest(50, { 0, 0, 0 }).size(), 47U);
  locator.ExpectWarningOfSkippedPoints(3);
  EXPECT_TRUE(std::isfinite(locator->GetBounds()[1]));

  locator->ForceBuildLocator();
  locator.ExpectWarningOfSkippedPoints(3);
}

TEST(TestHashedOctreePointLocatorEdges, NoFinitePointIsAsNoPoint)
{
  TestedLocator locator(MakePolyData<float>({ NAN, 0, 0, 0, INFINITY, 0 }));
  ExpectNoTree(locator);
  locator.ExpectWarningOfSkippedPoints(2);
}

TEST(TestHashedOctreePointLocatorEdges, PositionsThatAreNotFiniteFindNothing)
{
  TestedLocator locator(MakePolyData(MakeUniformPoints<3, float>(100, 23)));
  for (const double bad : { NotANumber, Infinity, -Infinity })
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Position x{ 0.5, 0.5, 0.5 };
      x[axis] = bad;
      EXPECT_EQ(locator->FindClosestPoint(x.data()), -1);
      EXPECT_EQ(locator.FindClosest(3, x), Ids());
      EXPECT_EQ(locator.FindWithin(Infinity, x), Ids());
      double dist2 = 77.0;
      EXPECT_EQ(locator->FindClosestPointWithinRadius(Infinity, x.data(), dist2), -1);
      EXPECT_EQ(dist2, 77.0);
    }
  }
}

TEST(TestHashedOctreePointLocatorEdges, NumbersOfPointsOutOfRangeAreSilent)
{
  TestedLocator locator(MakePolyData(MakeUniformPoints<3, float>(100, 24)));
  const Position x{ 0.5, 0.5, 0.5 };
  EXPECT_EQ(locator.FindClosest(0, x), Ids());
  EXPECT_EQ(locator.FindClosest(-1, x), Ids());
  EXPECT_EQ(locator.FindClosest(VTK_INT_MIN, x), Ids());
  EXPECT_EQ(locator.FindClosest(100, x).size(), 100U);
  EXPECT_EQ(locator.FindClosest(101, x).size(), 100U);
  EXPECT_EQ(locator.FindClosest(VTK_INT_MAX, x).size(), 100U);
}

TEST(TestHashedOctreePointLocatorEdges, RadiiOfAllKinds)
{
  TestedLocator locator(MakePolyData<double>({ 0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 0, 0 }));
  const Position origin{ 0, 0, 0 };
  EXPECT_EQ(locator.FindWithin(0.0, origin), (Ids{ 0, 3 })); // Points at x.
  EXPECT_EQ(locator.FindWithin(-0.0, origin), (Ids{ 0, 3 }));
  EXPECT_EQ(locator.FindWithin(3.0, origin), (Ids{ 0, 1, 3 })); // Inclusive.
  EXPECT_EQ(locator.FindWithin(5.0, origin), (Ids{ 0, 1, 2, 3 }));
  EXPECT_EQ(locator.FindWithin(std::nextafter(5.0, 0.0), origin), (Ids{ 0, 1, 3 }));
  EXPECT_EQ(locator.FindWithin(Infinity, origin), MakeIds(4));
  EXPECT_EQ(locator.FindWithin(1e300, origin), MakeIds(4)); // Its square is infinite.
  for (const double none : { -1.0, -5.0, -1e-300, -Infinity, NotANumber })
  {
    EXPECT_EQ(locator.FindWithin(none, origin), Ids());
    double dist2 = 77.0;
    EXPECT_EQ(locator->FindClosestPointWithinRadius(none, origin.data(), dist2), -1);
    EXPECT_EQ(dist2, 77.0);
  }
  double dist2 = 77.0;
  const Position beside{ 3, 3, 0 };
  EXPECT_EQ(locator->FindClosestPointWithinRadius(0.5, beside.data(), dist2), -1);
  EXPECT_EQ(dist2, 77.0);
  EXPECT_EQ(locator->FindClosestPointWithinRadius(1.0, beside.data(), dist2), 2);
  EXPECT_EQ(dist2, 1.0);
  EXPECT_EQ(locator->FindClosestPointWithinRadius(Infinity, origin.data(), dist2), 0);
  EXPECT_EQ(dist2, 0.0);
}

TEST(TestHashedOctreePointLocatorEdges, AMillionWidthsAway)
{
  const std::vector<float> coordinates = MakeUniformPoints<3, float>(3000, 25);
  const BruteForceSearch<3, float> oracle({ coordinates.data(), 3000 });
  TestedLocator locator(MakePolyData(coordinates));
  for (const Position& x : { Position{ 1e6, 0.3, 0.2 }, Position{ -1e6, -1e6, 1e6 },
         Position{ 0.5, 0.5, -1e6 }, Position{ 1e30, 0, 0 }, Position{ 0.5, 1e100, 0.5 } })
  {
    const auto all = oracle.FindAll(x);
    locator.ExpectAnswers(x, all, { 1.0, std::sqrt(all[9].Dist2), std::sqrt(all.back().Dist2) });
  }
}

TEST(TestHashedOctreePointLocatorEdges, ManyMorePointsThanALeafHoldsAtOnePlaceAndOneFarAway)
{
  std::vector<double> coordinates = MakeUniformPoints<3, double>(5000, 26, 0.0, 1e-9);
  coordinates.insert(coordinates.end(), { 1.0, 1.0, 1.0 });
  const BruteForceSearch<3, double> oracle({ coordinates.data(), 5001 });
  TestedLocator locator(MakePolyData(coordinates));
  for (const Position& x : { Position{ 5e-10, 5e-10, 5e-10 }, Position{ 0.4, 0.4, 0.4 },
         Position{ 0.6, 0.6, 0.6 }, Position{ 1, 1, 1 } })
  {
    const auto all = oracle.FindAll(x);
    locator.ExpectAnswers(x, all, { 0.0, 1e-10, 0.5, 2.0 });
  }
}

TEST(TestHashedOctreePointLocatorEdges, DistancesBeyondTheRangeOfDouble)
{
  // Squared distances that overflow are all equally far; the smallest id wins among them.
  const std::vector<double> coordinates{ 1e200, 0, 0, -1e200, 0, 0, 0, 1e200, 0, 1, 0, 0, 2, 0, 0 };
  const BruteForceSearch<3, double> oracle({ coordinates.data(), 5 });
  TestedLocator locator(MakePolyData(coordinates));
  for (const int maxPointsPerLeaf : { 1, 16 })
  {
    locator->SetMaxPointsPerLeaf(maxPointsPerLeaf);
    for (const Position& x : { Position{ 0, 0, 0 }, Position{ 1e200, 0, 0 }, Position{ 2, 0, 0 },
           Position{ 0, -1e200, 0 }, Position{ 1e300, 1e300, 0 } })
    {
      SCOPED_TRACE(x[0]);
      locator.ExpectAnswers(x, oracle.FindAll(x), { 0.0, 1.5, 1e180, Infinity });
    }
  }
}
