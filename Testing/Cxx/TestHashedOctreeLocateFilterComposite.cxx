// SPDX-License-Identifier: BSD-3-Clause
#include "EmptyAmr.h"
#include "SameOutputs.h"
#include "StopAt.h"
#include "TestedLocateFilter.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkNonOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUniformGrid.h"

#include <functional>
#include <limits>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

using Blocks = std::vector<vtkSmartPointer<vtkDataObject>>;

/** Makes a composite data set of some kind. */
using Compose = std::function<vtkSmartPointer<vtkDataObjectTree>(const Blocks&)>;

vtkSmartPointer<vtkDataObjectTree> MakeMultiBlock(const Blocks& blocks)
{
  auto composite = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned i = 0; i < blocks.size(); ++i)
  {
    composite->SetBlock(i, blocks[i]);
  }
  return composite;
}

template <typename Partitions>
vtkSmartPointer<vtkDataObjectTree> MakePartitions(const Blocks& blocks)
{
  auto composite = vtkSmartPointer<Partitions>::New();
  for (unsigned i = 0; i < blocks.size(); ++i)
  {
    composite->SetPartition(i, blocks[i]);
  }
  return composite;
}

/** All blocks but the last are partitions of one data set. */
vtkSmartPointer<vtkDataObjectTree> MakeCollection(const Blocks& blocks)
{
  auto composite = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned i = 0; i + 1 < blocks.size(); ++i)
  {
    composite->SetPartition(0, i, blocks[i]);
  }
  composite->SetPartition(1, 0, blocks.back());
  return composite;
}

/** The last block beside a multi-block data set and a multi-piece one, which hold all others. */
vtkSmartPointer<vtkDataObjectTree> MakeNested(const Blocks& blocks)
{
  const auto half = blocks.begin() + static_cast<std::ptrdiff_t>(blocks.size() / 2);
  return MakeMultiBlock({ MakeMultiBlock(Blocks(blocks.begin(), half)),
    MakePartitions<vtkMultiPieceDataSet>(Blocks(half, blocks.end() - 1)), blocks.back() });
}

const std::vector<Compose> Kinds{ MakeMultiBlock, MakePartitions<vtkPartitionedDataSet>,
  MakeCollection, MakeNested };

/** Calls function(iterator) for each place in a tree that is not composite, empty ones too. */
template <typename Function>
void ForEachPlace(vtkDataObjectTree* tree, const Function& function)
{
  const auto places = vtk::TakeSmartPointer(tree->NewTreeIterator());
  places->SkipEmptyNodesOff();
  for (places->InitTraversal(); !places->IsDoneWithTraversal(); places->GoToNextItem())
  {
    SCOPED_TRACE("block " + std::to_string(places->GetCurrentFlatIndex()));
    function(places.Get());
  }
}

bool HasPoints(vtkDataObject* block)
{
  auto* points = vtkDataSet::SafeDownCast(block);
  return points != nullptr && points->GetNumberOfPoints() > 0;
}

bool HasFinitePoints(vtkDataObject* block)
{
  return HasPoints(block) && !std::isnan(vtkDataSet::SafeDownCast(block)->GetPoint(0)[0]);
}

void ExpectSameTables(vtkTable* a, vtkTable* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfRows(), b->GetNumberOfRows());
  ASSERT_EQ(a->GetNumberOfColumns(), b->GetNumberOfColumns());
  for (vtkIdType column = 0; column < a->GetNumberOfColumns(); ++column)
  {
    EXPECT_STREQ(a->GetColumnName(column), b->GetColumnName(column));
    for (vtkIdType row = 0; row < a->GetNumberOfRows(); ++row)
    {
      EXPECT_TRUE(a->GetValue(row, column) == b->GetValue(row, column)) << row << ", " << column;
    }
  }
}

/** Nothing was found of these queries, and nothing spent. */
void ExpectNotLocated(vtkDataObject* located, vtkDataObject* table, vtkDataSet* queries)
{
  auto* block = vtkDataSet::SafeDownCast(located);
  ASSERT_NE(block, nullptr);
  ASSERT_EQ(block->GetNumberOfPoints(), queries->GetNumberOfPoints());
  for (vtkIdType query = 0; query < block->GetNumberOfPoints(); ++query)
  {
    EXPECT_EQ(block->GetPointData()->GetArray("LeafId")->GetTuple1(query), -1);
    EXPECT_EQ(block->GetPointData()->GetArray("LocalCost")->GetTuple1(query), 0);
  }
  EXPECT_EQ(block->GetFieldData()->GetArray("MeanHitCost")->GetTuple1(0), 0);
  ASSERT_NE(vtkTable::SafeDownCast(table), nullptr);
  for (vtkIdType row = 0; row < 7; ++row)
  {
    EXPECT_EQ(vtkTable::SafeDownCast(table)->GetValueByName(row, "MeasuredMean").ToDouble(), 0);
  }
}

