// SPDX-License-Identifier: BSD-3-Clause
// The batches of vtkHashedOctreePointLocator: many positions at once, arrays in, arrays out.
#include "vtkHashedOctreePointLocator.h"

#include "AlgorithmExecution.h"
#include "AlgorithmProblems.h"
#include "BatchArrays.h"
#include "PointBatch.h"
#include "PointLocatorIndex.h"
#include "PointsAdaptor.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <exception>

using namespace hashedoctree;

namespace
{
constexpr double PositionsShare = 0.05; // Of the progress, while positions are read.

bool HoldsCoordinates(const vtkDataArray* array, vtkDataSet* dataSet)
{
  if (auto* pointSet = vtkPointSet::SafeDownCast(dataSet))
  {
    return pointSet->GetPoints() != nullptr && array == pointSet->GetPoints()->GetData();
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(dataSet);
  return grid != nullptr &&
    (array == grid->GetXCoordinates() || array == grid->GetYCoordinates() ||
      array == grid->GetZCoordinates());
}
}

bool vtkHashedOctreePointLocator::PrepareBatch(
  vtkDataArray* queries, std::initializer_list<vtkDataArray*> outputs)
{
  for (const auto* output = outputs.begin(); output != outputs.end(); ++output)
  {
    const bool isTaken = *output == queries || HoldsCoordinates(*output, this->DataSet) ||
      std::find(outputs.begin(), output, *output) != output;
    if (*output == nullptr || isTaken)
    {
      vtkErrorMacro("A batch needs an array of its own for each of its outputs.");
      return false;
    }
  }
  Empty(outputs);
  if (queries == nullptr || queries->GetNumberOfComponents() != 3)
  {
    vtkErrorMacro("A batch of queries must be an array of three components, one tuple for each.");
    return false;
  }
  return true;
}

template <typename Function>
bool vtkHashedOctreePointLocator::RunBatch(
  vtkDataArray* queries, std::initializer_list<vtkDataArray*> outputs, const Function& function)
{
  const StopSign stop(this->AbortedBatches);
  if (!this->PrepareBatch(queries, outputs))
  {
    return false;
  }
  const bool wasBuilt = this->IsUpToDate();
  this->GetIndex();
  const std::shared_ptr<const Index> index = this->Built;
  if (!index->Problem.empty())
  {
    if (wasBuilt) // Else the build has just told.
    {
      vtkErrorMacro(<< index->Problem);
    }
    return false;
  }
  try
  {
    const Execution execution = MakeExecution(this, stop);
    const PointsAdaptor positions(queries, execution.Part(0.0, PositionsShare));
    index->Visit(
      [&](const auto& tree)
      {
        const PointBatch batch(tree, execution.Part(PositionsShare, 1.0));
        positions.Visit([&](auto span) { function(batch, span); });
      });
    execution.HeedStop();
    TellOfChange(outputs);
    return true;
  }
  catch (const std::exception&)
  {
    Empty(outputs);
    vtkErrorMacro(
      << DescribeProblem(
           "There is not enough memory for what the batch finds; ask for less at a time."));
    return false;
  }
  catch (const Interrupted&)
  {
    Empty(outputs);
    return false;
  }
  catch (...) // Of an observer.
  {
    Empty(outputs);
    throw;
  }
}

bool vtkHashedOctreePointLocator::FindClosestPoints(
  vtkDataArray* queries, vtkIdTypeArray* ids, vtkDoubleArray* dist2)
{
  return this->FindClosestNPoints(1, queries, ids, dist2);
}

bool vtkHashedOctreePointLocator::FindClosestNPoints(
  int count, vtkDataArray* queries, vtkIdTypeArray* ids, vtkDoubleArray* dist2)
{
  return this->RunBatch(queries, { ids, dist2 },
    [&](const auto& batch, auto positions)
    {
      if (count > 0)
      {
        SetSize(ids, count, positions.Count);
        SetSize(dist2, count, positions.Count);
        batch.FindClosest(
          positions, static_cast<std::size_t>(count), ids->GetPointer(0), dist2->GetPointer(0));
      }
    });
}

bool vtkHashedOctreePointLocator::FindPointsWithinRadius(double radius, vtkDataArray* queries,
  vtkIdTypeArray* offsets, vtkIdTypeArray* ids, vtkDoubleArray* dist2)
{
  return this->RunBatch(queries, { offsets, ids, dist2 },
    [&](const auto& batch, auto positions)
    {
      const auto lists = batch.FindWithin(positions, radius);
      SetSize(offsets, 1, positions.Count + 1);
      SetSize(ids, 1, lists.GetNumberOfPoints());
      SetSize(dist2, 1, lists.GetNumberOfPoints());
      lists.CopyTo(offsets->GetPointer(0), ids->GetPointer(0), dist2->GetPointer(0));
    });
}
