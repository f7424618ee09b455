// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeCells.h"

#include "DirectSearch.h"
#include "NodeCorners.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnstructuredGrid.h"

namespace hashedoctree
{
namespace
{
constexpr std::size_t Grain = 8192; // Nodes or corners that a thread does at a time.

template <typename Array>
vtkNew<Array> MakeArray(const char* name, std::size_t size)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(size));
  return array;
}

/** Calls function(i) for each i below count, on all threads. */
template <typename Function>
void ForEach(std::size_t count, const Execution& execution, const Function& function)
{
  execution.For(count, Grain,
    [&function](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        function(i);
      }
    });
}

vtkNew<vtkPoints> MakePoints(
  const Grid<3>& grid, const NodeCorners<3>& corners, const Execution& execution)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(corners.GetNumberOfCorners()));
  double* x = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
  ForEach(corners.GetNumberOfCorners(), execution,
    [&grid, &corners, x](std::size_t i)
    {
      const Cell<3> corner = corners.GetCorner(i);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        x[3 * i + axis] = grid.GetCorner(corner[axis], static_cast<int>(axis));
      }
    });
  return points;
}

/** Cells of `size` points each, in one array. */
void SetCells(vtkCellArray* cells, std::size_t numberOfCells, std::size_t size,
  vtkTypeInt64Array* connectivity, const Execution& execution)
{
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(numberOfCells + 1));
  ForEach(numberOfCells + 1, execution,
    [&offsets, size](std::size_t i)
    { offsets->SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt64>(i * size)); });
  cells->SetData(offsets, connectivity);
}

/** A walk along the twelve edges of a voxel; three of them are walked twice, since a box cannot be
 * drawn in one stroke. */
constexpr std::array<unsigned, 16> OutlinePath{ 0, 1, 3, 2, 0, 4, 5, 1, 5, 7, 3, 7, 6, 2, 6, 4 };
}

void OctreeCells::MakeVoxels(vtkUnstructuredGrid* output, const Execution& execution) const
{
  const Nodes nodes = ListNodes(this->Tree, this->Options, execution.Part(0.0, 0.1));
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(
    static_cast<vtkIdType>(nodes.GetSize() * NodeCorners<3>::CornersOfNode));
  const NodeCorners<3> corners(nodes, connectivity->GetPointer(0), execution.Part(0.1, 0.6));
  output->SetPoints(MakePoints(this->Tree.GetGrid(), corners, execution.Part(0.6, 0.7)));
  vtkNew<vtkCellArray> cells;
  SetCells(
    cells, nodes.GetSize(), NodeCorners<3>::CornersOfNode, connectivity, execution.Part(0.7, 0.75));
  output->SetCells(VTK_VOXEL, cells);
  this->AddArrays(nodes, output, execution.Part(0.75, 1.0));
}

void OctreeCells::MakeOutlines(vtkPolyData* output, const Execution& execution) const
{
  const Nodes nodes = ListNodes(this->Tree, this->Options, execution.Part(0.0, 0.1));
  Buffer<vtkTypeInt64> voxels(nodes.GetSize() * NodeCorners<3>::CornersOfNode);
  const NodeCorners<3> corners(nodes, voxels.GetData(), execution.Part(0.1, 0.5));
  output->SetPoints(MakePoints(this->Tree.GetGrid(), corners, execution.Part(0.5, 0.6)));
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(nodes.GetSize() * OutlinePath.size()));
  ForEach(nodes.GetSize(), execution.Part(0.6, 0.7),
    [&voxels, path = connectivity->GetPointer(0)](std::size_t node)
    {
      for (std::size_t i = 0; i < OutlinePath.size(); ++i)
      {
        path[node * OutlinePath.size() + i] =
          voxels[node * NodeCorners<3>::CornersOfNode + OutlinePath[i]];
      }
    });
  vtkNew<vtkCellArray> lines;
  SetCells(lines, nodes.GetSize(), OutlinePath.size(), connectivity, execution.Part(0.7, 0.75));
  output->SetLines(lines);
  this->AddArrays(nodes, output, execution.Part(0.75, 1.0));
}

template <typename DataSet>
void OctreeCells::AddArrays(const Nodes& nodes, DataSet* output, const Execution& execution) const
{
  const std::size_t size = nodes.GetSize();
  const auto depths = MakeArray<vtkIntArray>("Depth", size);
  const auto hitCosts = MakeArray<vtkIntArray>("HitCost", size);
  const auto rootCosts = MakeArray<vtkIntArray>("RootCost", size);
  const auto pointCounts = MakeArray<vtkIdTypeArray>("PointCount", size);
  const auto keys = MakeArray<vtkTypeUInt64Array>("MortonKey", size);
  ForEach(size, execution,
    [&](std::size_t i)
    {
      const Octree<3>::Node& node = nodes[i];
      const MortonKey<3> key = node.NodeKey.GetFirstAtMaxDepth();
      const auto cost = [&](int startDepth) {
        return node.Internal ? 0
                             : static_cast<int>(CountExaminedNodes(this->Tree, key, startDepth));
      };
      const auto id = static_cast<vtkIdType>(i);
      depths->SetValue(id, node.NodeKey.GetDepth());
      hitCosts->SetValue(id, cost(this->StartDepth));
      rootCosts->SetValue(id, cost(0));
      pointCounts->SetValue(id, node.GetNumberOfPoints());
      keys->SetValue(id, node.NodeKey.GetValue());
    });
  vtkCellData* cellData = output->GetCellData();
  cellData->AddArray(depths);
  cellData->AddArray(hitCosts);
  cellData->AddArray(rootCosts);
  cellData->AddArray(pointCounts);
  cellData->AddArray(keys);
  cellData->SetActiveScalars("Depth");
}
}