/** What the filter makes of a block of points and one of queries, beside what it makes of these
 * alone. */
void ExpectAsAlone(
  vtkDataObject* located, vtkDataObject* table, vtkDataObject* points, vtkDataObject* queries)
{
  if (!HasFinitePoints(points) || !HasPoints(queries))
  {
    EXPECT_EQ(located, nullptr);
    EXPECT_EQ(table, nullptr);
    return;
  }
  if (!HasFinitePoints(queries))
  {
    ExpectNotLocated(located, table, vtkDataSet::SafeDownCast(queries));
    return;
  }
  TestedLocateFilter alone(points, queries);
  alone.Update();
  auto* block = vtkDataSet::SafeDownCast(located);
  ASSERT_NE(block, nullptr);
  EXPECT_EQ(block->GetDataObjectType(), queries->GetDataObjectType());
  ASSERT_EQ(block->GetNumberOfPoints(), alone.GetLocated()->GetNumberOfPoints());
  EXPECT_EQ(block->GetNumberOfCells(), alone.GetLocated()->GetNumberOfCells());
  ExpectSameArrays(block->GetPointData(), alone.GetLocated()->GetPointData());
  ExpectSameArrays(block->GetFieldData(), alone.GetLocated()->GetFieldData());
  ExpectSameTables(vtkTable::SafeDownCast(table), alone.GetTable());
}

vtkDataObjectTree* GetTree(TestedLocateFilter& filter, int port)
{
  return vtkDataObjectTree::SafeDownCast(filter->GetOutputDataObject(port));
}

/** Both outputs are vtkMultiBlockDataSets with a block for each block of queries, which is one with
 * a block for each block of points; and VTK lets them be so. */
void ExpectNested(TestedLocateFilter& filter, vtkDataObjectTree* points, vtkDataObjectTree* queries)
{
  ASSERT_TRUE(GetTree(filter, 0) && GetTree(filter, 1));
  EXPECT_EQ(GetTree(filter, 0)->GetDataObjectType(), VTK_MULTIBLOCK_DATA_SET);
  EXPECT_EQ(GetTree(filter, 1)->GetDataObjectType(), VTK_MULTIBLOCK_DATA_SET);
  ForEachPlace(queries,
    [&](vtkDataObjectTreeIterator* query)
    {
      vtkDataObject* located = GetTree(filter, 0)->GetDataSet(query);
      vtkDataObject* tables = GetTree(filter, 1)->GetDataSet(query);
      if (!HasPoints(query->GetCurrentDataObject()))
      {
        EXPECT_EQ(located, nullptr);
        EXPECT_EQ(tables, nullptr);
        return;
      }
      auto* locatedBlocks = vtkMultiBlockDataSet::SafeDownCast(located);
      auto* tableBlocks = vtkMultiBlockDataSet::SafeDownCast(tables);
      ASSERT_TRUE(locatedBlocks && tableBlocks);
      ForEachPlace(points,
        [&](vtkDataObjectTreeIterator* point)
        {
          ExpectAsAlone(locatedBlocks->GetDataSet(point), tableBlocks->GetDataSet(point),
            point->GetCurrentDataObject(), query->GetCurrentDataObject());
        });
    });
  for (int port = 0; port < 2; ++port)
  {
    vtkNew<vtkMultiBlockDataSet> copy; // As filters that come after this one make it.
    copy->CopyStructure(GetTree(filter, port));
    const auto blocks = vtk::TakeSmartPointer(GetTree(filter, port)->NewTreeIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      copy->SetDataSet(blocks, blocks->GetCurrentDataObject());
      EXPECT_EQ(copy->GetDataSet(blocks), blocks->GetCurrentDataObject());
    }
  }
}

/** The outputs are of the kind of the one composite input, or a vtkMultiBlockDataSet of tables,
 * with a block for each of its. */
