// SPDX-License-Identifier: BSD-3-Clause

// When the tree is built, what of, and what the locator then tells of it.
#include "PointIndex.h"
#include "PointSamples.h"
#include "TestedLocator.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkTypeFloat32Array.h"
#include "vtkTypeFloat64Array.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace
{
using Class = vtkHashedOctreePointLocator;

/** Tells of changes by its GetMTime() alone. */
template <typename Base>
class Telling : public Base
{
public:
  static Telling* New()
  {
    auto* object = new Telling;
    object->InitializeObjectBase();
    return object;
  }
  vtkMTimeType GetMTime() override { return std::max(Base::GetMTime(), this->Told.GetMTime()); }

  vtkTimeStamp Told;
};

/** Counts builds by their warnings: every build meets one point that is not finite. */
class CountedLocator
{
public:
  CountedLocator()
    : Cloud(MakePolyData<float>({ 0, 0, 0, 1, 0, 0, NAN, 0, 0, 0, 2, 0, 0.1F, 0.1F, 0 }))
    , Locator(this->Cloud)
  {
  }

  vtkHashedOctreePointLocator* operator->() { return this->Locator.Get(); }
  vtkPolyData* GetCloud() { return this->Cloud; }

  /** Builds since the last call. */
  std::size_t TakeBuilds()
  {
    const std::size_t builds = this->Locator.Warnings.size();
    this->Locator.Warnings.clear();
    return builds;
  }
  /** Builds that BuildLocator() and one query of each kind do. */
  std::size_t Use()
  {
    const double x[3] = { 0.9, 0.0, 0.0 };
    double dist2 = 0.0;
    vtkNew<vtkIdList> list;
    this->Locator->BuildLocator();
    EXPECT_EQ(this->Locator->FindClosestPoint(x), 1);
    EXPECT_EQ(this->Locator->FindClosestPointWithinRadius(0.5, x, dist2), 1);
    this->Locator->FindClosestNPoints(1, x, list);
    EXPECT_EQ(list->GetId(0), 1);
    this->Locator->FindPointsWithinRadius(0.5, x, list);
    EXPECT_EQ(list->GetId(0), 1);
    return this->TakeBuilds();
  }

private:
  vtkSmartPointer<vtkPolyData> Cloud;
  TestedLocator Locator;
};
}

TEST(TestHashedOctreePointLocatorBuild, DefaultsAreAsDocumented)
{
  vtkNew<vtkHashedOctreePointLocator> locator;
  EXPECT_EQ(locator->GetMaxPointsPerLeaf(), 64);
  EXPECT_EQ(locator->GetMaxDepth(), 21);
  EXPECT_EQ(locator->GetMaxLevel(), 21);
  EXPECT_EQ(locator->GetFrequencyModel(), Class::Leaves);
  EXPECT_EQ(locator->GetStartDepthModel(), Class::Median);
  EXPECT_EQ(locator->GetFixedStartDepth(), 0);
  EXPECT_EQ(locator->GetStartDepth(), 0);
  EXPECT_EQ(locator->GetIndexBytes(), 0);
  EXPECT_EQ(locator->GetLevel(), 0);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 0);
  EXPECT_GT(locator->GetBounds()[4], locator->GetBounds()[5]);
}

TEST(TestHashedOctreePointLocatorBuild, PropertiesAreClamped)
{
  vtkNew<vtkHashedOctreePointLocator> locator;
  for (const int value : { VTK_INT_MIN, VTK_INT_MAX })
  {
    const bool low = value < 0;
    locator->SetMaxPointsPerLeaf(value);
    locator->SetMaxDepth(value);
    locator->SetFrequencyModel(value);
    locator->SetStartDepthModel(value);
    locator->SetFixedStartDepth(value);
    EXPECT_EQ(locator->GetMaxPointsPerLeaf(), low ? 1 : VTK_INT_MAX);
    EXPECT_EQ(locator->GetMaxDepth(), low ? 0 : 21);
    EXPECT_EQ(locator->GetMaxLevel(), low ? 0 : 21);
    EXPECT_EQ(locator->GetFrequencyModel(), low ? Class::Leaves : Class::Grid);
    EXPECT_EQ(locator->GetStartDepthModel(), low ? Class::Median : Class::Local);
    EXPECT_EQ(locator->GetFixedStartDepth(), low ? 0 : 21);
  }
  locator->SetMaxLevel(1000);
  EXPECT_EQ(locator->GetMaxDepth(), 21);
}

