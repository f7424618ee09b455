// SPDX-License-Identifier: BSD-3-Clause

// The representation of the tree.
#include "PointSamples.h"
#include "TestedLocator.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSpatialRepresentationFilter.h"
#include "vtkTypeUInt64Array.h"

#include <cmath>

namespace
{
/** The side of the root, and where it begins. */
struct Root
{
  double Lower[3];
  double Side;

  explicit Root(const double* bounds)
    : Lower{ bounds[0], bounds[2], bounds[4] }
    , Side(std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }))
  {
    this->Side = this->Side > 0.0 ? this->Side : 1.0;
  }
};

/** Whether a box holds a point; with room for the rounding of corners. */
bool Holds(const double* box, const double* x, double slack)
{
  bool holds = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    holds = holds && x[axis] >= box[2 * axis] - slack && x[axis] <= box[2 * axis + 1] + slack;
  }
  return holds;
}

/** The cells must be cubes of the grid at their depth, and hold the points that they count. */
void ExpectNodes(vtkPolyData* cells, vtkDataSet* cloud, int level)
{
  vtkDataArray* depths = cells->GetCellData()->GetArray("Depth");
  vtkDataArray* counts = cells->GetCellData()->GetArray("PointCount");
  ASSERT_TRUE(depths && counts);
  EXPECT_EQ(cells->GetCellData()->GetScalars(), depths);
  ASSERT_EQ(depths->GetNumberOfTuples(), cells->GetNumberOfCells());
  for (const char* name : { "HitCost", "RootCost", "MortonKey" })
  {
    EXPECT_NE(cells->GetCellData()->GetArray(name), nullptr) << name;
  }
  const Root root(cloud->GetBounds());
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const int depth = static_cast<int>(depths->GetTuple1(cell));
    ASSERT_TRUE(level < 0 || depth == level);
    const double side = std::ldexp(root.Side, -depth);
    const double slack = 1e-9 * root.Side;
    double box[6];
    cells->GetCellBounds(cell, box);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(box[2 * axis + 1] - box[2 * axis], side, slack);
      const double place = (box[2 * axis] - root.Lower[axis]) / side;
      ASSERT_NEAR(place, std::round(place), 1e-6);
    }
    vtkIdType inside = 0;
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      inside += Holds(box, cloud->GetPoint(i), slack) ? 1 : 0;
    }
    ASSERT_GE(inside, static_cast<vtkIdType>(counts->GetTuple1(cell)));
    ASSERT_GT(counts->GetTuple1(cell), 0.0);
  }
}

/** The points in cells above a depth. */
vtkIdType SumPoints(vtkPolyData* cells, int depth = VTK_INT_MAX)
{
  vtkDataArray* depths = cells->GetCellData()->GetArray("Depth");
  vtkDataArray* counts = cells->GetCellData()->GetArray("PointCount");
  vtkIdType sum = 0;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    sum += depths->GetTuple1(i) < depth ? static_cast<vtkIdType>(counts->GetTuple1(i)) : 0;
  }
  return sum;
}

/** Nodes of one depth stand in the order of their keys, each once. */
void ExpectAscendingKeys(vtkPolyData* cells)
{
  auto* keys = vtkTypeUInt64Array::SafeDownCast(cells->GetCellData()->GetArray("MortonKey"));
  ASSERT_NE(keys, nullptr);
  for (vtkIdType i = 1; i < cells->GetNumberOfCells(); ++i)
  {
    ASSERT_LT(keys->GetValue(i - 1), keys->GetValue(i));
  }
}
}

TEST(TestHashedOctreePointLocatorCells, EveryLevelHasItsNodes)
{
  for (const auto& coordinates :
    { MakeUniformPoints<3, double>(500, 51), MakeClusteredPoints<3, double>(300, 52) })
  {
    const auto cloud = MakePolyData(coordinates);
    TestedLocator locator(cloud);
    locator->SetMaxPointsPerLeaf(2);
    vtkNew<vtkPolyData> leaves;
    locator->GenerateRepresentation(-1, leaves);
    vtkNew<vtkPolyData> cells;
    for (int level = 0; level <= locator->GetLevel(); ++level)
    {
      SCOPED_TRACE(level);
      locator->GenerateRepresentation(level, cells);
      ASSERT_GT(cells->GetNumberOfCells(), 0);
      ExpectNodes(cells, cloud, level);
      ExpectAscendingKeys(cells);
      // What is not in its nodes is in leaves above.
      EXPECT_EQ(SumPoints(cells) + SumPoints(leaves, level), cloud->GetNumberOfPoints());
    }
    locator->GenerateRepresentation(0, cells);
    EXPECT_EQ(cells->GetNumberOfCells(), 1);
    locator->GenerateRepresentation(locator->GetLevel() + 1, cells);
    EXPECT_EQ(cells->GetNumberOfCells(), 0);
    locator->GenerateRepresentation(1000, cells);
    EXPECT_EQ(cells->GetNumberOfCells(), 0);
  }
}

