// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "SameOutputs.h"
#include "TestedNeighborsFilter.h"

#include "vtkDummyController.h"

#include <cmath>
#include <limits>

namespace
{
using Filter = vtkHashedOctreeNeighborsFilter;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::vector<double> MakeCoordinates(unsigned seed)
{
  return MakeUniformPoints<3, double>(60, seed);
}

/** After an error the same filter must do its work as if nothing had happened. */
void ExpectToWorkAgain(TestedNeighborsFilter& filter)
{
  const std::vector<double> coordinates = MakeCoordinates(90);
  filter->SetInputData(MakePolyData(coordinates));
  filter->SetSearchMode(Filter::Adjacent);
  filter->UseLeafKeyOff();
  filter->SetCenter(coordinates.data());
  filter.Update();
  EXPECT_GT(filter.GetCells()->GetNumberOfCells(), 1);
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}
}

TEST(TestHashedOctreeNeighborsFilterBadInput, NoPointsHaveNoNeighbors)
{
  TestedNeighborsFilter filter(std::vector<double>{});
  filter.UpdateToNothing();
  ExpectToWorkAgain(filter);
  filter->SetInputData(MakePolyData({}));
  filter.UpdateToNothing();
  filter->UseLeafKeyOn(); // Of whatever leaf.
  filter.UpdateToNothing();
  filter->UseLeafKeyOff();
  filter->SetInputData(MakePolyData({ NotANumber, 0, 0 }));
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("1 of 1 points");
  filter.ExpectEmptyOutputs();
}

TEST(TestHashedOctreeNeighborsFilterBadInput, OtherPiecesMayHaveTheLeafWhateverTheController)
{
  vtkNew<vtkDummyController> controller;
  for (vtkMultiProcessController* one : { static_cast<vtkMultiProcessController*>(nullptr),
         static_cast<vtkMultiProcessController*>(controller) })
  {
    TestedNeighborsFilter filter({ 0, 0, 0, 1, 1, 1 });
    filter->SetController(one);
    filter->UseLeafKeyOn();
    filter->SetLeafKey(64);
    filter->UpdatePiece(0, 2, 0);
    EXPECT_EQ(filter.Errors, std::vector<std::string>());
    filter.ExpectEmptyOutputs();
  }
}

TEST(TestHashedOctreeNeighborsFilterBadInput, AnEmptyPieceIsNoError)
{
  TestedNeighborsFilter filter(std::vector<double>{});
  filter->UseLeafKeyOn();
  filter->SetLeafKey(8);
  filter->UpdatePiece(1, 4, 0);
  EXPECT_EQ(filter.Errors, std::vector<std::string>());
  filter.ExpectEmptyOutputs();
  filter->SetInputData(MakePolyData({ 1, 2, 3 }));
  filter->UpdatePiece(1, 4, 0);
  EXPECT_EQ(filter.Errors, std::vector<std::string>()) << "another piece may have the leaf";
  filter.ExpectEmptyOutputs();
}

TEST(TestHashedOctreeNeighborsFilterBadInput, PointsThatAreNotFiniteAreSkippedWithOneWarning)
{
  std::vector<double> coordinates = MakeCoordinates(93);
  TestedNeighborsFilter good(coordinates);
  good->SetCenter(coordinates.data());
  good.Update();
  coordinates.insert(coordinates.end(), { 0, NotANumber, 0, Infinity, 0, 0 });
  TestedNeighborsFilter filter(coordinates);
  filter->SetCenter(coordinates.data());
  filter.Update();
  filter.ExpectWarning("2 of 62 points");
  EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 2);
  ExpectSameArrays(filter.GetCells()->GetCellData(), good.GetCells()->GetCellData());
}

TEST(TestHashedOctreeNeighborsFilterBadInput, CentersThatAreNotFiniteAreAnError)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double bad : { NotANumber, Infinity, -Infinity })
    {
      TestedNeighborsFilter filter(MakeCoordinates(94));
      double center[3] = { 0.5, 0.5, 0.5 };
      center[axis] = bad;
      filter->SetCenter(center);
      filter.UpdateInError("Center");
      ExpectToWorkAgain(filter);
    }
  }
}

TEST(TestHashedOctreeNeighborsFilterBadInput, BadRadiiAreAnErrorWhereTheyAreUsed)
{
  for (const double radius : { -0.2, -Infinity, NotANumber })
  {
    TestedNeighborsFilter filter;
    filter->SetRadius(radius);
    ExpectToWorkAgain(filter);
    filter->SetSearchMode(Filter::InRadius);
    filter.UpdateInError("Radius is " + std::string(std::isnan(radius) ? "nan" : "-"));
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeNeighborsFilterBadInput, KeysOfNoLeafAreAnError)
{
  // Leaves 8 and 15 hold the points, 9 to 14 are empty; the root is internal.
  const std::vector<double> coordinates{ 0, 0, 0, 1, 1, 1 };
  TestedNeighborsFilter filter(coordinates);
  filter->IncludeEmptyLeavesOff();
  for (const vtkTypeInt64 key : { 1, 0, 2, 7, 9, 14, 16, 64, 120, -1 })
  {
    filter->UseLeafKeyOn();
    filter->SetLeafKey(key);
    filter.UpdateInError("LeafKey " + std::to_string(key) + " names no leaf");
  }
  for (const vtkTypeInt64 key : { 8, 15 })
  {
    filter->SetLeafKey(key);
    filter.Update();
    EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 2);
  }
  filter->IncludeEmptyLeavesOn();
  filter->SetLeafKey(9);
  filter.Update();
  EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 8);
  ExpectToWorkAgain(filter);
}

TEST(TestHashedOctreeNeighborsFilterBadInput, AnEmptyCellIsNoLeafOfASparseTree)
{
  TestedNeighborsFilter filter({ 0, 0, 0, 1, 1, 1 });
  filter->IncludeEmptyLeavesOff();
  filter->SetCenter(0.1, 0.1, 0.9);
  filter.Update();
  filter.ExpectWarning("empty cell, where");
  filter.ExpectEmptyOutputs();
  filter->IncludeEmptyLeavesOn();
  filter.Update();
  EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 8);
  EXPECT_EQ(filter.Get("PointCount", 0), 0);
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}

TEST(TestHashedOctreeNeighborsFilterBadInput, ValuesOutOfRangeAreClamped)
{
  vtkNew<Filter> filter;
  filter->SetMaxPointsPerLeaf(0);
  EXPECT_EQ(filter->GetMaxPointsPerLeaf(), 1);
  filter->SetMaxDepth(32);
  EXPECT_EQ(filter->GetMaxDepth(), 31);
  filter->SetFixedStartDepth(-1);
  EXPECT_EQ(filter->GetFixedStartDepth(), 0);
  filter->SetSearchMode(7);
  EXPECT_EQ(filter->GetSearchMode(), Filter::InRadius);
  filter->SetSearchMode(-1);
  EXPECT_EQ(filter->GetSearchMode(), Filter::Adjacent);
}