TEST(TestHashedOctreePointLocatorBuild, NothingIsBuiltTwice)
{
  CountedLocator locator;
  EXPECT_EQ(locator.TakeBuilds(), 0U);
  EXPECT_EQ(locator.Use(), 1U);
  const vtkMTimeType built = locator->GetBuildTime();
  const vtkMTimeType modified = locator->GetMTime();
  EXPECT_EQ(locator.Use(), 0U);
  locator->Update();
  EXPECT_EQ(locator.Use(), 0U);
  EXPECT_EQ(locator->GetBuildTime(), built);
  EXPECT_EQ(locator->GetMTime(), modified);
}

TEST(TestHashedOctreePointLocatorBuild, ModificationsRebuild)
{
  CountedLocator locator;
  EXPECT_EQ(locator.Use(), 1U);
  locator->Modified();
  EXPECT_EQ(locator.Use(), 1U);
  locator.GetCloud()->Modified();
  EXPECT_EQ(locator.Use(), 1U);
  locator.GetCloud()->GetPoints()->Modified();
  EXPECT_EQ(locator.Use(), 1U);
  locator.GetCloud()->GetPoints()->GetData()->Modified();
  EXPECT_EQ(locator.Use(), 1U);
  vtkNew<vtkPoints> others;
  others->DeepCopy(locator.GetCloud()->GetPoints());
  locator.GetCloud()->SetPoints(others);
  EXPECT_EQ(locator.Use(), 1U);
  vtkNew<vtkDoubleArray> array;
  array->DeepCopy(locator.GetCloud()->GetPoints()->GetData());
  locator.GetCloud()->GetPoints()->SetData(array);
  EXPECT_EQ(locator.Use(), 1U);
  array->Modified();
  EXPECT_EQ(locator.Use(), 1U);
  vtkNew<vtkPoints> third;
  third->DeepCopy(others);
  locator.GetCloud()->GetPoints()->ShallowCopy(third);
  EXPECT_EQ(locator.Use(), 1U);
  locator->SetMaxPointsPerLeaf(1);
  EXPECT_EQ(locator.Use(), 1U);
  locator->SetMaxDepth(4);
  EXPECT_EQ(locator.Use(), 1U);
  locator->Modified();
  locator->Update();
  EXPECT_EQ(locator.TakeBuilds(), 1U);
  locator->FreeSearchStructure();
  EXPECT_EQ(locator.Use(), 1U);
  locator->Initialize();
  EXPECT_EQ(locator.Use(), 1U);
}

TEST(TestHashedOctreePointLocatorBuild, OtherPointsInTheSameDataSetRebuild)
{
  const auto cloud = MakePolyData<double>({ 0, 0, 0, 1, 0, 0 });
  const auto other = MakePolyData<double>({ 5, 0, 0, 9, 0, 0, 0.9, 0, 0 });
  TestedLocator locator(cloud);
  const double x[3] = { 0.9, 0.0, 0.0 };
  EXPECT_EQ(locator->FindClosestPoint(x), 1);
  cloud->DeepCopy(other);
  EXPECT_EQ(locator->FindClosestPoint(x), 2);
  cloud->ShallowCopy(MakePolyData<float>({ 0.9F, 0, 0 }));
  EXPECT_EQ(locator->FindClosestPoint(x), 0);
  cloud->CopyStructure(other);
  EXPECT_EQ(locator->FindClosestPoint(x), 2);
  cloud->GetPoints()->DeepCopy(MakePolyData<double>({ 4, 0, 0, 0, 0, 0 })->GetPoints());
  EXPECT_EQ(locator->FindClosestPoint(x), 1);
  cloud->ReleaseData();
  EXPECT_EQ(locator->FindClosestPoint(x), -1);
  cloud->SetPoints(other->GetPoints());
  EXPECT_EQ(locator->FindClosestPoint(x), 1);

  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  locator->SetDataSet(image);
  EXPECT_EQ(locator->FindClosestPoint(x), 1);
  image->SetOrigin(0.9, 0.0, 0.0);
  EXPECT_EQ(locator->FindClosestPoint(x), 0);
  image->SetDimensions(0, 0, 0);
  EXPECT_EQ(locator->FindClosestPoint(x), -1);
}

