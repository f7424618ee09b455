// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "SameOutputs.h"
#include "TestedLocateFilter.h"
#include "TestedNeighborsFilter.h"

#include "vtkDataSetAttributes.h"
#include "vtkDummyController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using Filter = vtkHashedOctreeNeighborsFilter;
using Change = std::function<void(Filter*)>;
constexpr std::size_t Count = 300;

/** Moves points in their arrays without Modified(): only an octree that is built after it, and not
 * one that was kept, knows of it. */
void MoveSilently(vtkPointSet* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    data->GetPoints()->SetPoint(i, std::fmod(x[0] + 0.3, 1.0), x[1], x[2]);
  }
}

/** Tells neither of its points nor of its arrays, as some data sets do. */
class QuietPolyData : public vtkPolyData
{
public:
  static QuietPolyData* New();
  vtkTypeMacro(QuietPolyData, vtkPolyData);
  vtkMTimeType GetMTime() override { return this->MTime.GetMTime(); }
};
vtkStandardNewMacro(QuietPolyData);

/** Does something once, when progress has come to a fraction. */
struct Observer
{
  double From;
  std::function<void()> Act;
  bool HasActed = false;
  void Look(vtkObject*, unsigned long, void* progress)
  {
    if (!this->HasActed && *static_cast<const double*>(progress) >= this->From)
    {
      this->HasActed = true;
      this->Act();
    }
  }
};

vtkDataObject* GetBlock(TestedNeighborsFilter& filter, unsigned block)
{
  return vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetBlock(block);
}

/** Expects what a filter with the same properties gives that has never kept anything. */
void ExpectAsBuiltAnew(TestedNeighborsFilter& filter, vtkDataObject* input)
{
  // To run on the input itself would tell the filter that it was generated again.
  const auto copy = vtk::TakeSmartPointer(input->NewInstance());
  copy->ShallowCopy(input);
  TestedNeighborsFilter other;
  other->SetInputData(copy);
  other->SetMaxPointsPerLeaf(filter->GetMaxPointsPerLeaf());
  other->SetMaxDepth(filter->GetMaxDepth());
  other->SetMergePoints(filter->GetMergePoints());
  other->SetDimension(filter->GetDimension());
  other->SetPlane(filter->GetPlane());
  other->SetFrequencyModel(filter->GetFrequencyModel());
  other->SetStartDepthModel(filter->GetStartDepthModel());
  other->SetFixedStartDepth(filter->GetFixedStartDepth());
  other->SetIncludeEmptyLeaves(filter->GetIncludeEmptyLeaves());
  other->SetSearchMode(filter->GetSearchMode());
  other->SetCenter(filter->GetCenter());
  other->SetRadius(filter->GetRadius());
  other->SetUseLeafKey(filter->GetUseLeafKey());
  other->SetLeafKey(filter->GetLeafKey());
  filter.Update();
  other.Update();
  ASSERT_GT(filter.GetCells()->GetNumberOfCells(), 1);
  ExpectSame(filter.GetCells(), other.GetCells());
}
}

TEST(TestKeptOctrees, WhatIsOfSearchesOnlyBuildsNoOther)
{
  const auto points = MakeUniform(Count, 31);
  const auto asBuilt = MakeUniform(Count, 31);
  TestedNeighborsFilter filter;
  filter->SetInputData(points);
  filter->SetCenter(asBuilt->GetPoint(0));
  ExpectAsBuiltAnew(filter, asBuilt);
  const std::int64_t key = filter.Get("MortonKey", 0);
  MoveSilently(points);
  const std::vector<Change> changes{ [](Filter* f) { f->SetCenter(0.2, 0.3, 0.4); },
    [](Filter* f) { f->SetSearchMode(Filter::InRadius); }, [](Filter* f) { f->SetRadius(0.25); },
    [](Filter* f) { f->SetStartDepthModel(Filter::Fixed); },
    [](Filter* f) { f->SetFixedStartDepth(3); },
    [](Filter* f) { f->SetStartDepthModel(Filter::Mean); },
    [](Filter* f) { f->SetFrequencyModel(Filter::Grid); }, [key](Filter* f) { f->SetLeafKey(key); },
    [](Filter* f) { f->UseLeafKeyOn(); }, [](Filter* f) { f->IncludeEmptyLeavesOff(); } };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    SCOPED_TRACE(i);
    const int executions = filter.Executions;
    changes[i](filter.GetFilter());
    ExpectAsBuiltAnew(filter, asBuilt);
    EXPECT_EQ(filter.Executions, executions + 1);
  }
}

