// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_ExpectTables_h
#define Testing_Cxx_ExpectTables_h

#include "OracleOctree.h"

#include "vtkDataArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

/** The column of a table; fails where it has another place, name or type. */
inline vtkDataArray* GetColumn(vtkTable* table, int column, const std::string& name, int type)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumn(column));
  EXPECT_NE(array, nullptr) << name;
  if (array != nullptr)
  {
    EXPECT_EQ(array->GetName(), name);
    EXPECT_EQ(array->GetDataType(), type) << name;
  }
  return array;
}

inline void ExpectHistogram(vtkTable* table, const OracleOctree& expected)
{
  ASSERT_EQ(table->GetNumberOfColumns(), 5);
  ASSERT_EQ(table->GetNumberOfRows(), expected.GetDeepestDepth() + 1);
  vtkDataArray* depth = GetColumn(table, 0, "Depth", VTK_INT);
  vtkDataArray* leaves = GetColumn(table, 1, "Leaves", VTK_ID_TYPE);
  vtkDataArray* emptyLeaves = GetColumn(table, 2, "EmptyLeaves", VTK_ID_TYPE);
  vtkDataArray* points = GetColumn(table, 3, "Points", VTK_ID_TYPE);
  vtkDataArray* grid = GetColumn(table, 4, "GridWeight", VTK_DOUBLE);
  ASSERT_TRUE(depth && leaves && emptyLeaves && points && grid);
  double totalGrid = 0.0;
  for (int row = 0; row <= expected.GetDeepestDepth(); ++row)
  {
    const auto sum = [&expected, row](auto value)
    {
      return static_cast<double>(expected.Sum([&value, row](const OracleOctree::Node& leaf)
        { return leaf.Depth == row ? value(leaf) : 0; }));
    };
    EXPECT_EQ(depth->GetTuple1(row), row);
    EXPECT_EQ(leaves->GetTuple1(row), sum([](const auto&) { return 1; })) << row;
    EXPECT_EQ(
      emptyLeaves->GetTuple1(row), sum([](const auto& leaf) { return leaf.Points.empty(); }))
      << row;
    EXPECT_EQ(points->GetTuple1(row),
      sum([](const auto& leaf) { return static_cast<std::int64_t>(leaf.Points.size()); }))
      << row;
    EXPECT_EQ(grid->GetTuple1(row),
      sum([&expected](const auto& leaf) { return OracleOctree::Grid(expected, leaf); }))
      << row;
    totalGrid += grid->GetTuple1(row);
  }
  EXPECT_DOUBLE_EQ(totalGrid, std::pow(8.0, expected.GetDeepestDepth())) << "tiling of the root";
}

inline void ExpectCosts(vtkTable* table, const OracleOctree& expected)
{
  ASSERT_EQ(table->GetNumberOfColumns(), 8);
  const int lastStartDepth = std::max(expected.GetDeepestDepth(), 1);
  ASSERT_EQ(table->GetNumberOfRows(), lastStartDepth + 1);
  vtkDataArray* startDepth = GetColumn(table, 0, "StartDepth", VTK_INT);
  vtkDataArray* costLeaves = GetColumn(table, 1, "CostLeaves", VTK_DOUBLE);
  vtkDataArray* costPoints = GetColumn(table, 2, "CostPoints", VTK_DOUBLE);
  vtkDataArray* costGrid = GetColumn(table, 3, "CostGrid", VTK_DOUBLE);
  vtkDataArray* measuredLeaves = GetColumn(table, 4, "MeasuredLeaves", VTK_DOUBLE);
  vtkDataArray* measuredPoints = GetColumn(table, 5, "MeasuredPoints", VTK_DOUBLE);
  vtkDataArray* continuousLeaves = GetColumn(table, 6, "ContinuousLeaves", VTK_DOUBLE);
  ASSERT_TRUE(startDepth && costLeaves && costPoints && costGrid && measuredLeaves &&
    measuredPoints && continuousLeaves);
  for (int row = 0; row <= lastStartDepth; ++row)
  {
    const auto mean = [&expected, row](OracleOctree::Weight weight)
    { return static_cast<double>(expected.GetMeanCost(weight, row)); };
    EXPECT_EQ(startDepth->GetTuple1(row), row);
    EXPECT_DOUBLE_EQ(costLeaves->GetTuple1(row), mean(OracleOctree::Leaves)) << row;
    EXPECT_DOUBLE_EQ(costPoints->GetTuple1(row), mean(OracleOctree::Points)) << row;
    EXPECT_NEAR(costGrid->GetTuple1(row) / mean(OracleOctree::Grid), 1.0, 1e-12) << row;
    // Model and measurement agree to the last digit.
    EXPECT_EQ(measuredLeaves->GetTuple1(row), costLeaves->GetTuple1(row)) << row;
    EXPECT_EQ(measuredPoints->GetTuple1(row), costPoints->GetTuple1(row)) << row;
    const double share = static_cast<double>(expected.Sum(
                           [row](const auto& leaf) { return leaf.Depth == row ? 1 : 0; })) /
      static_cast<double>(expected.Sum([](const auto&) { return 1; }));
    EXPECT_NEAR(
      continuousLeaves->GetTuple1(row), costLeaves->GetTuple1(row) + 3.0 / 16.0 * share, 1e-12)
      << row;
  }
}

/** The mark of the start depth in the cost curves: its mean cost, and nothing in the other rows. */
inline void ExpectMark(vtkTable* costs, double startDepth, double meanHitCost)
{
  vtkDataArray* mark = GetColumn(costs, 7, "MeanHitCost", VTK_DOUBLE);
  ASSERT_NE(mark, nullptr);
  for (vtkIdType row = 0; row < costs->GetNumberOfRows(); ++row)
  {
    const double value = mark->GetTuple1(row);
    EXPECT_TRUE(static_cast<double>(row) == startDepth ? value == meanHitCost : std::isnan(value))
      << row << ": " << value;
  }
}

#endif