void ExpectStructure(TestedLocateFilter& filter, vtkDataObjectTree* composite,
  const std::function<void(vtkDataObject*, vtkDataObject*, vtkDataObject*)>& expectBlock)
{
  ASSERT_TRUE(GetTree(filter, 0) && GetTree(filter, 1));
  EXPECT_EQ(GetTree(filter, 0)->GetDataObjectType(), composite->GetDataObjectType());
  EXPECT_EQ(GetTree(filter, 1)->GetDataObjectType(), VTK_MULTIBLOCK_DATA_SET);
  ForEachPlace(composite,
    [&](vtkDataObjectTreeIterator* place)
    {
      expectBlock(GetTree(filter, 0)->GetDataSet(place), GetTree(filter, 1)->GetDataSet(place),
        place->GetCurrentDataObject());
    });
}

void ExpectOutputs(TestedLocateFilter& filter, vtkDataObject* points, vtkDataObject* queries)
{
  auto* pointBlocks = vtkDataObjectTree::SafeDownCast(points);
  auto* queryBlocks = vtkDataObjectTree::SafeDownCast(queries);
  if (pointBlocks != nullptr && queryBlocks != nullptr)
  {
    ExpectNested(filter, pointBlocks, queryBlocks);
  }
  else if (queryBlocks != nullptr)
  {
    ExpectStructure(filter, queryBlocks,
      [&](vtkDataObject* located, vtkDataObject* table, vtkDataObject* block)
      { ExpectAsAlone(located, table, points, block); });
  }
  else if (pointBlocks != nullptr)
  {
    ExpectStructure(filter, pointBlocks,
      [&](vtkDataObject* located, vtkDataObject* table, vtkDataObject* block)
      { ExpectAsAlone(located, table, block, queries); });
  }
  else
  {
    ExpectAsAlone(filter->GetOutputDataObject(0), filter->GetOutputDataObject(1), points, queries);
  }
}

/** Each data set as it is, then in a composite one of each kind. */
Blocks MakeInputs(const Blocks& blocks)
{
  Blocks inputs{ blocks.back() };
  for (const Compose& compose : Kinds)
  {
    inputs.push_back(compose(blocks));
  }
  return inputs;
}

Blocks MakeBlocks(unsigned seed)
{
  return { MakeUniform(50, seed), MakeUniform(200, seed + 1), MakeUniform(30, seed + 2),
    MakeUniform(100, seed + 3) };
}

/** With blocks of all kinds in which there is nothing, or not much, to search in or for. */
Blocks MakeBlocksWithGaps(unsigned seed)
{
  return { MakeUniform(50, seed), nullptr, MakePolyData({}), MakeUniform(80, seed + 1),
    MakePolyData({ NotANumber, 0, 0, NotANumber, 1, 1 }), vtkSmartPointer<vtkTable>::New(),
    MakePolyData({ 0.1, 0.2, 0.3, 0.4, NotANumber, 0.6 }), vtkSmartPointer<vtkPolyData>::New(),
    MakeUniform(20, seed + 2) };
}

void SetName(vtkInformation* block, const char* name)
{
  block->Set(vtkCompositeDataSet::NAME(), name);
}

std::string GetName(vtkMultiBlockDataSet* blocks, unsigned block)
{
  const char* name = blocks->GetMetaData(block)->Get(vtkCompositeDataSet::NAME());
  return name != nullptr ? name : "";
}

/** Two blocks of a cell each. */
vtkSmartPointer<vtkNonOverlappingAMR> MakeAmr()
{
  auto amr = MakeEmptyAmr({ 1, 1 });
  for (unsigned level = 0; level < 2; ++level)
  {
    vtkNew<vtkUniformGrid> grid;
    grid->SetDimensions(2, 2, 2);
    grid->SetSpacing(0.3 + level, 0.4, 0.5);
    amr->SetDataSet(level, 0, grid);
  }
  return amr;
}
}

TEST(TestHashedOctreeLocateFilterComposite, EachBlockIsTakenByItself)
{
  // One filter for all of them: its outputs must follow the kinds of its inputs.
  TestedLocateFilter filter;
  for (const auto& points : MakeInputs(MakeBlocks(370)))
  {
    for (const auto& queries : MakeInputs(MakeBlocks(374)))
    {
      SCOPED_TRACE(points->GetClassName() + std::string(", ") + queries->GetClassName());
      filter->SetInputData(0, points);
      filter->SetInputData(1, queries);
      filter.UpdateWithoutErrors();
      ExpectOutputs(filter, points, queries);
    }
  }
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}