TEST(TestHashedOctreePointLocatorCells, LeavesHoldAllPointsOnce)
{
  for (const auto& coordinates :
    { MakeUniformPoints<3, double>(500, 53), MakeClusteredPoints<3, double>(300, 54) })
  {
    const auto cloud = MakePolyData(coordinates);
    TestedLocator locator(cloud);
    vtkNew<vtkPolyData> cells;
    locator->GenerateRepresentation(-1, cells);
    ExpectNodes(cells, cloud, -1);
    EXPECT_EQ(SumPoints(cells), cloud->GetNumberOfPoints());
    EXPECT_LE(cells->GetNumberOfCells(), locator->GetNumberOfBuckets());
  }
}

TEST(TestHashedOctreePointLocatorCells, TheDataSetItselfMayTakeThem)
{
  for (const bool isItsLocator : { false, true })
  {
    const auto cloud = MakeUniform(500, 56);
    TestedLocator locator(cloud);
    vtkNew<vtkPolyData> expected;
    locator->GenerateRepresentation(-1, expected);
    ASSERT_GT(expected->GetNumberOfCells(), 1);
    cloud->SetPointLocator(isItsLocator ? locator.Get() : nullptr);
    locator->GenerateRepresentation(-1, cloud);
    EXPECT_EQ(cloud->GetNumberOfCells(), expected->GetNumberOfCells());
    EXPECT_EQ(cloud->GetNumberOfPoints(), expected->GetNumberOfPoints());
    double corner[3];
    cloud->GetPoint(7, corner);
    double found[3];
    cloud->GetPoint(locator->FindClosestPoint(corner), found);
    EXPECT_TRUE(std::equal(corner, corner + 3, found));
    cloud->SetPointLocator(nullptr); // Or they would hold each other.
  }
}

TEST(TestHashedOctreePointLocatorCells, WithoutPointsThereIsNothing)
{
  TestedLocator locator(MakePolyData<float>({}));
  const auto cells = MakePolyData<float>({ 1, 2, 3 }); // To be replaced, with its vertex.
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  cells->SetVerts(vertices);
  for (const int level : { -1, 0, 1 })
  {
    locator->GenerateRepresentation(level, cells);
    EXPECT_EQ(cells->GetNumberOfCells(), 0);
    EXPECT_EQ(cells->GetNumberOfPoints(), 0);
  }
}

TEST(TestHashedOctreePointLocatorCells, OnePointHasARoot)
{
  const auto cloud = MakePolyData<float>({ 1, 2, 3 });
  TestedLocator locator(cloud);
  vtkNew<vtkPolyData> cells;
  for (const int level : { -1, 0 })
  {
    locator->GenerateRepresentation(level, cells);
    EXPECT_EQ(cells->GetNumberOfCells(), 1);
    ExpectNodes(cells, cloud, level);
  }
}

TEST(TestHashedOctreePointLocatorCells, ShownBySpatialRepresentationFilter)
{
  const auto cloud = MakeUniform(500, 55);
  vtkNew<vtkHashedOctreePointLocator> locator;
  vtkNew<vtkSpatialRepresentationFilter> filter;
  filter->SetInputData(cloud);
  filter->SetSpatialRepresentation(locator);
  filter->GenerateLeavesOn();
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  const int deepest = locator->GetLevel();
  for (int level = 0; level <= deepest; ++level)
  {
    filter->AddLevel(level);
  }
  filter->Update();
  EXPECT_EQ(filter->GetMaximumLevel(), deepest);
  // A block for each level, and one for the leaves.
  vtkMultiBlockDataSet* output = filter->GetOutput();
  ASSERT_EQ(static_cast<int>(output->GetNumberOfBlocks()), deepest + 2);
  vtkNew<vtkPolyData> expected;
  for (int level = 0; level <= deepest + 1; ++level)
  {
    locator->GenerateRepresentation(level <= deepest ? level : -1, expected);
    auto* cells = vtkPolyData::SafeDownCast(output->GetBlock(static_cast<unsigned>(level)));
    ASSERT_NE(cells, nullptr) << level;
    EXPECT_GT(cells->GetNumberOfCells(), 0) << level;
    EXPECT_EQ(cells->GetNumberOfCells(), expected->GetNumberOfCells()) << level;
  }
}
