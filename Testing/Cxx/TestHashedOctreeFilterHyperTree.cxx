// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeHyperTree.h"
#include "PlanarPoints.h"
#include "PointSamples.h"
#include "SameOutputs.h"
#include "Sanitized.h"
#include "StopAt.h"
#include "TestedFilter.h"

#include "vtkBitArray.h"
#include "vtkBoundingBox.h"
#include "vtkHyperTree.h"
#include "vtkHyperTreeGrid.h"
#include "vtkHyperTreeGridGeometry.h"
#include "vtkHyperTreeGridNonOrientedGeometryCursor.h"
#include "vtkHyperTreeGridToUnstructuredGrid.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSMPTools.h"

#include <map>

// Hyper tree grids are compared with voxels, which are tested against a plain octree.

using Filter = vtkHashedOctreeFilter;

namespace
{
vtkHyperTreeGrid* GetGrid(TestedFilter& filter)
{
  return vtkHyperTreeGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkHyperTreeGrid* UpdateGrid(TestedFilter& filter)
{
  filter->SetOutputType(Filter::HyperTreeGrid);
  filter.UpdateWithoutErrors();
  return GetGrid(filter);
}

/** GetNumberOfCells(), which VTK has from 9.2 on. */
vtkIdType GetNumberOfNodes(vtkHyperTreeGrid* grid)
{
  return grid->GetNumberOfElements(vtkDataObject::CELL);
}

/** All nodes of the tree of an input as voxels or pixels, found by their keys. */
class NodesByKey
{
public:
  explicit NodesByKey(TestedFilter& filter)
  {
    filter->SetOutputType(Filter::Voxels);
    filter->SetIncludeEmptyLeaves(true);
    filter->SetIncludeInternalNodes(true);
    filter.UpdateWithoutErrors();
    this->Cells.TakeReference(filter.GetCells()->NewInstance());
    this->Cells->ShallowCopy(filter.GetCells());
    vtkDataArray* keys = this->Cells->GetCellData()->GetArray("MortonKey");
    for (vtkIdType cell = 0; cell < this->Cells->GetNumberOfCells(); ++cell)
    {
      this->CellOfKey[keys->GetVariantValue(cell).ToUnsignedLongLong()] = cell;
    }
  }

  std::size_t GetSize() const { return this->CellOfKey.size(); }
  vtkDataSet* GetCells() const { return this->Cells; }
  vtkIdType GetCell(unsigned long long key) const { return this->CellOfKey.at(key); }
  bool IsLeaf(vtkIdType cell) const
  {
    return this->Cells->GetCellData()->GetArray("HitCost")->GetTuple1(cell) > 0.0;
  }
  bool IsEmpty(vtkIdType cell) const
  {
    return this->Cells->GetCellData()->GetArray("PointCount")->GetTuple1(cell) == 0.0;
  }

private:
  vtkSmartPointer<vtkDataSet> Cells;
  std::map<unsigned long long, vtkIdType> CellOfKey;
};

/** Where a cursor is: the same node as the cell with its key, and all below it. */
void ExpectNodes(vtkHyperTreeGridNonOrientedGeometryCursor* cursor, vtkCellData* arrays,
  const NodesByKey& nodes, bool showsEmptyLeaves, std::size_t& visited)
{
  ++visited;
  const vtkIdType vertex = cursor->GetGlobalNodeIndex();
  vtkCellData* expected = nodes.GetCells()->GetCellData();
  const vtkIdType cell =
    nodes.GetCell(arrays->GetArray("MortonKey")->GetVariantValue(vertex).ToUnsignedLongLong());
  ASSERT_EQ(arrays->GetNumberOfArrays(), expected->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(expected->GetArrayName(i));
    ASSERT_EQ(array->GetDataType(), expected->GetArray(i)->GetDataType());
    ASSERT_EQ(array->GetVariantValue(vertex), expected->GetArray(i)->GetVariantValue(cell));
  }
  ASSERT_EQ(cursor->GetLevel(), arrays->GetArray("Depth")->GetTuple1(vertex));
  ASSERT_EQ(cursor->IsLeaf(), nodes.IsLeaf(cell));
  ASSERT_EQ(cursor->IsMasked(), !showsEmptyLeaves && nodes.IsLeaf(cell) && nodes.IsEmpty(cell));

  double bounds[6];
  double cellBounds[6];
  cursor->GetBounds(bounds);
  nodes.GetCells()->GetCellBounds(cell, cellBounds);
  for (int i = 0; i < 6; ++i)
  {
    const double scale =
      std::abs(cellBounds[i]) + vtkBoundingBox(nodes.GetCells()->GetBounds()).GetMaxLength();
    ASSERT_NEAR(bounds[i], cellBounds[i], 32 * std::numeric_limits<double>::epsilon() * scale);
  }
  for (int child = 0; !cursor->IsLeaf() && child < cursor->GetNumberOfChildren(); ++child)
  {
    cursor->ToChild(static_cast<unsigned char>(child));
    ASSERT_NO_FATAL_FAILURE(ExpectNodes(cursor, arrays, nodes, showsEmptyLeaves, visited));
    cursor->ToParent();
  }
}

/** Expects of the hyper tree grid the nodes that there are as voxels or pixels. */
void UpdateAndExpectNodes(TestedFilter& filter)
{
  const NodesByKey nodes(filter);
  for (const bool showsEmptyLeaves : { false, true })
  {
    SCOPED_TRACE(showsEmptyLeaves ? "with empty leaves" : "without empty leaves");
    filter->SetIncludeEmptyLeaves(showsEmptyLeaves);
    vtkHyperTreeGrid* grid = UpdateGrid(filter);
    ASSERT_NE(grid, nullptr);
    ASSERT_EQ(grid->GetMaxNumberOfTrees(), 1);
    ASSERT_EQ(GetNumberOfNodes(grid), static_cast<vtkIdType>(nodes.GetSize()));
    ASSERT_EQ(grid->GetCellData()->GetNumberOfTuples(), static_cast<vtkIdType>(nodes.GetSize()));
    EXPECT_STREQ(grid->GetCellData()->GetScalars()->GetName(), "Depth");
    ASSERT_EQ(grid->GetNumberOfLevels(), filter.GetFieldValue("DeepestDepth") + 1);
    ExpectSameArrays(nodes.GetCells()->GetFieldData(), grid->GetFieldData());
    vtkNew<vtkHyperTreeGridNonOrientedGeometryCursor> cursor;
    grid->InitializeNonOrientedGeometryCursor(cursor, 0);
    std::size_t visited = 0;
    ASSERT_NO_FATAL_FAILURE(
      ExpectNodes(cursor, grid->GetCellData(), nodes, showsEmptyLeaves, visited));
    ASSERT_EQ(visited, nodes.GetSize());
  }
}
}

TEST(TestHashedOctreeFilterHyperTree, HasTheNodesOfAnOctree)
{
  for (const auto& sample : MakeFinitePointSamples<3, double>())
  {
    SCOPED_TRACE(sample.Name);
    TestedFilter filter(sample.Coordinates);
    filter->SetDimension(Filter::Three);
    UpdateAndExpectNodes(filter);
  }
}

TEST(TestHashedOctreeFilterHyperTree, HasTheNodesOfALargeOctree)
{
  // More internal nodes than are split between two reports of progress.
  TestedFilter filter(MakeUniformPoints<3, double>(Sanitized ? 5000 : 150000, 6));
  UpdateAndExpectNodes(filter);
}

TEST(TestHashedOctreeFilterHyperTree, HasTheNodesOfAQuadtreeInItsPlane)
{
  for (const SpacePlane& plane : AllPlanes)
  {
    for (const auto& sample : MakeFinitePointSamples<2, double>())
    {
      SCOPED_TRACE(sample.Name + " in plane " + std::to_string(plane.Name));
      TestedFilter filter(PutInSpace(sample.Coordinates, plane, -2.5));
      filter->SetDimension(Filter::Two);
      filter->SetPlane(plane.Name);
      filter->SetMaxDepth(31);
      UpdateAndExpectNodes(filter);
      EXPECT_EQ(GetGrid(filter)->GetDimension(), 2U);
    }
  }
}

TEST(TestHashedOctreeFilterHyperTree, OfASingleNodeIsItsRoot)
{
  TestedFilter filter({ 3.0, 4.0, 5.0 });
  UpdateAndExpectNodes(filter);
  EXPECT_EQ(GetNumberOfNodes(GetGrid(filter)), 1);
  EXPECT_EQ(GetGrid(filter)->GetMask(), nullptr);
}

TEST(TestHashedOctreeFilterHyperTree, InternalNodesAreAlwaysInIt)
{
  TestedFilter filter(MakeUniformPoints<3, double>(100, 1));
  const vtkIdType nodes = GetNumberOfNodes(UpdateGrid(filter));
  filter->IncludeInternalNodesOn();
  EXPECT_EQ(GetNumberOfNodes(UpdateGrid(filter)), nodes);
}

TEST(TestHashedOctreeFilterHyperTree, HasABranchFactorWithoutNodes)
{
  // Where a file tells no branch factor, VTK's reader ends the program.
  TestedFilter filter(std::vector<double>{});
  EXPECT_EQ(UpdateGrid(filter)->GetBranchFactor(), 2U);
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(1, 0, 0, 1, 0, 1);
  filter->Update();
  EXPECT_EQ(filter.Errors.size(), 1U);
  filter.Errors.clear();
  EXPECT_EQ(GetGrid(filter)->GetBranchFactor(), 2U);
}

TEST(TestHashedOctreeFilterHyperTree, IsTakenByTheFiltersOfVtk)
{
  TestedFilter filter(MakeSpherePoints<3, double>(500, 2));
  for (const bool emptyLeaves : { false, true })
  {
    filter->SetIncludeEmptyLeaves(emptyLeaves);
    filter->SetOutputType(Filter::Voxels);
    filter.Update();
    const vtkIdType cells = filter.GetCells()->GetNumberOfCells();
    double bounds[6];
    filter.GetCells()->GetBounds(bounds);
    vtkNew<vtkHyperTreeGridToUnstructuredGrid> leaves;
    leaves->SetInputData(UpdateGrid(filter));
    leaves->Update();
    EXPECT_EQ(leaves->GetOutput()->GetNumberOfElements(vtkDataObject::CELL), cells);
    vtkNew<vtkHyperTreeGridGeometry> surface;
    surface->SetInputData(GetGrid(filter));
    surface->Update();
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(surface->GetPolyDataOutput()->GetBounds()[i], bounds[i], 1e-6);
    }
  }
}