TEST(TestKeptOctrees, WhateverElseChangesBuildsAnother)
{
  const auto points = MakeUniform(Count, 32);
  vtkNew<vtkDummyController> controller;
  TestedNeighborsFilter filter;
  filter->SetInputData(points);
  filter->SetCenter(0.5, 0.5, 0.5);
  ExpectAsBuiltAnew(filter, points);
  const std::vector<Change> changes{ [](Filter* f) { f->SetMaxPointsPerLeaf(2); },
    [](Filter* f) { f->SetMaxDepth(5); }, [](Filter* f) { f->MergePointsOn(); },
    [](Filter* f) { f->SetDimension(Filter::Two); }, [](Filter* f) { f->SetPlane(Filter::YZ); },
    [&](Filter* f) { f->SetController(controller); }, [](Filter* f) { f->Modified(); },
    [&](Filter*) { points->Modified(); }, [&](Filter*) { points->GetPoints()->Modified(); },
    [&](Filter*) { points->GetPoints()->GetData()->Modified(); },
    [&](Filter*)
    {
      vtkNew<vtkUnsignedCharArray> marks;
      marks->SetName(vtkDataSetAttributes::GhostArrayName());
      marks->SetNumberOfTuples(static_cast<vtkIdType>(Count));
      marks->FillValue(0);
      marks->SetValue(7, vtkDataSetAttributes::DUPLICATEPOINT);
      points->GetPointData()->AddArray(marks);
    } };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    SCOPED_TRACE(i);
    MoveSilently(points);
    changes[i](filter.GetFilter());
    filter->SetCenter(0.5, 0.5, 0.4 + 0.01 * static_cast<double>(i));
    ExpectAsBuiltAnew(filter, points);
  }
  const auto others = MakeUniform(Count, 33);
  filter->SetInputData(others);
  ExpectAsBuiltAnew(filter, others);
}

TEST(TestKeptOctrees, PointsThatAreGeneratedAgainAreBuiltAgain)
{
  const auto points = MakeUniform(Count, 40);
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(points);
  TestedNeighborsFilter filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetCenter(0.5, 0.5, 0.5);
  filter.Update();
  MoveSilently(points);
  source->Modified();
  ExpectAsBuiltAnew(filter, points);
}

TEST(TestKeptOctrees, PointsAreAskedForTheirTimesThemselves)
{
  vtkNew<QuietPolyData> points;
  points->ShallowCopy(MakeUniform(Count, 41));
  TestedNeighborsFilter filter;
  filter->SetInputData(points);
  filter->SetCenter(0.5, 0.5, 0.5);
  filter.Update();
  for (vtkObject* changed : { static_cast<vtkObject*>(points->GetPoints()),
         static_cast<vtkObject*>(points->GetPoints()->GetData()),
         static_cast<vtkObject*>(points->GetPointData()) })
  {
    SCOPED_TRACE(changed->GetClassName());
    MoveSilently(points);
    changed->Modified();
    filter->SetRadius(filter->GetRadius() + 1.0);
    ExpectAsBuiltAnew(filter, points);
  }
}

TEST(TestKeptOctrees, ObserversMayChangeTheNextBlock)
{
  const auto first = MakeUniform(Count, 42);
  const auto second = MakeUniform(Count, 43);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  TestedNeighborsFilter filter;
  filter->SetInputData(blocks);
  filter->SetCenter(0.5, 0.5, 0.5);
  filter.UpdateWithoutErrors();
  Observer observer{ 0.01,
    [&]
    {
      MoveSilently(second);
      second->Modified();
    } };
  filter->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::Look);
  filter->SetCenter(0.4, 0.5, 0.5);
  filter.UpdateWithoutErrors();
  ASSERT_TRUE(observer.HasActed);
  TestedNeighborsFilter other;
  other->SetInputData(blocks);
  other->SetCenter(0.4, 0.5, 0.5);
  other.UpdateWithoutErrors();
  ExpectSame(GetBlock(filter, 1), GetBlock(other, 1));
}