TEST(TestHashedOctreeLocateFilterComposite, BlocksWithNothingInThemAreNoError)
{
  for (const auto& points : MakeInputs(MakeBlocksWithGaps(378)))
  {
    for (const auto& queries : MakeInputs(MakeBlocksWithGaps(381)))
    {
      SCOPED_TRACE(points->GetClassName() + std::string(", ") + queries->GetClassName());
      TestedLocateFilter filter(points, queries);
      filter.UpdateWithoutErrors();
      ExpectOutputs(filter, points, queries);
      std::vector<std::string> expected;
      if (points->IsA("vtkCompositeDataSet"))
      {
        expected.emplace_back("3 of 154 points");
      }
      if (queries->IsA("vtkCompositeDataSet"))
      {
        expected.emplace_back("3 of 154 query points");
      }
      ASSERT_EQ(filter.Warnings.size(), expected.size()) << "once for all blocks";
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        EXPECT_NE(filter.Warnings[i].find(expected[i]), std::string::npos) << filter.Warnings[i];
      }
    }
  }
}

TEST(TestHashedOctreeLocateFilterComposite, NoUsableQueryInAnyBlockIsLocated)
{
  const auto nothing = MakePolyData({ NotANumber, 0, 0 });
  for (const Compose& compose : Kinds)
  {
    for (const auto& points : MakeInputs(MakeBlocks(384)))
    {
      TestedLocateFilter filter(points, compose({ MakePolyData({}), nullptr, MakePolyData({}) }));
      filter.UpdateWithoutErrors();
      EXPECT_EQ(filter.Warnings, std::vector<std::string>());
      for (int port = 0; port < 2; ++port)
      {
        ASSERT_NE(GetTree(filter, port), nullptr);
        const auto blocks = vtk::TakeSmartPointer(GetTree(filter, port)->NewTreeIterator());
        blocks->InitTraversal();
        EXPECT_TRUE(blocks->IsDoneWithTraversal());
      }
      filter->SetInputData(1, compose({ nothing, nullptr, nothing, MakePolyData({}) }));
      filter.UpdateWithoutErrors();
      filter.ExpectWarning("2 of 2 query points");
      const auto good = compose({ nothing, MakeUniform(10, 388) });
      filter->SetInputData(1, good);
      filter.UpdateWithoutErrors();
      ExpectOutputs(filter, points, good);
    }
  }
}

TEST(TestHashedOctreeLocateFilterComposite, BlocksKeepTheirNamesAndFieldData)
{
  vtkNew<vtkMultiBlockDataSet> points;
  points->SetBlock(0, MakeUniform(10, 389));
  SetName(points->GetMetaData(0u), "ground");
  vtkNew<vtkPartitionedDataSetCollection> queries;
  queries->SetPartition(0, 0, MakePolyData({}));
  queries->SetPartition(1, 0, MakeUniform(10, 390));
  SetName(queries->GetMetaData(1u), "paths");
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  time->InsertNextValue(3.0);
  queries->GetFieldData()->AddArray(time);
  queries->GetPartitionedDataSet(1)->GetFieldData()->AddArray(time);

  TestedLocateFilter filter(points, queries);
  filter.UpdateWithoutErrors();
  EXPECT_FALSE(queries->HasMetaData(0u)) << "the input is left alone";
  for (int port = 0; port < 2; ++port)
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    ASSERT_NE(output, nullptr);
    EXPECT_EQ(output->GetFieldData()->GetArray("Time"), time);
    ASSERT_EQ(output->GetNumberOfBlocks(), 2U);
    EXPECT_EQ(GetName(output, 0), "");
    EXPECT_EQ(GetName(output, 1), "paths");
    auto* paths = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1));
    ASSERT_NE(paths, nullptr);
    EXPECT_EQ(paths->GetFieldData()->GetArray("Time"), time);
    auto* ofGround = vtkMultiBlockDataSet::SafeDownCast(paths->GetBlock(0));
    ASSERT_NE(ofGround, nullptr);
    EXPECT_EQ(GetName(ofGround, 0), "ground");
  }
}

TEST(TestHashedOctreeLocateFilterComposite, BlocksOfQueriesKeepTheStructureOfPointsThatAreNone)
{
  const auto points = MakeMultiBlock({ MakePolyData({}), nullptr });
  const auto queries = MakeMultiBlock({ MakeUniform(10, 397) });
  TestedLocateFilter filter(points, queries);
  filter.UpdateSilently();
  ExpectNested(filter, points, queries);
}

