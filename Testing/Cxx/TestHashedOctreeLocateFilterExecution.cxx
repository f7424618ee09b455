// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryLimit.h"
#include "PointSamples.h"
#include "SameOutputs.h"
#include "Sanitized.h"
#include "StopAt.h"
#include "TestedLocateFilter.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

TEST(TestHashedOctreeLocateFilterExecution, ProgressMovesThroughTheWholeRun)
{
  TestedLocateFilter filter(MakeUniform(100000, 360), MakeUniform(100000, 361));
  filter.Update();
  filter.ExpectProgressInSteps(0.25);
}

TEST(TestHashedOctreeLocateFilterExecution, ProgressDoesNotFallWhereCoordinatesAreCopied)
{
  const auto integers = MakePolyData(MakeUniformPoints<3, double>(200000, 366, 0.0, 1e6), VTK_INT);
  for (const int copied : { 0, 1 })
  {
    TestedLocateFilter filter;
    filter->SetInputData(copied, integers);
    filter->SetInputData(1 - copied, MakeUniform(100000, 367));
    filter.Update();
    filter.ExpectProgressInSteps(0.25);
  }
}

TEST(TestHashedOctreeLocateFilterExecution, AnAbortLeavesEmptyOutputsAndALaterUpdateSucceeds)
{
  TestedLocateFilter filter(MakeUniform(100000, 362), MakeUniform(100000, 363));
  for (const double fraction : { 0.0, 0.1, 0.25, 0.4, 0.5, 0.8 })
  {
    SCOPED_TRACE(fraction);
    filter->Modified();
    {
      const StopAt stop(filter.GetFilter(), fraction);
      filter.Update();
    }
    filter.ExpectEmptyOutputs();
    filter->SetAbortExecute(0);
    filter->Modified();
    filter.Update();
    EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), 100000);
    EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 7);
  }
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}

TEST(TestHashedOctreeLocateFilterExecution, AnyNumberOfThreadsGivesTheSame)
{
  const auto points = MakeUniform(100000, 364);
  const auto queries = MakeUniform(100000, 365);
  TestedLocateFilter expected(points, queries);
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 1, "Sequential", false }, [&expected] { expected.Update(); });
  for (const int threads : { 1, 2, 8 }) // VTK takes no more than the machine has.
  {
    TestedLocateFilter filter(points, queries);
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ threads, "STDThread", false }, [&filter] { filter.Update(); });
    ExpectSameArrays(filter.GetLocated()->GetPointData(), expected.GetLocated()->GetPointData());
    ExpectSameArrays(filter.GetLocated()->GetFieldData(), expected.GetLocated()->GetFieldData());
    for (const char* column : { "StartDepth", "PredictedMean", "MeasuredMean" })
    {
      ExpectSameArray(vtkDataArray::SafeDownCast(filter.GetTable()->GetColumnByName(column)),
        vtkDataArray::SafeDownCast(expected.GetTable()->GetColumnByName(column)), column);
    }
  }
}

TEST(TestHashedOctreeLocateFilterExecution, TooManyQueriesAreAnErrorAboutThem)
{
  if (Sanitized)
  {
    GTEST_SKIP() << "sanitizers reserve more memory than the limit";
  }
  vtkNew<vtkImageData> queries;
  queries->SetDimensions(500, 500, 500); // More than what earlier tests have freed.
  TestedLocateFilter filter(MakeUniform(100, 369), queries);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false }, // A thread takes more.
    [&filter]
    {
      const MemoryLimit limit(16 * Megabyte);
      filter.UpdateExpectingError("memory to locate the queries; take fewer of them");
    });
  EXPECT_EQ(filter.GetLocated()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(filter.GetTable()->GetNumberOfColumns(), 0);
  filter->SetQueryPointsData(MakeUniform(20, 368));
  filter.UpdateSilently();
  EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), 20);
}
