// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeTables.h"

#include "ContinuousCost.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <limits>

namespace hashedoctree
{
namespace
{
/** Adds a column with value(row) in each row. */
template <typename Array, typename Function>
void AddColumn(vtkTable* table, const char* name, std::size_t rows, const Function& value)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfValues(static_cast<vtkIdType>(rows));
  for (std::size_t row = 0; row < rows; ++row)
  {
    column->SetValue(
      static_cast<vtkIdType>(row), static_cast<typename Array::ValueType>(value(row)));
  }
  table->AddColumn(column);
}
}

void FillDepthHistogram(vtkTable* table, const DepthCounts& counts, int dimension)
{
  const std::size_t rows = counts.Leaves.size();
  const DepthHistogram grid = GetDepthHistogram(counts, FrequencyModel::Grid, dimension);
  AddColumn<vtkIntArray>(table, "Depth", rows, [](std::size_t depth) { return depth; });
  AddColumn<vtkIdTypeArray>(
    table, "Leaves", rows, [&](std::size_t depth) { return counts.Leaves[depth]; });
  AddColumn<vtkIdTypeArray>(
    table, "EmptyLeaves", rows, [&](std::size_t depth) { return counts.EmptyLeaves[depth]; });
  AddColumn<vtkIdTypeArray>(
    table, "Points", rows, [&](std::size_t depth) { return counts.Points[depth]; });
  AddColumn<vtkDoubleArray>(
    table, "GridWeight", rows, [&](std::size_t depth) { return grid[depth]; });
}

void FillCostCurves(
  vtkTable* table, const DepthCounts& counts, const MeasuredCost& measured, int dimension)
{
  const std::size_t rows = measured.Leaves.size();
  const auto addModel = [&](const char* name, FrequencyModel model)
  {
    const DepthHistogram histogram = GetDepthHistogram(counts, model, dimension);
    AddColumn<vtkDoubleArray>(table, name, rows,
      [&](std::size_t depth) { return GetMeanCost(histogram, static_cast<int>(depth)); });
  };
  AddColumn<vtkIntArray>(table, "StartDepth", rows, [](std::size_t depth) { return depth; });
  addModel("CostLeaves", FrequencyModel::Leaves);
  addModel("CostPoints", FrequencyModel::Points);
  addModel("CostGrid", FrequencyModel::Grid);
  AddColumn<vtkDoubleArray>(
    table, "MeasuredLeaves", rows, [&](std::size_t depth) { return measured.Leaves[depth]; });
  AddColumn<vtkDoubleArray>(
    table, "MeasuredPoints", rows, [&](std::size_t depth) { return measured.Points[depth]; });
  const ContinuousCost continuous(counts.Leaves);
  AddColumn<vtkDoubleArray>(table, "ContinuousLeaves", rows,
    [&](std::size_t depth) { return continuous.GetCost(static_cast<double>(depth) + 0.5); });
}

void MarkStartDepth(vtkTable* costs, int startDepth, double meanHitCost)
{
  AddColumn<vtkDoubleArray>(costs, "MeanHitCost",
    static_cast<std::size_t>(costs->GetNumberOfRows()),
    [&](std::size_t depth)
    {
      return static_cast<int>(depth) == startDepth ? meanHitCost
                                                   : std::numeric_limits<double>::quiet_NaN();
    });
}

void FillSearchTable(vtkTable* table, const std::vector<SearchRow>& rows)
{
  vtkNew<vtkStringArray> models;
  models->SetName("Model");
  for (const SearchRow& row : rows)
  {
    models->InsertNextValue(row.Model);
  }
  table->AddColumn(models);
  AddColumn<vtkIntArray>(
    table, "StartDepth", rows.size(), [&rows](std::size_t row) { return rows[row].StartDepth; });
  AddColumn<vtkDoubleArray>(table, "PredictedMean", rows.size(),
    [&rows](std::size_t row) { return rows[row].PredictedMean; });
  AddColumn<vtkDoubleArray>(table, "MeasuredMean", rows.size(),
    [&rows](std::size_t row) { return rows[row].MeasuredMean; });
}
}
