// SPDX-License-Identifier: BSD-3-Clause
#include "LeafNumbers.h"
#include "MakePointTree.h"
#include "PointSamples.h"
#include "TestedLocator.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"

TEST(TestHashedOctreePointLocatorLeaves, AreThoseOfTheRepresentation)
{
  const auto coordinates = MakeClusteredPoints<3, double>(3000, 191);
  TestedLocator locator(MakePolyData(coordinates));
  locator->SetMaxPointsPerLeaf(4);
  vtkNew<vtkPolyData> leaves;
  locator->GenerateRepresentation(-1, leaves);
  vtkDataArray* depths = leaves->GetCellData()->GetArray("Depth");
  vtkDataArray* costs = leaves->GetCellData()->GetArray("HitCost");
  std::vector<bool> isSeen(static_cast<std::size_t>(leaves->GetNumberOfCells()), false);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    const vtkIdType leaf = locator->GetLeafId(&coordinates[i]);
    ASSERT_GE(leaf, 0);
    ASSERT_LT(leaf, leaves->GetNumberOfCells());
    isSeen[static_cast<std::size_t>(leaf)] = true;
    double bounds[6];
    leaves->GetCellBounds(leaf, bounds);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ASSERT_GE(coordinates[i + axis], bounds[2 * axis] - 1e-9);
      ASSERT_LE(coordinates[i + axis], bounds[2 * axis + 1] + 1e-9);
    }
    ASSERT_EQ(locator->GetDepth(&coordinates[i]), depths->GetTuple1(leaf));
    ASSERT_EQ(locator->GetHitCost(&coordinates[i]), costs->GetTuple1(leaf));
  }
  EXPECT_EQ(std::count(isSeen.begin(), isSeen.end(), false), 0);
}

TEST(TestHashedOctreePointLocatorLeaves, WithoutPointsHaveNoNumber)
{
  // All points lie in one half of the root's cells.
  TestedLocator locator(
    MakePolyData(std::vector<double>{ 0, 0, 0, 1, 0, 0, 0.1, 0.1, 0.1, 0.9, 0.1, 0.1 }));
  locator->SetMaxPointsPerLeaf(1);
  const double empty[3] = { 0.6, 0.9, 0.9 };
  EXPECT_EQ(locator->GetLeafId(empty), -1);
  EXPECT_EQ(locator->GetDepth(empty), 1);
  EXPECT_GE(locator->GetHitCost(empty), 1);
  const double outside[3] = { -5.0, -5.0, -5.0 };
  const double corner[3] = { 0.0, 0.0, 0.0 };
  EXPECT_EQ(locator->GetLeafId(outside), locator->GetLeafId(corner)) << "the nearest leaf";
}

TEST(TestHashedOctreePointLocatorLeaves, HaveNumbersWithinTheBytesOfTheIndex)
{
  using namespace hashedoctree;
  const auto coordinates = MakeClusteredPoints<3, double>(3000, 192);
  TestedLocator locator(MakePolyData(coordinates));
  locator->SetMaxPointsPerLeaf(4);
  locator->BuildLocator();
  const auto tree = MakePointTree(PointSpan<3, double>{ coordinates.data(), 3000 }, 4);
  const LeafNumbers<3> numbers(tree.GetOctree(), EmptyOctants::Missing);
  EXPECT_EQ(
    static_cast<std::size_t>(locator->GetIndexBytes()), tree.GetBytes() + numbers.GetBytes());
}

TEST(TestHashedOctreePointLocatorLeaves, OfOnePointAndOfNone)
{
  const double x[3] = { 0.5, 0.5, 0.5 };
  const double notFinite[3] = { 0.5, NAN, 0.5 };
  TestedLocator locator(MakePolyData(std::vector<double>{}));
  for (const double* position : { x, notFinite })
  {
    EXPECT_EQ(locator->GetLeafId(position), -1);
    EXPECT_EQ(locator->GetDepth(position), -1);
    EXPECT_EQ(locator->GetHitCost(position), 0);
    EXPECT_EQ(locator->GetClosestPointCost(position), 0);
    EXPECT_EQ(locator->GetClosestNPointsCost(3, position), 0);
    EXPECT_EQ(locator->GetPointsWithinRadiusCost(1.0, position), 0);
  }
  const double box[6] = { -9, 9, -9, 9, -9, 9 };
  EXPECT_EQ(locator->GetPointsWithinBoxCost(box), 0);
  locator->SetDataSet(MakePolyData(std::vector<double>{ 1, 2, 3 }));
  EXPECT_EQ(locator->GetLeafId(x), 0);
  EXPECT_EQ(locator->GetDepth(x), 0);
  EXPECT_EQ(locator->GetHitCost(x), 1);
  EXPECT_EQ(locator->GetClosestPointCost(x), 1);
  EXPECT_EQ(locator->GetClosestNPointsCost(3, x), 1);
  EXPECT_EQ(locator->GetPointsWithinRadiusCost(1.0, x), 1);
  EXPECT_EQ(locator->GetPointsWithinBoxCost(box), 1);
  EXPECT_EQ(locator->GetLeafId(notFinite), -1);
}