TEST(TestHashedOctreePointLocatorBuild, WhoTellsOfChangesByGetMTimeAloneIsAsked)
{
  const double x[3] = { 0.9, 0.0, 0.0 };
  const auto expectRebuild = [&x](vtkDataSet* dataSet, vtkPoints* points, vtkTimeStamp& told)
  {
    TestedLocator locator(dataSet);
    EXPECT_EQ(locator->FindClosestPoint(x), 1);
    vtkDataArray* array = points->GetData();
    array->SetTuple3(0, 0.9, 0.0, 0.0);
    array->SetTuple3(1, 0.0, 0.0, 0.0);
    told.Modified();
    EXPECT_EQ(locator->FindClosestPoint(x), 0);
  };
  {
    const auto set = MakePolyData<double>({ 0, 0, 0, 1, 0, 0 });
    vtkNew<Telling<vtkPoints>> points;
    points->SetData(set->GetPoints()->GetData());
    set->SetPoints(points);
    expectRebuild(set, points, points->Told);
  }
  {
    const auto set = MakePolyData<double>({ 0, 0, 0, 1, 0, 0 });
    vtkNew<Telling<vtkDoubleArray>> array;
    array->DeepCopy(set->GetPoints()->GetData());
    set->GetPoints()->SetData(array);
    expectRebuild(set, set->GetPoints(), array->Told);
  }
  {
    vtkNew<Telling<vtkPolyData>> set;
    set->ShallowCopy(MakePolyData<double>({ 0, 0, 0, 1, 0, 0 }));
    expectRebuild(set, set->GetPoints(), set->Told);
  }
}

TEST(TestHashedOctreePointLocatorBuild, CellsAndAttributesAskForNoNewTree)
{
  const auto expectNoRebuild = [](CountedLocator& locator, vtkDataSet* dataSet)
  {
    SCOPED_TRACE(std::string(dataSet->GetClassName()) + " with a " +
      locator.GetCloud()->GetPoints()->GetData()->GetClassName());
    EXPECT_EQ(locator.Use(), 1U);
    dataSet->GetPointData()->Modified();
    dataSet->GetCellData()->Modified();
    EXPECT_EQ(locator.Use(), 0U);
  };
  const auto expectOfArray = [&](const auto& array)
  {
    CountedLocator locator;
    array->DeepCopy(locator.GetCloud()->GetPoints()->GetData());
    locator.GetCloud()->GetPoints()->SetData(array);
    expectNoRebuild(locator, locator.GetCloud());
  };
  expectOfArray(vtkSmartPointer<vtkFloatArray>::New());
  expectOfArray(vtkSmartPointer<vtkDoubleArray>::New());
  expectOfArray(vtkSmartPointer<vtkTypeFloat32Array>::New());
  expectOfArray(vtkSmartPointer<vtkTypeFloat64Array>::New());
  const auto expectOfSet = [&](const auto& pointSet)
  {
    CountedLocator locator;
    pointSet->SetPoints(locator.GetCloud()->GetPoints());
    locator->SetDataSet(pointSet);
    expectNoRebuild(locator, pointSet);
  };
  expectOfSet(vtkSmartPointer<vtkPointSet>::New());
  expectOfSet(vtkSmartPointer<vtkStructuredGrid>::New());
  expectOfSet(vtkSmartPointer<vtkUnstructuredGrid>::New());
}

