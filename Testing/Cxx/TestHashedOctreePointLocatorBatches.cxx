// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "TestedLocator.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSmartPointer.h"

#include <utility>

namespace
{
/** The outputs of a batch, with something in them that must not stay. */
struct Outputs
{
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Ids;
  vtkNew<vtkDoubleArray> Dist2;

  Outputs()
  {
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ Offsets, Ids, Dist2 })
    {
      array->SetNumberOfComponents(2);
      array->InsertNextTuple2(7.0, 7.0);
    }
  }
  bool AreEmpty() const
  {
    return this->Ids->GetNumberOfValues() == 0 && this->Dist2->GetNumberOfValues() == 0 &&
      this->Ids->GetNumberOfComponents() == 1 && this->Dist2->GetNumberOfComponents() == 1;
  }
};

/** Positions near the points, and two that are nowhere. */
template <typename Array>
vtkSmartPointer<Array> MakeQueries(const std::vector<float>& coordinates, vtkIdType count)
{
  auto queries = vtkSmartPointer<Array>::New();
  queries->SetNumberOfComponents(3);
  queries->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const float* x = &coordinates[static_cast<std::size_t>(3 * i)];
    const double y = i == 5 ? NAN : i == 6 ? INFINITY : static_cast<double>(x[1]) - 0.01;
    queries->SetTuple3(i, static_cast<double>(x[0]) + 0.01, y, static_cast<double>(x[2]));
  }
  return queries;
}

/** One position. */
vtkSmartPointer<vtkDoubleArray> MakeQuery(double x, double y, double z)
{
  auto query = vtkSmartPointer<vtkDoubleArray>::New();
  query->SetNumberOfComponents(3);
  query->InsertNextTuple3(x, y, z);
  return query;
}

/** Aborts the batches of a locator when it hears of something. */
struct Aborting
{
  vtkHashedOctreePointLocator* Locator;
  void Abort(vtkObject*, unsigned long, void*) { this->Locator->AbortBatch(); }
};

double GetDist2(TestedLocator& locator, vtkIdType id, const hashedoctree::Position<3>& x)
{
  double point[3];
  locator->GetDataSet()->GetPoint(id, point);
  return vtkMath::Distance2BetweenPoints(x.data(), point);
}

void ExpectAsOneByOne(TestedLocator& locator, vtkDataArray* queries)
{
  Outputs one;
  Outputs few;
  Outputs within;
  constexpr int count = 7;
  constexpr double radius = 0.06;
  ASSERT_TRUE(locator->FindClosestPoints(queries, one.Ids, one.Dist2));
  ASSERT_TRUE(locator->FindClosestNPoints(count, queries, few.Ids, few.Dist2));
  ASSERT_TRUE(
    locator->FindPointsWithinRadius(radius, queries, within.Offsets, within.Ids, within.Dist2));
  ASSERT_EQ(one.Ids->GetNumberOfTuples(), queries->GetNumberOfTuples());
  ASSERT_EQ(one.Ids->GetNumberOfComponents(), 1);
  ASSERT_EQ(few.Ids->GetNumberOfTuples(), queries->GetNumberOfTuples());
  const bool isAny = queries->GetNumberOfTuples() > 0;
  ASSERT_EQ(few.Dist2->GetNumberOfComponents(), isAny ? count : 1);
  ASSERT_EQ(within.Offsets->GetNumberOfValues(), queries->GetNumberOfTuples() + 1);
  ASSERT_EQ(within.Offsets->GetValue(0), 0);
  for (vtkIdType i = 0; i < queries->GetNumberOfTuples(); ++i)
  {
    hashedoctree::Position<3> x;
    queries->GetTuple(i, x.data());
    ASSERT_EQ(one.Ids->GetValue(i), locator->FindClosestPoint(x.data()));
    const TestedLocator::Ids closest = locator.FindClosest(count, x);
    for (int j = 0; j < count; ++j)
    {
      const auto place = static_cast<std::size_t>(j);
      ASSERT_EQ(few.Ids->GetTypedComponent(i, j), place < closest.size() ? closest[place] : -1);
      ASSERT_EQ(few.Dist2->GetTypedComponent(i, j),
        place < closest.size() ? GetDist2(locator, closest[place], x) : INFINITY);
    }
    ASSERT_EQ(one.Dist2->GetValue(i), few.Dist2->GetTypedComponent(i, 0));
    std::vector<std::pair<double, vtkIdType>> expected;
    for (const std::int64_t id : locator.FindWithin(radius, x))
    {
      expected.emplace_back(GetDist2(locator, id, x), id);
    }
    std::sort(expected.begin(), expected.end());
    const vtkIdType first = within.Offsets->GetValue(i);
    ASSERT_EQ(within.Offsets->GetValue(i + 1) - first, static_cast<vtkIdType>(expected.size()));
    for (std::size_t j = 0; j < expected.size(); ++j)
    {
      const vtkIdType place = first + static_cast<vtkIdType>(j);
      ASSERT_EQ(within.Dist2->GetValue(place), expected[j].first);
      ASSERT_EQ(within.Ids->GetValue(place), expected[j].second);
    }
  }
}
}

