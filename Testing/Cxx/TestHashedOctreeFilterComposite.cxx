// SPDX-License-Identifier: BSD-3-Clause
#include "FieldValue.h"
#include "PointSamples.h"
#include "SameOutputs.h"
#include "TestedFilter.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/** What the filter makes of a block by itself. */
std::vector<vtkSmartPointer<vtkDataObject>> MakeOutputsOf(vtkDataObject* block)
{
  TestedFilter filter;
  filter->SetInputData(block);
  return TakeOutputs(filter.GetFilter());
}

template <typename Composite>
Composite* GetOutput(TestedFilter& filter, int port)
{
  return Composite::SafeDownCast(filter->GetOutputDataObject(port));
}
}

TEST(TestHashedOctreeFilterComposite, CornersOfAnOctreeInSomeBlocksAreOneWarning)
{
  const auto points = MakeUniform(100, 49);
  const auto octree = MakeOutputsOf(points)[0];
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, octree);
  input->SetBlock(1, octree);
  input->SetBlock(2, points);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("corners");
}

TEST(TestHashedOctreeFilterComposite, EachBlockOfAMultiBlockHasItsTree)
{
  const auto first = MakeUniform(100, 50);
  const auto second = MakeUniform(100, 51);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, MakePolyData({}));
  inner->SetBlock(1, second);
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, first);
  input->SetBlock(1, nullptr);
  input->SetBlock(2, image);
  input->SetBlock(3, inner);
  input->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "inner");

  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("images: 1.");
  const auto outputsOfFirst = MakeOutputsOf(first);
  const auto outputsOfSecond = MakeOutputsOf(second);
  for (int port = 0; port < 3; ++port)
  {
    SCOPED_TRACE(port);
    auto* output = GetOutput<vtkMultiBlockDataSet>(filter, port);
    ASSERT_NE(output, nullptr);
    ASSERT_EQ(output->GetNumberOfBlocks(), 4U);
    ExpectSame(output->GetBlock(0), outputsOfFirst[static_cast<std::size_t>(port)]);
    EXPECT_EQ(output->GetBlock(1), nullptr);
    EXPECT_EQ(output->GetBlock(2), nullptr) << "an image has no points of its own";
    EXPECT_STREQ(output->GetMetaData(3u)->Get(vtkCompositeDataSet::NAME()), "inner");
    auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(3));
    ASSERT_NE(innerOutput, nullptr);
    ASSERT_EQ(innerOutput->GetNumberOfBlocks(), 2U);
    EXPECT_EQ(innerOutput->GetBlock(0), nullptr);
    ExpectSame(innerOutput->GetBlock(1), outputsOfSecond[static_cast<std::size_t>(port)]);
  }
}

TEST(TestHashedOctreeFilterComposite, BlocksWithoutCoordinatesAloneAreAnError)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, image);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateExpectingError("no coordinates of their own");
  input->Modified();
  filter.UpdatePiece(0, 0, 2);
  EXPECT_EQ(filter.Errors, std::vector<std::string>()) << "the other piece may have points";
  filter.ExpectWarning("Blocks left out");
}

TEST(TestHashedOctreeFilterComposite, BlocksWithoutCoordinatesBesidePointsOfAnotherPieceAreNoError)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  const auto points = MakeUniform(3, 50);
  points->AllocatePointGhostArray()->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, image);
  input->SetBlock(1, points);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("Blocks left out");
}

TEST(TestHashedOctreeFilterComposite, AnErrorInALaterBlockLeavesNone)
{
  const auto bad = MakeUniform(30, 59);
  bad->GetPoints()->GetData()->SetNumberOfComponents(2);
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, MakeUniform(30, 58));
  input->SetBlock(1, bad);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateExpectingError("three components");
  for (int port = 0; port < 3; ++port)
  {
    EXPECT_EQ(GetOutput<vtkMultiBlockDataSet>(filter, port)->GetNumberOfBlocks(), 0U) << port;
  }
}