TEST(TestHashedOctreePointLocatorBuild, ForceBuildLocatorAlwaysBuilds)
{
  CountedLocator locator;
  for (int i = 0; i < 3; ++i)
  {
    const vtkMTimeType before = locator->GetBuildTime();
    locator->ForceBuildLocator();
    EXPECT_EQ(locator.TakeBuilds(), 1U);
    EXPECT_GT(locator->GetBuildTime(), before);
  }
  EXPECT_EQ(locator.Use(), 0U);
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
TEST(TestHashedOctreePointLocatorBuild, UseExistingSearchStructureWaitsForPoints)
{
  const auto points = MakePolyData<float>({ 1, 2, 3 });
  const auto none = MakePolyData<float>({});
  const auto notFinite = MakePolyData<float>({ NAN, 0, 0 });
  for (vtkPolyData* first : { static_cast<vtkPolyData*>(nullptr), none.Get(), notFinite.Get() })
  {
    TestedLocator locator(first);
    locator->UseExistingSearchStructureOn();
    EXPECT_EQ(locator->FindClosestPoint(1, 2, 3), -1);
    if (first == nullptr)
    {
      locator.ExpectError("SetDataSet()");
    }
    locator.Warnings.clear();
    locator->SetDataSet(points);
    EXPECT_EQ(locator->FindClosestPoint(1, 2, 3), 0);
  }
  TestedLocator locator(none);
  locator->UseExistingSearchStructureOn();
  locator->BuildLocator();
  none->SetPoints(points->GetPoints());
  locator->BuildLocator();
  EXPECT_EQ(locator->FindClosestPoint(1, 2, 3), 0);
}

TEST(TestHashedOctreePointLocatorBuild, UseExistingSearchStructureNeverRebuilds)
{
  CountedLocator locator;
  locator->UseExistingSearchStructureOn();
  EXPECT_EQ(locator.Use(), 1U); // There was none yet.
  locator->Modified();
  EXPECT_EQ(locator.Use(), 0U);
  locator.GetCloud()->GetPoints()->SetPoint(1, 50, 50, 50);
  locator.GetCloud()->GetPoints()->Modified();
  EXPECT_EQ(locator.Use(), 0U); // By the points as they were.
  locator->SetDataSet(nullptr);
  EXPECT_EQ(locator.Use(), 0U);
  locator->SetDataSet(locator.GetCloud());
  locator.GetCloud()->GetPoints()->SetPoint(1, 1, 0, 0);
  locator->ForceBuildLocator();
  EXPECT_EQ(locator.TakeBuilds(), 1U);
  locator.GetCloud()->Modified();
  locator->UseExistingSearchStructureOff();
  EXPECT_EQ(locator.Use(), 1U);
}
#endif

TEST(TestHashedOctreePointLocatorBuild, StartDepthsDoNotRebuild)
{
  CountedLocator locator;
  locator->SetStartDepthModel(Class::Fixed); // Before there is a tree.
  locator->SetFixedStartDepth(5);
  EXPECT_EQ(locator.Use(), 1U);
  EXPECT_EQ(locator->GetStartDepth(), 5);
  const auto change = [&locator]
  {
    const vtkMTimeType modified = locator->GetMTime();
    locator->SetFixedStartDepth(7);
    EXPECT_EQ(locator->GetStartDepth(), 7);
    EXPECT_GT(locator->GetMTime(), modified);
    locator->SetFrequencyModel(Class::Points);
    locator->SetStartDepthModel(Class::Root);
    EXPECT_EQ(locator->GetStartDepth(), 0);
    locator->SetStartDepthModel(Class::Fixed);
    locator->SetFixedStartDepth(5);
  };
  change();
  EXPECT_EQ(locator.Use(), 0U);
  const vtkMTimeType modified = locator->GetMTime();
  locator->SetFixedStartDepth(5); // As it is.
  EXPECT_EQ(locator->GetMTime(), modified);
  // But they must not hide that a build is due.
  locator.GetCloud()->Modified();
  change();
  EXPECT_EQ(locator.Use(), 1U);
  locator->Modified();
  change();
  EXPECT_EQ(locator.Use(), 1U);
}

TEST(TestHashedOctreePointLocatorBuild, StartDepthsAreThoseOfTheModels)
{
  // Two points share the cells of the depths 0 to 4, and the third leaves them at once: seven
  // leaves at each of the depths 1 to 4, eight at 5.
  TestedLocator locator(MakePolyData<double>({ 0, 0, 0, 1.0 / 32, 0, 0, 1, 1, 1 }));
  locator->SetMaxPointsPerLeaf(1);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetLevel(), 5);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 4 * 7 + 8);
  EXPECT_EQ(locator->GetStartDepth(), 3);
  locator->SetStartDepthModel(Class::Mean);
  EXPECT_EQ(locator->GetStartDepth(), 3);
  locator->SetFrequencyModel(Class::Points);
  EXPECT_EQ(locator->GetStartDepth(), 4); // (1 + 5 + 5) / 3, rounded.
  locator->SetStartDepthModel(Class::Median);
  EXPECT_EQ(locator->GetStartDepth(), 5);
  locator->SetFrequencyModel(Class::Grid);
  EXPECT_EQ(locator->GetStartDepth(), 1);
  locator->SetStartDepthModel(Class::Root);
  EXPECT_EQ(locator->GetStartDepth(), 0);
}