TEST(TestKeptOctrees, EachBlockHasItsOwn)
{
  const auto makeBlocks = [](vtkPolyData* first, vtkPolyData* second)
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, first);
    blocks->SetBlock(1, second);
    return blocks;
  };
  const auto stays = MakeUniform(Count, 34);
  const auto changes = MakeUniform(Count, 35);
  TestedNeighborsFilter filter;
  const auto blocks = makeBlocks(stays, changes);
  filter->SetInputData(blocks);
  filter->SetCenter(0.5, 0.5, 0.5);
  filter.UpdateWithoutErrors();

  MoveSilently(stays);
  MoveSilently(changes);
  changes->Modified();
  filter->SetCenter(0.3, 0.5, 0.5);
  filter.UpdateWithoutErrors();
  TestedNeighborsFilter other;
  other->SetInputData(makeBlocks(MakeUniform(Count, 34), changes));
  other->SetCenter(0.3, 0.5, 0.5);
  other.UpdateWithoutErrors();
  for (const unsigned block : { 0U, 1U })
  {
    SCOPED_TRACE(block);
    ExpectSame(GetBlock(filter, block), GetBlock(other, block));
  }
}

TEST(TestKeptOctrees, OtherQueryPointsAreLocatedInIt)
{
  const auto points = MakeUniform(Count, 36);
  const auto queries = MakeUniform(50, 37);
  TestedLocateFilter filter(points, queries);
  filter.Update();
  MoveSilently(points);
  queries->GetPoints()->SetPoint(0, 0.1, 0.2, 0.3);
  queries->GetPoints()->Modified();
  filter.Update();
  TestedLocateFilter other(MakeUniform(Count, 36), queries);
  other.Update();
  ExpectSameArrays(filter.GetLocated()->GetPointData(), other.GetLocated()->GetPointData());
  EXPECT_EQ(filter.GetTableValue("Best for these queries", "MeasuredMean"),
    other.GetTableValue("Best for these queries", "MeasuredMean"));

  points->Modified();
  filter.Update();
  TestedLocateFilter moved(points, queries);
  moved.Update();
  ExpectSameArrays(filter.GetLocated()->GetPointData(), moved.GetLocated()->GetPointData());
}

TEST(TestKeptOctrees, ObserversMayChangeWhatTheyDependOn)
{
  for (const double from : { 0.01, 0.1, 0.2, 0.5, 0.9 }) // While it is built, and after it.
  {
    for (const bool ofPoints : { false, true })
    {
      SCOPED_TRACE(std::to_string(from) + (ofPoints ? " points" : " properties"));
      const auto points = MakeUniform(Count, 38);
      TestedNeighborsFilter filter;
      filter->SetInputData(points);
      filter->SetCenter(0.5, 0.5, 0.5);
      Observer observer{ from,
        [&]
        {
          if (ofPoints)
          {
            points->Modified();
          }
          else
          {
            filter->SetMaxPointsPerLeaf(4);
          }
        } };
      const unsigned long tag =
        filter->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::Look);
      filter.Update();
      filter->RemoveObserver(tag);
      if (ofPoints)
      {
        MoveSilently(points);
      }
      filter->SetCenter(0.4, 0.5, 0.5);
      ExpectAsBuiltAnew(filter, points);
    }
  }
}

TEST(TestKeptOctrees, WhatASourceMadeMayChangeWhileItIsBuilt)
{
  for (const double from : { 0.01, 0.1 })
  {
    vtkNew<vtkSphereSource> source; // Does not run again where its output tells of a change.
    TestedNeighborsFilter filter;
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetCenter(0.5, 0.0, 0.0);
    Observer observer{ from, [&] { source->GetOutput()->Modified(); } };
    filter->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::Look);
    filter.Update();
    ASSERT_TRUE(observer.HasActed);
    MoveSilently(source->GetOutput());
    filter->SetCenter(0.4, 0.0, 0.0);
    ExpectAsBuiltAnew(filter, source->GetOutput());
  }
}

TEST(TestKeptOctrees, EachUpdateWarnsOfPointsThatAreLeftOut)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> coordinates = MakeUniformPoints<3, double>(Count, 39);
  coordinates[4] = nan;
  TestedNeighborsFilter filter(coordinates);
  for (const double x : { 0.4, 0.5, 0.6 })
  {
    filter->SetCenter(x, 0.5, 0.5);
    filter.Update();
    filter.ExpectWarning("1 of 300");
    EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 1.0);
  }
}