TEST(TestHashedOctreeFilterComposite, OutputsKeepTheFieldDataOfTheirPoints)
{
  const auto block = MakeUniform(100, 54);
  hashedoctree::AddFieldValue<vtkIntArray>(block->GetFieldData(), "Survey", 77);
  hashedoctree::AddFieldValue<vtkIntArray>(
    block->GetFieldData(), "StartDepth", 77); // As the output of the filter has one.
  vtkNew<vtkMultiBlockDataSet> composite;
  composite->SetBlock(0, block);
  hashedoctree::AddFieldValue<vtkIntArray>(composite->GetFieldData(), "Survey", 77);

  TestedFilter single;
  single->SetInputData(block);
  single.Update();
  TestedFilter many;
  many->SetInputData(composite);
  many.UpdateWithoutErrors();
  for (int port = 0; port < 3; ++port)
  {
    auto* blocks = GetOutput<vtkMultiBlockDataSet>(many, port);
    for (vtkDataObject* output : { single->GetOutputDataObject(port), blocks->GetBlock(0),
           GetOutput<vtkDataObject>(many, port) })
    {
      auto* array = output->GetFieldData()->GetArray("Survey");
      ASSERT_NE(array, nullptr) << port;
      EXPECT_EQ(array->GetTuple1(0), 77);
    }
    for (vtkDataObject* output : { single->GetOutputDataObject(port), blocks->GetBlock(0) })
    {
      EXPECT_LT(output->GetFieldData()->GetArray("StartDepth")->GetTuple1(0), 77) << port;
    }
  }
  EXPECT_EQ(block->GetFieldData()->GetNumberOfArrays(), 2) << "the input is left alone";

  block->SetFieldData(nullptr);
  single.Update();
  EXPECT_EQ(single->GetOutputDataObject(1)->GetFieldData()->GetArray("Survey"), nullptr);
  composite->SetFieldData(nullptr);
  composite->Modified();
  many.UpdateWithoutErrors();
  composite->SetFieldData(vtkNew<vtkFieldData>()); // With nothing to pass it to VTK would crash.
  composite->Modified();
  many.UpdateWithoutErrors();
}

TEST(TestHashedOctreeFilterComposite, FieldDataWithoutNamesAreKeptOnce)
{
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, MakeUniform(100, 54));
  vtkNew<vtkIntArray> unnamed;
  for (vtkDataObject* data : { static_cast<vtkDataObject*>(input), input->GetBlock(0) })
  {
    data->GetFieldData()->AddArray(unnamed);
  }
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  const auto countUnnamed = [&unnamed](vtkDataObject* data)
  {
    int count = 0;
    for (int i = 0; i < data->GetFieldData()->GetNumberOfArrays(); ++i)
    {
      count += data->GetFieldData()->GetAbstractArray(i) == unnamed ? 1 : 0;
    }
    return count;
  };
  for (int port = 0; port < 3; ++port)
  {
    auto* blocks = GetOutput<vtkMultiBlockDataSet>(filter, port);
    EXPECT_EQ(countUnnamed(blocks), 1) << port;
    EXPECT_EQ(countUnnamed(blocks->GetBlock(0)), 1) << port;
  }
}

TEST(TestHashedOctreeFilterComposite, EachPartitionHasItsTree)
{
  const auto first = MakeUniform(100, 52);
  const auto second = MakeUniform(100, 53);
  vtkNew<vtkPartitionedDataSet> input;
  input->SetPartition(0, first);
  input->SetPartition(1, second);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  const auto outputs = MakeOutputsOf(second);
  auto* trees = GetOutput<vtkPartitionedDataSet>(filter, 0);
  ASSERT_NE(trees, nullptr);
  ASSERT_EQ(trees->GetNumberOfPartitions(), 2U);
  EXPECT_NE(trees->GetPartitionAsDataObject(0), nullptr);
  ExpectSame(trees->GetPartitionAsDataObject(1), outputs[0]);
  for (std::size_t port = 1; port < 3; ++port)
  {
    auto* tables = GetOutput<vtkMultiBlockDataSet>(filter, static_cast<int>(port));
    ASSERT_NE(tables, nullptr) << "ParaView draws tables of no other kind";
    ASSERT_EQ(tables->GetNumberOfBlocks(), 2U);
    EXPECT_NE(tables->GetBlock(0), nullptr);
    ExpectSame(tables->GetBlock(1), outputs[port]);
  }
}