TEST(TestHashedOctreePointLocatorBuild, TellsOfItsTree)
{
  const std::vector<float> coordinates = MakeUniformPoints<3, float>(10000, 31, -3.0, 5.0);
  const auto cloud = MakePolyData(coordinates);
  TestedLocator locator(cloud);
  locator->BuildLocator();
  double bounds[6];
  locator->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(bounds[i], cloud->GetBounds()[i]);
    EXPECT_EQ(locator->GetBounds()[i], bounds[i]);
  }
  EXPECT_GT(locator->GetNumberOfBuckets(), 10000 / 64);
  EXPECT_GT(locator->GetLevel(), 2);
  EXPECT_LT(locator->GetLevel(), 10);
  EXPECT_GE(locator->GetIndexBytes(), 10000 * 16); // Coordinates and ids at least.
  EXPECT_LE(locator->GetIndexBytes(), 10000 * 64);
  TestedLocator ofDoubles(
    MakePolyData(std::vector<double>(coordinates.begin(), coordinates.end())));
  ofDoubles->BuildLocator();
  // But for what stands behind the last coordinate.
  EXPECT_NEAR(static_cast<double>(ofDoubles->GetIndexBytes() - locator->GetIndexBytes()),
    10000 * 3 * (sizeof(double) - sizeof(float)), 100)
    << "floats stay floats";

  locator->SetMaxDepth(2);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetLevel(), 2);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 64);
  locator->SetMaxLevel(0);
  locator->BuildLocator();
  EXPECT_EQ(locator->GetLevel(), 0);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 1);
  EXPECT_EQ(locator->FindClosestPoint(cloud->GetPoint(77)), 77);

  locator->FreeSearchStructure();
  EXPECT_EQ(locator->GetIndexBytes(), 0);
  EXPECT_EQ(locator->GetNumberOfBuckets(), 0);
}

TEST(TestHashedOctreePointLocatorBuild, TooManyPointsAreAnError)
{
  if (sizeof(hashedoctree::PointIndex) > 4)
  {
    GTEST_SKIP() << "no memory holds too many for 64 bits";
  }
  // The number alone is looked at, so that one point does for all.
  const vtkIdType count = (vtkIdType(1) << 32) - 1;
  float x[3] = { 0.0F, 0.0F, 0.0F };
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetArray(x, 3 * count, /*save=*/1);
  const auto cloud = MakePolyData<float>({});
  cloud->GetPoints()->SetData(coordinates);
  TestedLocator locator(cloud);
  locator->BuildLocator();
  locator.ExpectError("32 bits");
  locator.ExpectToFindNothing();
}

TEST(TestHashedOctreePointLocatorBuild, WhoHearsOfAProblemMayAskAtOnce)
{
  struct Listener
  {
    TestedLocator& Asked;
    std::vector<vtkIdType> Found;
    void Ask(vtkObject*, unsigned long, void*)
    {
      if (this->Found.size() < 3) // If that builds, and so on, without an end.
      {
        this->Found.push_back(this->Asked->FindClosestPoint(0.9, 0, 0));
      }
    }
  };
  TestedLocator ofPoints(MakePolyData<float>({ 0, 0, 0, NAN, 0, 0, 1, 0, 0 }));
  Listener warned{ ofPoints, {} };
  ofPoints->AddObserver(vtkCommand::WarningEvent, &warned, &Listener::Ask);
  EXPECT_EQ(ofPoints->FindClosestPoint(0.1, 0, 0), 0);
  EXPECT_EQ(warned.Found, std::vector<vtkIdType>{ 2 });
  ofPoints.ExpectWarningOfSkippedPoints(1);

  vtkNew<vtkImageData> image;
  image->SetDimensions(1 << 21, 1 << 20, 1 << 20);
  TestedLocator ofTooMany(image);
  Listener failed{ ofTooMany, {} };
  ofTooMany->AddObserver(vtkCommand::ErrorEvent, &failed, &Listener::Ask);
  EXPECT_EQ(ofTooMany->FindClosestPoint(0.1, 0, 0), -1);
  EXPECT_EQ(failed.Found, std::vector<vtkIdType>{ -1 });
  EXPECT_EQ(ofTooMany.Errors.size(), 1U);
  ofTooMany.Errors.clear();
}

TEST(TestHashedOctreePointLocatorBuild, WhoHearsOfAProblemMayFreeTheTree)
{
  TestedLocator locator(MakePolyData<float>({ 0, 0, 0, NAN, 0, 0, 1, 0, 0 }));
  Freeing listener{ locator };
  locator->AddObserver(vtkCommand::WarningEvent, &listener, &Freeing::Free);
  EXPECT_EQ(locator->FindClosestPoint(0.1, 0, 0), 0) << "in a tree that is built anew";
  locator.ExpectWarningOfSkippedPoints(1);
  EXPECT_EQ(locator->FindClosestPoint(0.9, 0, 0), 2) << "in the same";
  EXPECT_TRUE(locator.Warnings.empty());
}