TEST(TestHashedOctreePointLocatorBatches, FindWhatSingleSearchesFind)
{
  const auto coordinates = MakeUniformPoints<3, float>(5000, 181);
  TestedLocator locator(MakePolyData(coordinates));
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 8 }) // VTK takes no more than the machine has.
  {
    vtkSMPTools::Initialize(threads);
    ASSERT_NO_FATAL_FAILURE(
      ExpectAsOneByOne(locator, MakeQueries<vtkFloatArray>(coordinates, 3000)));
    ASSERT_NO_FATAL_FAILURE(
      ExpectAsOneByOne(locator, MakeQueries<vtkDoubleArray>(coordinates, 1000)));
    ASSERT_NO_FATAL_FAILURE(
      ExpectAsOneByOne(locator, MakeQueries<vtkSOADataArrayTemplate<float>>(coordinates, 50)));
  }
  vtkSMPTools::Initialize(0);
}

TEST(TestHashedOctreePointLocatorBatches, FindTheSameFromAllStartDepths)
{
  const auto coordinates = MakeSpherePoints<3, float>(5000, 185);
  TestedLocator locator(MakePolyData(coordinates));
  locator->SetMaxPointsPerLeaf(8);
  vtkSMPTools::SetBackend("STDThread");
  for (int model = vtkHashedOctreePointLocator::Median; model <= vtkHashedOctreePointLocator::Local;
       ++model)
  {
    locator->SetStartDepthModel(model);
    for (const int threads : { 1, 2, 8 }) // As above.
    {
      vtkSMPTools::Initialize(threads);
      ASSERT_NO_FATAL_FAILURE(
        ExpectAsOneByOne(locator, MakeQueries<vtkFloatArray>(coordinates, 300)))
        << "model " << model;
    }
  }
  vtkSMPTools::Initialize(0);
}

TEST(TestHashedOctreePointLocatorBatches, EquallyNearPointsComeByTheirIds)
{
  // Rows of a grid, and positions in the middle between their points; three points at each place.
  std::vector<float> coordinates;
  for (int i = 0; i < 3 * 8 * 8 * 8; ++i)
  {
    const int place = i * 5 % (8 * 8 * 8);
    for (const int c : { place % 8, place / 8 % 8, place / 64 })
    {
      coordinates.push_back(static_cast<float>(c) / 32.0F);
    }
  }
  auto queries = vtkSmartPointer<vtkDoubleArray>::New();
  queries->SetNumberOfComponents(3);
  for (const double z : { 0.5, 1.5, 2.5 })
  {
    for (const double y : { 0.5, 3.5, 4.5 })
    {
      for (const double x : { 0.5, 2.5, 5.5, 6.5 })
      {
        queries->InsertNextTuple3(x / 32.0, y / 32.0, z / 32.0);
      }
    }
  }
  TestedLocator locator(MakePolyData(coordinates));
  ASSERT_NO_FATAL_FAILURE(ExpectAsOneByOne(locator, queries));
}