TEST(TestHashedOctreePointLocatorLeaves, LargerSearchesCostMore)
{
  TestedLocator locator(MakeUniform(20000, 193));
  locator->SetMaxPointsPerLeaf(4);
  const double x[3] = { 0.4, 0.6, 0.5 };
  EXPECT_EQ(locator->GetClosestNPointsCost(0, x), 0);
  EXPECT_EQ(locator->GetClosestNPointsCost(-1, x), 0);
  EXPECT_EQ(locator->GetPointsWithinRadiusCost(-1.0, x), 0);
  EXPECT_EQ(locator->GetClosestNPointsCost(1, x), locator->GetClosestPointCost(x));
  vtkIdType last = locator->GetClosestPointCost(x);
  for (const int count : { 100, 1000, 10000 })
  {
    EXPECT_GT(locator->GetClosestNPointsCost(count, x), last) << count << " closest";
    last = locator->GetClosestNPointsCost(count, x);
  }
  vtkIdType lastOfRadius = 0;
  vtkIdType lastOfBox = 0;
  for (const double radius : { 0.05, 0.15, 0.45 })
  {
    EXPECT_GT(locator->GetPointsWithinRadiusCost(radius, x), lastOfRadius) << radius;
    lastOfRadius = locator->GetPointsWithinRadiusCost(radius, x);
    const double box[6] = { x[0] - radius, x[0] + radius, x[1] - radius, x[1] + radius,
      x[2] - radius, x[2] + radius };
    EXPECT_GT(locator->GetPointsWithinBoxCost(box), lastOfBox) << radius;
    lastOfBox = locator->GetPointsWithinBoxCost(box);
  }
  // What lies inside as a whole is not looked into.
  const double everything[6] = { -1, 2, -1, 2, -1, 2 };
  EXPECT_EQ(locator->GetPointsWithinBoxCost(everything), 1);
  EXPECT_LT(locator->GetPointsWithinRadiusCost(1e9, x), 10);
}

TEST(TestHashedOctreePointLocatorLeaves, SearchesCostLessFromTheMedian)
{
  const auto coordinates = MakeUniformPoints<3, double>(20000, 192);
  TestedLocator locator(MakePolyData(coordinates));
  const auto sumUp = [&](int model)
  {
    locator->SetStartDepthModel(model);
    vtkIdType sum = 0;
    for (std::size_t i = 0; i < 3000; i += 3)
    {
      sum += locator->GetClosestPointCost(&coordinates[i]);
    }
    return sum;
  };
  const vtkIdType fromMedian = sumUp(vtkHashedOctreePointLocator::Median);
  EXPECT_GT(fromMedian, 0);
  EXPECT_LT(fromMedian, sumUp(vtkHashedOctreePointLocator::Root));
}

TEST(TestHashedOctreePointLocatorLeaves, CostLessFromLocalStartDepths)
{
  const auto coordinates = MakeClusteredPoints<3, double>(3000, 194);
  TestedLocator locator(MakePolyData(coordinates));
  locator->SetMaxPointsPerLeaf(4);
  locator->SetFrequencyModel(vtkHashedOctreePointLocator::Points);
  const auto sumUp = [&](int model)
  {
    locator->SetStartDepthModel(model);
    vtkIdType sum = 0;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
    {
      sum += locator->GetHitCost(&coordinates[i]);
    }
    return sum;
  };
  EXPECT_LT(sumUp(vtkHashedOctreePointLocator::Local), sumUp(vtkHashedOctreePointLocator::Median));
}