TEST(TestHashedOctreeLocateFilterComposite, FieldDataOfTheQueriesAreLeftAlone)
{
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  time->InsertNextValue(3.0);
  const auto points = MakeUniform(10, 389);
  points->GetFieldData()->AddArray(time);
  const Blocks blocks{ MakeUniform(10, 390), MakeUniform(10, 391) };
  for (const Compose& compose : Kinds)
  {
    const auto queries = compose(blocks);
    TestedLocateFilter filter(points, queries);
    filter.UpdateSilently();
    for (int port = 0; port < 2; ++port)
    {
      EXPECT_EQ(GetTree(filter, port)->GetFieldData()->GetArray("Time"), time);
    }
    EXPECT_EQ(queries->GetFieldData()->GetNumberOfArrays(), 0) << queries->GetClassName();
  }
}

TEST(TestHashedOctreeLocateFilterComposite, AnEmptyPieceHasTheStructureOfTheQueries)
{
  const auto nothing = MakePolyData({});
  const auto something = MakeUniform(10, 391);
  const std::pair<vtkDataObject*, vtkDataObject*> inputs[] = { { nothing, nothing },
    { nothing, something }, { something, nothing } };
  for (const auto& [points, block] : inputs)
  {
    const auto queries = MakeNested({ block, nullptr, nullptr, block });
    TestedLocateFilter filter(points, queries);
    filter->UpdatePiece(1, 4, 0);
    EXPECT_EQ(filter.Errors, std::vector<std::string>());
    EXPECT_EQ(filter.Warnings, std::vector<std::string>());
    ExpectStructure(filter, queries,
      [](vtkDataObject* located, vtkDataObject* table, vtkDataObject*)
      {
        EXPECT_EQ(located, nullptr);
        EXPECT_EQ(table, nullptr);
      });
  }
}

TEST(TestHashedOctreeLocateFilterComposite, AmrQueriesAreSearchedForInOneDataSet)
{
  const auto points = MakeUniform(100, 392);
  const auto amr = MakeAmr();
  TestedLocateFilter filter(points, amr);
  filter.UpdateWithoutErrors();
  auto* located = vtkNonOverlappingAMR::SafeDownCast(filter->GetOutputDataObject(0));
  auto* tables = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_TRUE(located && tables);
  const auto blocks = vtk::TakeSmartPointer(amr->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    ExpectAsAlone(located->GetDataSet(blocks), tables->GetDataSet(blocks), points,
      blocks->GetCurrentDataObject());
  }
  filter->SetInputData(0, MakeMultiBlock({ points }));
  filter.UpdateExpectingError("AMR query points");
}

TEST(TestHashedOctreeLocateFilterComposite, ProgressMovesThroughAllBlocks)
{
  const Blocks blocks{ MakeUniform(30000, 393), MakeUniform(30000, 394) };
  TestedLocateFilter filter(MakeMultiBlock(blocks), MakeMultiBlock(blocks));
  filter.UpdateWithoutErrors();
  filter.ExpectProgressInSteps(0.15);
}

TEST(TestHashedOctreeLocateFilterComposite, AnAbortLeavesEmptyOutputsAndALaterUpdateSucceeds)
{
  const Blocks blocks{ MakeUniform(30000, 395), MakeUniform(30000, 396) };
  for (const auto& points : { vtkSmartPointer<vtkDataObject>(MakeMultiBlock(blocks)), blocks[0] })
  {
    TestedLocateFilter filter(points, MakeMultiBlock(blocks));
    for (const double fraction : { 0.0, 0.2, 0.4, 0.6, 0.9 })
    {
      SCOPED_TRACE(fraction);
      filter->Modified();
      {
        const StopAt stop(filter.GetFilter(), fraction);
        filter.UpdateWithoutErrors();
      }
      for (int port = 0; port < 2; ++port)
      {
        auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
        ASSERT_NE(output, nullptr);
        EXPECT_EQ(output->GetNumberOfBlocks(), 0U);
      }
      filter->SetAbortExecute(0);
      filter->Modified();
      filter.UpdateWithoutErrors();
      EXPECT_EQ(GetTree(filter, 0)->GetNumberOfPoints(),
        points->IsA("vtkCompositeDataSet") ? 120000 : 60000);
    }
  }
}