TEST(TestHashedOctreePointLocatorBuild, WhoHearsOfAChangedModelMayChangeThePoints)
{
  struct Listener
  {
    vtkHashedOctreePointLocator* Locator;
    vtkPolyData* Cloud;
    vtkIdType Found = -2;
    void Observe(vtkObject*, unsigned long, void*)
    {
      this->Found = this->Locator->FindClosestPoint(9, 9, 9);
      this->Cloud->GetPoints()->SetPoint(0, 9, 9, 9);
      this->Cloud->GetPoints()->Modified();
    }
  };
  const auto cloud = MakePolyData<float>({ 0, 0, 0, 1, 0, 0, NAN, 0, 0 });
  TestedLocator locator(cloud);
  locator->BuildLocator();
  locator.ExpectWarningOfSkippedPoints(1);
  Listener listener{ locator.Get(), cloud };
  locator->AddObserver(vtkCommand::ModifiedEvent, &listener, &Listener::Observe);
  locator->SetStartDepthModel(vtkHashedOctreePointLocator::Root);
  EXPECT_EQ(listener.Found, 1);
  EXPECT_TRUE(locator.Warnings.empty()) << "the model alone asks for no new tree";
  EXPECT_EQ(locator->FindClosestPoint(9, 9, 9), 0) << "the points do";
  locator.ExpectWarningOfSkippedPoints(1);
}

TEST(TestHashedOctreePointLocatorBuild, MorePointsThanCanBeCopiedAreAnError)
{
  vtkNew<vtkImageData> image; // As a data set without an array of points; 24 bytes for each are
  image->SetDimensions(1 << 21, 1 << 20, 1 << 20); // more than a size_t can count.
  TestedLocator locator(image);
  EXPECT_EQ(locator->FindClosestPoint(1.0, 1.0, 1.0), -1);
  locator.ExpectError(sizeof(hashedoctree::PointIndex) == 4 ? "more points than 32 bits can number"
                                                            : "not enough memory");
  locator.ExpectToFindNothing();
}

TEST(TestHashedOctreePointLocatorBuild, ANewInstanceWorks)
{
  vtkNew<vtkHashedOctreePointLocator> first;
  const auto second = vtk::TakeSmartPointer(first->NewInstance());
  const auto cloud = MakePolyData<float>({ 0, 0, 0, 1, 0, 0 });
  second->SetDataSet(cloud);
  second->Modified();
  EXPECT_EQ(second->FindClosestPoint(0.9, 0, 0), 1);
  EXPECT_STREQ(second->GetClassName(), "vtkHashedOctreePointLocator");
  EXPECT_TRUE(second->IsA("vtkAbstractPointLocator"));
}

TEST(TestHashedOctreePointLocatorBuild, PrintsItsProperties)
{
  vtkNew<vtkHashedOctreePointLocator> locator;
  locator->SetMaxPointsPerLeaf(12345);
  std::ostringstream text;
  locator->Print(text);
  for (const char* words : { "MaxPointsPerLeaf: 12345", "MaxDepth: 21", "FrequencyModel: 0",
         "StartDepthModel: 0", "FixedStartDepth: 0", " StartDepth: 0", "IndexBytes: 0", "DataSet" })
  {
    EXPECT_NE(text.str().find(words), std::string::npos) << words;
  }
}

TEST(TestHashedOctreePointLocatorBuild, ALoopWithItsPointSetIsCollected)
{
  vtkWeakPointer<vtkHashedOctreePointLocator> locator;
  vtkWeakPointer<vtkPolyData> cloud;
  {
    const auto data = MakePolyData<float>({ 0, 0, 0, 1, 0, 0 });
    vtkNew<vtkHashedOctreePointLocator> own;
    own->SetDataSet(data);
    data->SetPointLocator(own);
    double x[3] = { 0.9, 0, 0 };
    EXPECT_EQ(data->FindPoint(x), 1);
    locator = own.Get();
    cloud = data.Get();
  }
  EXPECT_EQ(locator.GetPointer(), nullptr);
  EXPECT_EQ(cloud.GetPointer(), nullptr);
}