TEST(TestHashedOctreeFilterComposite, PartitionsOfACollectionHaveTheirTrees)
{
  const auto block = MakeUniform(100, 54);
  vtkNew<vtkPartitionedDataSetCollection> input;
  input->SetPartition(0, 0, MakePolyData({}));
  input->SetPartition(2, 1, block);
  input->GetMetaData(2U)->Set(vtkCompositeDataSet::NAME(), "third");
  input->GetPartitionedDataSet(2)->GetMetaData(0U)->Set(vtkCompositeDataSet::NAME(), "own");
  TestedFilter filter;
  filter->SetOutputType(vtkHashedOctreeFilter::Voxels);
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  const auto outputs = MakeOutputsOf(block);
  auto* trees = GetOutput<vtkPartitionedDataSetCollection>(filter, 0);
  ASSERT_NE(trees, nullptr);
  ASSERT_EQ(trees->GetNumberOfPartitionedDataSets(), 3U);
  EXPECT_EQ(trees->GetPartitionAsDataObject(0, 0), nullptr);
  ExpectSame(trees->GetPartitionAsDataObject(2, 1), outputs[0]);
  for (std::size_t port = 1; port < 3; ++port)
  {
    auto* tables = GetOutput<vtkMultiBlockDataSet>(filter, static_cast<int>(port));
    ASSERT_NE(tables, nullptr) << "ParaView draws tables of no other kind";
    ASSERT_EQ(tables->GetNumberOfBlocks(), 3U);
    EXPECT_STREQ(tables->GetMetaData(2U)->Get(vtkCompositeDataSet::NAME()), "third");
    auto* empty = vtkMultiBlockDataSet::SafeDownCast(tables->GetBlock(0));
    auto* third = vtkMultiBlockDataSet::SafeDownCast(tables->GetBlock(2));
    ASSERT_TRUE(empty && third);
    EXPECT_EQ(empty->GetBlock(0), nullptr);
    ASSERT_EQ(third->GetNumberOfBlocks(), 2U);
    EXPECT_STREQ(third->GetMetaData(1U)->Get(vtkCompositeDataSet::NAME()), "third")
      << "charts tell tables by their names";
    EXPECT_STREQ(third->GetMetaData(0U)->Get(vtkCompositeDataSet::NAME()), "own");
    EXPECT_FALSE(empty->GetMetaData(0U)->Has(vtkCompositeDataSet::NAME()));
    ExpectSame(third->GetBlock(1), outputs[port]);
  }
}

TEST(TestHashedOctreeFilterComposite, OutputsFollowTheKindOfTheInput)
{
  const auto block = MakeUniform(100, 55);
  vtkNew<vtkMultiBlockDataSet> composite;
  composite->SetBlock(0, block);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, block);
  const auto outputs = MakeOutputsOf(block);
  TestedFilter filter;
  for (int round = 0; round < 2; ++round)
  {
    filter->SetInputData(block);
    filter.Update();
    ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
    filter->SetInputData(composite);
    filter.UpdateWithoutErrors();
    for (int port = 0; port < 3; ++port)
    {
      auto* output = GetOutput<vtkMultiBlockDataSet>(filter, port);
      ASSERT_NE(output, nullptr);
      ExpectSame(output->GetBlock(0), outputs[static_cast<std::size_t>(port)]);
    }
    filter->SetInputData(collection);
    filter.UpdateWithoutErrors();
    auto* trees = GetOutput<vtkPartitionedDataSetCollection>(filter, 0);
    ASSERT_NE(trees, nullptr);
    ExpectSame(trees->GetPartitionAsDataObject(0, 0), outputs[0]);
    for (std::size_t port = 1; port < 3; ++port)
    {
      auto* tables = GetOutput<vtkMultiBlockDataSet>(filter, static_cast<int>(port));
      ASSERT_NE(tables, nullptr);
      ExpectSame(
        vtkMultiBlockDataSet::SafeDownCast(tables->GetBlock(0))->GetBlock(0), outputs[port]);
    }
  }
}

TEST(TestHashedOctreeFilterComposite, WarnsOnceForAllBlocks)
{
  vtkNew<vtkMultiBlockDataSet> input;
  for (unsigned i = 0; i < 3; ++i)
  {
    input->SetBlock(i, MakePolyData({ NAN, 0, 0, 1, 2, 3 }));
  }
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("3 of 6 points");
}

TEST(TestHashedOctreeFilterComposite, NoPointsInAnyBlockMakeEmptyBlocks)
{
  vtkNew<vtkMultiBlockDataSet> good;
  good->SetBlock(1, MakeUniform(100, 56));
  vtkNew<vtkMultiBlockDataSet> bad;
  bad->SetBlock(0, MakePolyData({}));
  bad->SetBlock(1, nullptr);
  bad->SetBlock(2, vtkSmartPointer<vtkImageData>::New());
  TestedFilter filter;
  filter->SetInputData(good);
  filter.UpdateWithoutErrors();
  filter->SetInputData(bad);
  filter.UpdateSilently();
  for (int port = 0; port < 3; ++port)
  {
    auto* output = GetOutput<vtkMultiBlockDataSet>(filter, port);
    ASSERT_NE(output, nullptr);
    ASSERT_EQ(output->GetNumberOfBlocks(), 3U);
    for (unsigned block = 0; block < 3; ++block)
    {
      EXPECT_EQ(output->GetBlock(block), nullptr) << block;
    }
  }
  filter->SetInputData(good);
  filter.UpdateWithoutErrors();
  EXPECT_NE(GetOutput<vtkMultiBlockDataSet>(filter, 0)->GetBlock(1), nullptr);
}