TEST(TestHashedOctreeFilterHyperTree, IsTheSameByAnyNumberOfThreads)
{
  TestedFilter filter(MakeUniformPoints<3, double>(20000, 3));
  vtkNew<vtkHyperTreeGrid> one;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [&] { one->DeepCopy(UpdateGrid(filter)); });
  filter->Modified();
  vtkHyperTreeGrid* several = nullptr;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 4, "STDThread", false }, [&] { several = UpdateGrid(filter); });
  ExpectSameArrays(one->GetCellData(), several->GetCellData());
  ASSERT_EQ(one->GetMask()->GetNumberOfValues(), several->GetMask()->GetNumberOfValues());
  for (vtkIdType i = 0; i < one->GetMask()->GetNumberOfValues(); ++i)
  {
    ASSERT_EQ(one->GetMask()->GetValue(i), several->GetMask()->GetValue(i)) << i;
    ASSERT_EQ(one->GetTree(0)->IsLeaf(i), several->GetTree(0)->IsLeaf(i)) << i;
  }
}

TEST(TestHashedOctreeFilterHyperTree, EachBlockHasItsGrid)
{
  const auto block = MakeUniform(100, 4);
  TestedFilter alone;
  alone->SetInputData(block);
  const vtkIdType nodes = GetNumberOfNodes(UpdateGrid(alone));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakePolyData({}));
  blocks->SetBlock(1, block);
  TestedFilter filter;
  filter->SetInputData(blocks);
  UpdateGrid(filter);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 2U);
  EXPECT_EQ(output->GetBlock(0), nullptr);
  auto* grid = vtkHyperTreeGrid::SafeDownCast(output->GetBlock(1));
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(GetNumberOfNodes(grid), nodes);

  vtkNew<vtkPartitionedDataSetCollection> parts;
  parts->SetPartition(0, 0, block);
  filter->SetInputData(parts);
  UpdateGrid(filter);
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(collection, nullptr);
  grid = vtkHyperTreeGrid::SafeDownCast(collection->GetPartitionAsDataObject(0, 0));
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(GetNumberOfNodes(grid), nodes);
}

