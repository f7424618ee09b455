// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "SameOutputs.h"
#include "StopAt.h"
#include "TestedNeighborsFilter.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <limits>

namespace
{
using Filter = vtkHashedOctreeNeighborsFilter;
}

TEST(TestHashedOctreeNeighborsFilterExecution, RunsAgainWhenSomethingChangedOnly)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(60, 95);
  const auto points = MakePolyData(coordinates);
  TestedNeighborsFilter filter;
  filter->SetInputData(points);
  filter->SetCenter(coordinates[0], coordinates[1], coordinates[2]);
  filter.Update();
  filter.Update();
  filter->SetCenter(coordinates[0], coordinates[1], coordinates[2]);
  filter->SetRadius(filter->GetRadius());
  filter.Update();
  EXPECT_EQ(filter.Executions, 1);
  int runs = 1;
  const auto expectToRun = [&filter, &runs]
  {
    filter.Update();
    EXPECT_EQ(filter.Executions, ++runs);
    filter.Update();
    EXPECT_EQ(filter.Executions, runs);
  };
  filter->SetRadius(0.5);
  expectToRun();
  filter->SetSearchMode(Filter::InRadius);
  expectToRun();
  filter->SetCenter(0.25, 0.5, 0.75);
  expectToRun();
  filter->SetLeafKey(filter.Get("MortonKey", 1));
  expectToRun();
  filter->UseLeafKeyOn();
  expectToRun();
  points->Modified();
  expectToRun();
}

TEST(TestHashedOctreeNeighborsFilterExecution, EachBlockHasItsQueryLeaf)
{
  const std::vector<double> first = MakeUniformPoints<3, double>(60, 91);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakePolyData(first));
  blocks->SetBlock(1, vtkSmartPointer<vtkImageData>::New());
  blocks->SetBlock(2, MakeUniform(60, 92));
  TestedNeighborsFilter filter;
  filter->SetInputData(blocks);
  filter->SetCenter(first[0], first[1], first[2]);
  filter.UpdateWithoutErrors();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 3U);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  for (const unsigned block : { 0U, 2U })
  {
    TestedNeighborsFilter single;
    single->SetInputData(blocks->GetBlock(block));
    single->SetCenter(first[0], first[1], first[2]);
    single.Update();
    ExpectSame(output->GetBlock(block), single.GetCells());
  }

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(1, 0, MakePolyData(first));
  filter->SetInputData(collection);
  filter.UpdateWithoutErrors();
  auto* partitions = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(partitions, nullptr);
  EXPECT_NE(partitions->GetPartitionAsDataObject(1, 0), nullptr);
}

TEST(TestHashedOctreeNeighborsFilterExecution, TheOutputFollowsTheKindOfTheInput)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(60, 97);
  const auto points = MakePolyData(coordinates);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, points);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, points);
  TestedNeighborsFilter filter;
  filter->SetCenter(coordinates.data());
  for (int round = 0; round < 2; ++round)
  {
    filter->SetInputData(points);
    filter.Update();
    EXPECT_GT(filter.GetCells()->GetNumberOfCells(), 1);
    vtkNew<vtkUnstructuredGrid> cells;
    cells->ShallowCopy(filter.GetCells());
    filter->SetInputData(blocks);
    filter.UpdateWithoutErrors();
    auto* ofBlocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(ofBlocks, nullptr);
    ExpectSame(ofBlocks->GetBlock(0), cells);
    filter->SetInputData(partitions);
    filter.UpdateWithoutErrors();
    auto* ofPartitions = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(ofPartitions, nullptr);
    ExpectSame(ofPartitions->GetPartitionAsDataObject(0), cells);
  }
}

TEST(TestHashedOctreeNeighborsFilterExecution, BlocksWithoutTheQueryLeafStayEmpty)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakePolyData({ 0, 0, 0, 1, 1, 1 }));
  blocks->SetBlock(1, MakePolyData({ 0, 0, 0, 1, 1, 1, 0, 0, 1 }));
  TestedNeighborsFilter filter;
  filter->SetInputData(blocks);
  filter->IncludeEmptyLeavesOff();
  filter->SetCenter(0.1, 0.1, 0.9);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("of 1 of 2 octrees");
  const auto expectSecondOnly = [&filter]
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(output, nullptr);
    EXPECT_EQ(output->GetBlock(0), nullptr);
    EXPECT_NE(output->GetBlock(1), nullptr);
  };
  expectSecondOnly();

  filter->UseLeafKeyOn();
  filter->SetLeafKey(9);
  filter.UpdateWithoutErrors();
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
  expectSecondOnly();
  filter->SetLeafKey(10);
  filter.UpdateExpectingError("LeafKey 10");
}

TEST(TestHashedOctreeNeighborsFilterExecution, AnAbortLeavesAnEmptyOutputAndALaterUpdateSucceeds)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(20000, 96);
  TestedNeighborsFilter filter(coordinates);
  filter->SetCenter(coordinates[0], coordinates[1], coordinates[2]);
  filter->SetSearchMode(Filter::InRadius);
  filter->SetRadius(std::numeric_limits<double>::infinity());
  filter.Update();
  EXPECT_TRUE(std::is_sorted(filter.Progress.begin(), filter.Progress.end()));
  EXPECT_EQ(filter.Progress.back(), 1.0);
  EXPECT_GT(filter.GetCells()->GetNumberOfCells(), 10000);
  for (const double fraction : { 0.0, 0.1, 0.5 })
  {
    SCOPED_TRACE(fraction);
    const StopAt stop(filter.GetFilter(), fraction);
    filter->Modified();
    filter.UpdateWithoutErrors();
    filter.ExpectEmptyOutputs();
  }
  filter->SetAbortExecute(0);
  filter->Modified();
  filter.Update();
  EXPECT_GT(filter.GetCells()->GetNumberOfCells(), 10000);
}