TEST(TestHashedOctreePointLocatorBatches, FewerPointsThanAskedFor)
{
  TestedLocator locator(MakeUniform(3, 182));
  ASSERT_NO_FATAL_FAILURE(ExpectAsOneByOne(
    locator, MakeQueries<vtkDoubleArray>(MakeUniformPoints<3, float>(20, 183), 20)));
}

TEST(TestHashedOctreePointLocatorBatches, WithoutADataSetEachIsTheErrorOfTheBuild)
{
  TestedLocator locator;
  const auto query = MakeQuery(4, 0, 0);
  for (int batch = 0; batch < 2; ++batch)
  {
    Outputs outputs;
    EXPECT_FALSE(locator->FindClosestPoints(query, outputs.Ids, outputs.Dist2));
    EXPECT_TRUE(outputs.AreEmpty());
    locator.ExpectError("SetDataSet()");
  }
  locator->SetDataSet(MakePolyData<float>({ 0, 0, 0, 5, 0, 0 }));
  Outputs outputs;
  EXPECT_TRUE(locator->FindClosestPoints(query, outputs.Ids, outputs.Dist2));
  EXPECT_EQ(outputs.Ids->GetValue(0), 1);
}

TEST(TestHashedOctreePointLocatorBatches, WhoHearsOfAFailedBuildMayFreeItsRest)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(1 << 21, 1 << 20, 1 << 20); // More than can be counted.
  TestedLocator locator(image);
  Freeing listener{ locator };
  locator->AddObserver(vtkCommand::ErrorEvent, &listener, &Freeing::Free);
  Outputs outputs;
  EXPECT_FALSE(locator->FindClosestPoints(MakeQuery(0, 0, 0), outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
  EXPECT_EQ(locator.Errors.size(), 1U);
  locator.Errors.clear();
}

TEST(TestHashedOctreePointLocatorBatches, WithoutPointsOrQueries)
{
  TestedLocator nothing(MakePolyData<double>({}));
  ASSERT_NO_FATAL_FAILURE(ExpectAsOneByOne(
    nothing, MakeQueries<vtkDoubleArray>(MakeUniformPoints<3, float>(20, 183), 20)));
  TestedLocator withoutPoints(vtkSmartPointer<vtkPolyData>::New()); // No vtkPoints, either.
  ASSERT_NO_FATAL_FAILURE(ExpectAsOneByOne(
    withoutPoints, MakeQueries<vtkDoubleArray>(MakeUniformPoints<3, float>(20, 183), 20)));
  TestedLocator locator(MakeUniform(30, 182));
  vtkNew<vtkDoubleArray> queries;
  queries->SetNumberOfComponents(3);
  ASSERT_NO_FATAL_FAILURE(ExpectAsOneByOne(locator, queries));
  Outputs outputs;
  EXPECT_TRUE(locator->FindClosestNPoints(1000000, queries, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty()) << "and have taken no memory for what there is none of";
  queries->InsertNextTuple3(0.0, 0.0, 0.0);
  for (const int count : { 0, -1, VTK_INT_MIN })
  {
    EXPECT_TRUE(locator->FindClosestNPoints(count, queries, outputs.Ids, outputs.Dist2));
    EXPECT_TRUE(outputs.AreEmpty());
  }
}

TEST(TestHashedOctreePointLocatorBatches, WrongArraysAreErrors)
{
  TestedLocator locator(MakeUniform(30, 182));
  vtkNew<vtkDoubleArray> pairs;
  pairs->SetNumberOfComponents(2);
  Outputs outputs;
  EXPECT_FALSE(locator->FindClosestPoints(pairs, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
  EXPECT_FALSE(
    locator->FindPointsWithinRadius(1.0, nullptr, outputs.Offsets, outputs.Ids, outputs.Dist2));
  EXPECT_FALSE(locator->FindClosestNPoints(2, pairs, nullptr, outputs.Dist2));
  vtkNew<vtkDoubleArray> queries;
  queries->SetNumberOfComponents(3);
  queries->InsertNextTuple3(0.0, 0.0, 0.0);
  EXPECT_FALSE(locator->FindClosestPoints(queries, outputs.Ids, queries));
  EXPECT_EQ(queries->GetNumberOfTuples(), 1);
  EXPECT_FALSE(
    locator->FindPointsWithinRadius(1.0, queries, outputs.Ids, outputs.Ids, outputs.Dist2));
  ASSERT_EQ(locator.Errors.size(), 5U);
  EXPECT_NE(locator.Errors[0].find("three components"), std::string::npos);
  for (const std::size_t error : { 2U, 3U, 4U })
  {
    EXPECT_NE(locator.Errors[error].find("outputs"), std::string::npos);
  }
  locator.Errors.clear();
}

TEST(TestHashedOctreePointLocatorBatches, DoNotWriteOverThePoints)
{
  const auto cloud = MakePolyData(MakeUniformPoints<3, double>(30, 186));
  auto* coordinates = vtkDoubleArray::SafeDownCast(cloud->GetPoints()->GetData());
  TestedLocator locator(cloud);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> queries;
  queries->DeepCopy(coordinates);
  EXPECT_FALSE(locator->FindClosestPoints(queries, ids, coordinates));
  locator.ExpectError("outputs");
  EXPECT_EQ(coordinates->GetNumberOfTuples(), 30);

  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(2, 2, 2);
  vtkSmartPointer<vtkDoubleArray> axes[3];
  for (auto& axis : axes)
  {
    axis = vtkSmartPointer<vtkDoubleArray>::New();
    axis->InsertNextValue(0.0);
    axis->InsertNextValue(1.0);
  }
  grid->SetXCoordinates(axes[0]);
  grid->SetYCoordinates(axes[1]);
  grid->SetZCoordinates(axes[2]);
  locator->SetDataSet(grid);
  for (const auto& axis : axes)
  {
    EXPECT_FALSE(locator->FindClosestPoints(queries, ids, axis));
    locator.ExpectError("outputs");
    EXPECT_EQ(axis->GetNumberOfTuples(), 2);
  }
}

TEST(TestHashedOctreePointLocatorBatches, WhatTheirArraysToldOfOldValuesIsForgotten)
{
  TestedLocator locator(MakePolyData<double>({ 0, 0, 0, 1, 0, 0, 9, 0, 0 }));
  const auto queries = MakeQuery(8.0, 0.0, 0.0);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  ASSERT_TRUE(locator->FindClosestPoints(queries, ids, dist2));
  EXPECT_EQ(dist2->GetRange()[1], 1.0);
  queries->SetTuple3(0, 1.0, 2.0, 0.0);
  ASSERT_TRUE(locator->FindClosestPoints(queries, ids, dist2));
  EXPECT_EQ(dist2->GetRange()[1], 4.0);

  const vtkMTimeType before = dist2->GetMTime();
  queries->SetNumberOfComponents(1);
  EXPECT_FALSE(locator->FindClosestPoints(queries, ids, dist2));
  EXPECT_GT(dist2->GetMTime(), before);
  EXPECT_EQ(locator.Errors.size(), 1U);
  locator.Errors.clear();
}

TEST(TestHashedOctreePointLocatorBatches, WhoHearsOfTheirOutputsLastSeesWhatTheyFound)
{
  TestedLocator locator(MakePolyData<double>({ 0, 0, 0, 1, 0, 0, 9, 0, 0 }));
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  struct Observer
  {
    double Largest = 0.0;
    void See(vtkObject* output, unsigned long, void*)
    {
      this->Largest = vtkDoubleArray::SafeDownCast(output)->GetRange()[1];
    }
  } observer;
  dist2->AddObserver(vtkCommand::ModifiedEvent, &observer, &Observer::See);
  ASSERT_TRUE(locator->FindClosestPoints(MakeQuery(7.0, 0.0, 0.0), ids, dist2));
  EXPECT_EQ(observer.Largest, 4.0);
}

TEST(TestHashedOctreePointLocatorBatches, GoOnWhateverTheirObserversDo)
{
  const auto coordinates = MakeUniformPoints<3, float>(60000, 186);
  const auto queries = MakeQueries<vtkFloatArray>(coordinates, 60000);
  TestedLocator locator(MakePolyData(coordinates));
  Outputs expected;
  ASSERT_TRUE(locator->FindClosestPoints(queries, expected.Ids, expected.Dist2));
  struct Observer
  {
    vtkHashedOctreePointLocator* Locator;
    int Calls = 0;
    void Free(vtkObject*, unsigned long, void*)
    {
      this->Locator->FreeSearchStructure();
      if (++this->Calls % 2 == 0)
      {
        this->Locator->SetMaxPointsPerLeaf(this->Calls);
        EXPECT_GE(this->Locator->FindClosestPoint(0.5, 0.5, 0.5), 0);
      }
    }
  } observer{ locator.Get() };
  locator->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::Free);
  Outputs outputs;
  ASSERT_TRUE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_GT(observer.Calls, 2);
  for (vtkIdType i = 0; i < queries->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(outputs.Ids->GetValue(i), expected.Ids->GetValue(i));
    ASSERT_EQ(outputs.Dist2->GetValue(i), expected.Dist2->GetValue(i));
  }
}

TEST(TestHashedOctreePointLocatorBatches, CanBeAbortedWhileTheyBuild)
{
  TestedLocator locator(MakePolyData<float>({ NAN, 0, 0, 1, 0, 0 }));
  Aborting observer{ locator.Get() };
  locator->AddObserver(vtkCommand::WarningEvent, &observer, &Aborting::Abort);
  const auto queries = MakeQuery(8.0, 0.0, 0.0);
  Outputs outputs;
  EXPECT_FALSE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
  locator.ExpectWarningOfSkippedPoints(1);
  EXPECT_TRUE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_EQ(outputs.Ids->GetValue(0), 1);

  // Also when there is nothing to do after it.
  vtkNew<vtkFloatArray> noQueries;
  noQueries->SetNumberOfComponents(3);
  EXPECT_TRUE(locator->FindClosestPoints(noQueries, outputs.Ids, outputs.Dist2));
  locator->Modified();
  EXPECT_FALSE(locator->FindClosestPoints(noQueries, outputs.Ids, outputs.Dist2));
  locator.ExpectWarningOfSkippedPoints(1);
}

TEST(TestHashedOctreePointLocatorBatches, CanBeAbortedByWhoHearsOfTheirOutputs)
{
  TestedLocator locator(MakePolyData<float>({ 0, 0, 0, 1, 0, 0 }));
  Aborting observer{ locator.Get() };
  const auto queries = MakeQuery(8.0, 0.0, 0.0);
  Outputs outputs;
  outputs.Ids->AddObserver(vtkCommand::ModifiedEvent, &observer, &Aborting::Abort);
  EXPECT_FALSE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
}

TEST(TestHashedOctreePointLocatorBatches, EndWhenAbortedWhateverOtherBatchesDo)
{
  const auto coordinates = MakeUniformPoints<3, float>(60000, 185);
  TestedLocator locator(MakePolyData(coordinates));
  const auto queries = MakeQueries<vtkFloatArray>(coordinates, 60000);
  struct Observer
  {
    vtkHashedOctreePointLocator* Locator;
    vtkDataArray* Queries;
    Outputs Inner{};
    bool IsInside = false;
    bool IsInnerDone = false;
    void Observe(vtkObject*, unsigned long, void*)
    {
      if (!std::exchange(this->IsInside, true))
      {
        this->Locator->AbortBatch();
        // It begins after that, and goes on.
        this->IsInnerDone =
          this->Locator->FindClosestPoints(this->Queries, this->Inner.Ids, this->Inner.Dist2);
      }
    }
  } observer{ locator.Get(), queries };
  locator->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::Observe);
  Outputs outputs;
  EXPECT_FALSE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
  EXPECT_TRUE(observer.IsInnerDone);
  EXPECT_EQ(observer.Inner.Ids->GetNumberOfTuples(), 60000);
}

TEST(TestHashedOctreePointLocatorBatches, AreEmptyWhateverTheirObserversThrow)
{
  const auto coordinates = MakeUniformPoints<3, float>(60000, 187);
  TestedLocator locator(MakePolyData(coordinates));
  locator->BuildLocator();
  const auto queries = MakeQueries<vtkFloatArray>(coordinates, 60000);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(
    [](vtkObject*, unsigned long, void*, void* fraction)
    {
      if (*static_cast<double*>(fraction) > 0.5)
      {
        throw 5;
      }
    });
  locator->AddObserver(vtkCommand::ProgressEvent, observer);
  Outputs outputs;
  EXPECT_THROW(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2), int);
  EXPECT_TRUE(outputs.AreEmpty());
  while (observer->GetReferenceCount() > 2) // VTK does not let go of one that throws.
  {
    observer->UnRegister(nullptr);
  }
}

TEST(TestHashedOctreePointLocatorBatches, TellProgressAndCanBeAborted)
{
  const auto coordinates = MakeUniformPoints<3, float>(60000, 184);
  TestedLocator locator(MakePolyData(coordinates));
  const auto queries = MakeQueries<vtkFloatArray>(coordinates, 60000);
  struct Observer
  {
    vtkHashedOctreePointLocator* Locator;
    std::vector<double> Fractions;
    double Stop = 2.0;
    void Observe(vtkObject*, unsigned long, void* fraction)
    {
      this->Fractions.push_back(*static_cast<double*>(fraction));
      if (this->Fractions.back() >= this->Stop)
      {
        this->Locator->AbortBatch();
      }
    }
  } observer{ locator.Get(), {} };
  locator->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::Observe);
  Outputs outputs;
  EXPECT_TRUE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_GE(observer.Fractions.size(), 3U);
  EXPECT_TRUE(std::is_sorted(observer.Fractions.begin(), observer.Fractions.end()));
  EXPECT_EQ(observer.Fractions.back(), 1.0);

  // Of another type, they are copied first.
  observer.Fractions.clear();
  EXPECT_TRUE(locator->FindClosestPoints(
    MakeQueries<vtkIntArray>(coordinates, 60000), outputs.Ids, outputs.Dist2));
  EXPECT_GE(observer.Fractions.size(), 3U);
  EXPECT_TRUE(std::is_sorted(observer.Fractions.begin(), observer.Fractions.end()));
  EXPECT_EQ(observer.Fractions.back(), 1.0);

  observer.Stop = 0.5;
  observer.Fractions.clear();
  EXPECT_FALSE(locator->FindClosestNPoints(3, queries, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
  EXPECT_LT(observer.Fractions.back(), 0.9);
  EXPECT_FALSE(
    locator->FindPointsWithinRadius(0.01, queries, outputs.Offsets, outputs.Ids, outputs.Dist2));
  EXPECT_TRUE(outputs.AreEmpty());
  EXPECT_EQ(outputs.Offsets->GetNumberOfValues(), 0);

  observer.Stop = 2.0;
  EXPECT_TRUE(locator->FindClosestPoints(queries, outputs.Ids, outputs.Dist2));
  EXPECT_EQ(outputs.Ids->GetNumberOfTuples(), 60000);
}
