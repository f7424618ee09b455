// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeCells.h"

#include "NodeArrays.h"
#include "NodeCorners.h"
#include "ResizeArray.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace hashedoctree
{
namespace
{
constexpr std::size_t Grain = 512; // Nodes or corners that a thread does at a time.

/** Below so many nodes, all ids of their cells fit into 32 bits and take half the memory. */
constexpr std::size_t NodesWithLongIds = std::size_t(1) << 27;

template <int Dim>
vtkNew<vtkPoints> MakePoints(const Grid<Dim>& grid, const TreeFrame<Dim>& frame,
  const NodeCorners<Dim>& corners, const Execution& execution)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  ResizeArray(coordinates.Get(), 3 * corners.GetNumberOfCorners());
  double* x = coordinates->GetPointer(0);
  execution.ForEach(corners.GetNumberOfCorners(), Grain,
    [&grid, &frame, &corners, x](std::size_t i)
    { frame.GetCorner(grid, corners.GetCorner(i), x + 3 * i); });
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  return points;
}

/** Cells of `size` points each, in one array. */
template <typename IdArray>
void SetCells(vtkCellArray* cells, std::size_t numberOfCells, std::size_t size,
  IdArray* connectivity, const Execution& execution)
{
  vtkNew<IdArray> offsets;
  ResizeArray(offsets.Get(), numberOfCells + 1);
  execution.ForEach(numberOfCells + 1, Grain,
    [&offsets, size](std::size_t i)
    {
      offsets->SetValue(
        static_cast<vtkIdType>(i), static_cast<typename IdArray::ValueType>(i * size));
    });
  cells->SetData(offsets, connectivity);
}

/** What VTK calls a node, and a walk along all its edges. */
template <int Dim>
struct CellShape;
template <>
struct CellShape<2>
{
  static constexpr unsigned char Type = VTK_PIXEL;
  static constexpr std::array<unsigned, 5> Outline{ 0, 1, 3, 2, 0 };
};
template <>
struct CellShape<3>
{
  static constexpr unsigned char Type = VTK_VOXEL;
  /** Three of the twelve edges twice, since a box cannot be drawn in one stroke. */
  static constexpr std::array<unsigned, 16> Outline{ 0, 1, 3, 2, 0, 4, 5, 1, 5, 7, 3, 7, 6, 2, 6,
    4 };
};
}

template <int Dim>
void OctreeCells<Dim>::MakeVoxels(vtkUnstructuredGrid* output, const Execution& execution) const
{
  this->Listed.GetSize() < NodesWithLongIds
    ? this->template FillVoxels<vtkTypeInt32Array>(output, execution)
    : this->template FillVoxels<vtkTypeInt64Array>(output, execution);
}

template <int Dim>
void OctreeCells<Dim>::MakeOutlines(vtkPolyData* output, const Execution& execution) const
{
  this->Listed.GetSize() < NodesWithLongIds
    ? this->template FillOutlines<vtkTypeInt32Array>(output, execution)
    : this->template FillOutlines<vtkTypeInt64Array>(output, execution);
}

template <int Dim>
template <typename IdArray>
void OctreeCells<Dim>::FillVoxels(vtkUnstructuredGrid* output, const Execution& execution) const
{
  const Nodes& nodes = this->Listed;
  constexpr std::size_t size = NodeCorners<Dim>::CornersOfNode;
  AddNodeArrays(
    this->Tree, this->StartDepth, nodes, output->GetCellData(), execution.Part(0.0, 0.2));
  vtkNew<IdArray> connectivity;
  ResizeArray(connectivity.Get(), nodes.GetSize() * size);
  const NodeCorners<Dim> corners(
    nodes, this->Apart, connectivity->GetPointer(0), execution.Part(0.2, 0.8));
  output->SetPoints(
    MakePoints(this->Tree.GetGrid(), this->Frame, corners, execution.Part(0.8, 0.9)));
  vtkNew<vtkCellArray> cells;
  SetCells(cells.Get(), nodes.GetSize(), size, connectivity.Get(), execution.Part(0.9, 0.95));
  // Not SetCells(type, cells), which fills the types without heeding an abort.
  vtkNew<vtkUnsignedCharArray> types;
  ResizeArray(types.Get(), nodes.GetSize());
  execution.Part(0.95, 1.0).ForEach(nodes.GetSize(), Grain,
    [&types](std::size_t i) { types->SetValue(static_cast<vtkIdType>(i), CellShape<Dim>::Type); });
  output->SetCells(types, cells);
}

template <int Dim>
template <typename IdArray>
void OctreeCells<Dim>::FillOutlines(vtkPolyData* output, const Execution& execution) const
{
  const Nodes& nodes = this->Listed;
  using Id = typename IdArray::ValueType;
  constexpr auto outline = CellShape<Dim>::Outline;
  constexpr std::size_t size = outline.size();
  AddNodeArrays(
    this->Tree, this->StartDepth, nodes, output->GetCellData(), execution.Part(0.0, 0.2));
  Buffer<Id> voxels(nodes.GetSize() * NodeCorners<Dim>::CornersOfNode);
  const NodeCorners<Dim> corners(nodes, this->Apart, voxels.GetData(), execution.Part(0.2, 0.7));
  output->SetPoints(
    MakePoints(this->Tree.GetGrid(), this->Frame, corners, execution.Part(0.7, 0.8)));
  vtkNew<IdArray> connectivity;
  ResizeArray(connectivity.Get(), nodes.GetSize() * size);
  Id* path = connectivity->GetPointer(0);
  execution.Part(0.8, 0.9).ForEach(nodes.GetSize(), Grain,
    [&voxels, outline, path](std::size_t node)
    {
      for (std::size_t i = 0; i < size; ++i)
      {
        path[node * size + i] = voxels[node * NodeCorners<Dim>::CornersOfNode + outline[i]];
      }
    });
  vtkNew<vtkCellArray> lines;
  SetCells(lines.Get(), nodes.GetSize(), size, connectivity.Get(), execution.Part(0.9, 1.0));
  output->SetLines(lines);
}

template class OctreeCells<2>;
template class OctreeCells<3>;
}