TEST(TestHashedOctreeFilterHyperTree, ProgressMovesAndAnAbortLeavesItEmpty)
{
  TestedFilter filter(MakeUniformPoints<3, double>(100000, 5));
  const vtkIdType nodes = GetNumberOfNodes(UpdateGrid(filter));
  filter.ExpectProgressInSteps(0.2);
  for (const double fraction : { 0.1, 0.65, 0.8, 0.9, 0.95 })
  {
    SCOPED_TRACE(fraction);
    {
      const StopAt stop(filter.GetFilter(), fraction);
      filter->Modified();
      UpdateGrid(filter);
      EXPECT_EQ(GetNumberOfNodes(GetGrid(filter)), 0);
      EXPECT_EQ(GetGrid(filter)->GetCellData()->GetNumberOfArrays(), 0);
      EXPECT_EQ(GetGrid(filter)->GetMask(), nullptr);
      EXPECT_EQ(GetGrid(filter)->GetFieldData()->GetNumberOfArrays(), 0);
    }
    filter->SetAbortExecute(0);
    filter->Modified();
    EXPECT_EQ(GetNumberOfNodes(UpdateGrid(filter)), nodes);
  }
}

TEST(TestHashedOctreeFilterHyperTree, ThereAreAsManyVerticesAs32BitsCanNumber)
{
  const std::size_t most = hashedoctree::MaxNumberOfHyperTreeVertices;
  EXPECT_EQ(most, 4294967295U);
  EXPECT_NO_THROW(hashedoctree::RequireHyperTreeVertices(most));
  EXPECT_THROW(hashedoctree::RequireHyperTreeVertices(most + 1), std::length_error);
}
