// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include <algorithm>

namespace hashedoctree
{
namespace
{
constexpr std::size_t Grain = 2048; // Blocks that a thread does at a time.

/** Cells of MaxDepth between two corners, both of them included. */
template <int Dim>
struct CellBox
{
  Cell<Dim> Lower;
  Cell<Dim> Upper;
};

/** The cells of MaxDepth that the points of a leaf lie in. It must not be empty. */
template <int Dim, typename Real>
CellBox<Dim> MeasureLeaf(
  const PointTree<Dim, Real>& tree, std::uint32_t firstPoint, std::uint32_t lastPoint)
{
  const Grid<Dim>& grid = tree.GetOctree().GetGrid();
  const std::size_t count = lastPoint - firstPoint;
  CellBox<Dim> box;
  for (int axis = 0; axis < Dim; ++axis)
  {
    const Real* x = tree.GetLeafCoordinates(firstPoint) + static_cast<std::size_t>(axis) * count;
    const auto [lower, upper] = std::minmax_element(x, x + count);
    box.Lower[axis] = grid.GetCellCoordinate(static_cast<double>(*lower), axis);
    box.Upper[axis] = grid.GetCellCoordinate(static_cast<double>(*upper), axis);
  }
  return box;
}

/** Steps of a block at `depth` up to a cell of MaxDepth in it. */
template <int Dim>
std::uint8_t GetStep(std::uint32_t cell, int depth)
{
  const int shift = MortonKey<Dim>::MaxDepth - depth;
  const std::uint64_t within = cell & ((std::uint64_t(1) << shift) - 1);
  return static_cast<std::uint8_t>(within * ChildBoxes<Dim>::Steps >> shift);
}

/** The last step that a cell of MaxDepth touches: where a step is smaller than a cell, not the
 * first one. */
template <int Dim>
std::uint8_t GetLastStep(std::uint32_t cell, int depth)
{
  const int shift = MortonKey<Dim>::MaxDepth - depth;
  const std::uint64_t within = (cell & ((std::uint64_t(1) << shift) - 1)) + 1;
  return static_cast<std::uint8_t>((within * ChildBoxes<Dim>::Steps - 1) >> shift);
}
}

template <int Dim, typename Real>
PointTree<Dim, Real>::PointTree(PointSpan<Dim, Real> points, const PointSelection<Dim>& selection,
  const Options& options, const Execution& execution)
  : Tree(points, selection, options, execution.Part(0.0, 0.6))
{
  this->CopyCoordinates(points, execution.Part(0.6, 0.8));
  this->MeasureBoxes(execution.Part(0.8, 1.0));
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::CopyCoordinates(PointSpan<Dim, Real> points, const Execution& execution)
{
  this->Coordinates = Buffer<Real>(Dim * this->GetNumberOfPoints());
  if (!this->Tree.IsRootInternal())
  {
    this->CopyLeaf(points, 0, static_cast<std::uint32_t>(this->GetNumberOfPoints()));
    return;
  }
  execution.For(this->Tree.GetNumberOfInternalNodes(), Grain,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t block = first; block < last; ++block)
      {
        const auto& children = this->Tree.GetBlock(block);
        for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
        {
          if ((children.Internal >> octant & 1U) == 0)
          {
            this->CopyLeaf(points, children.FirstPoint[octant], children.FirstPoint[octant + 1]);
          }
        }
      }
    });
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::CopyLeaf(
  PointSpan<Dim, Real> points, std::uint32_t firstPoint, std::uint32_t lastPoint)
{
  const std::size_t count = lastPoint - firstPoint;
  Real* leaf = this->Coordinates.GetData() + Dim * static_cast<std::size_t>(firstPoint);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Real* x = points[this->GetIds()[firstPoint + i]];
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      leaf[axis * count + i] = x[axis];
    }
  }
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::MeasureBoxes(const Execution& execution)
{
  const std::size_t numberOfBlocks = this->Tree.GetNumberOfInternalNodes();
  this->Boxes = Buffer<ChildBoxes<Dim>>(numberOfBlocks);
  Buffer<CellBox<Dim>> blockBoxes(numberOfBlocks);
  const auto measure = [&](std::size_t block)
  {
    const auto& children = this->Tree.GetBlock(block);
    const int depth = this->Tree.GetBlockKey(block).GetDepth();
    CellBox<Dim> whole;
    whole.Lower.fill(~std::uint32_t(0));
    whole.Upper.fill(0);
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      if ((children.Occupied >> octant & 1U) == 0)
      {
        continue;
      }
      const CellBox<Dim> box = (children.Internal >> octant & 1U) != 0
        ? blockBoxes[Octree<Dim>::GetChildBlock(children, octant)]
        : MeasureLeaf(*this, children.FirstPoint[octant], children.FirstPoint[octant + 1]);
      for (int axis = 0; axis < Dim; ++axis)
      {
        this->Boxes[block].Lower[axis][octant] = GetStep<Dim>(box.Lower[axis], depth);
        this->Boxes[block].Upper[axis][octant] = GetLastStep<Dim>(box.Upper[axis], depth);
        whole.Lower[axis] = std::min(whole.Lower[axis], box.Lower[axis]);
        whole.Upper[axis] = std::max(whole.Upper[axis], box.Upper[axis]);
      }
    }
    blockBoxes[block] = whole;
  };

  // Children before parents: depth by depth from below, each depth being a run of blocks.
  std::size_t last = numberOfBlocks;
  while (last > 0)
  {
    const int depth = this->Tree.GetBlockKey(last - 1).GetDepth();
    const std::size_t first = this->FindFirstBlockAt(depth);
    execution.For(
      last - first, Grain,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t block = first + from; block < first + to; ++block)
        {
          measure(block);
        }
      },
      static_cast<double>(numberOfBlocks - last) / static_cast<double>(numberOfBlocks),
      static_cast<double>(numberOfBlocks - first) / static_cast<double>(numberOfBlocks));
    last = first;
  }
}

template <int Dim, typename Real>
std::size_t PointTree<Dim, Real>::FindFirstBlockAt(int depth) const
{
  // Ordered by depth, then by key, is ordered by the value of the key.
  std::size_t first = 0;
  for (std::size_t count = this->Tree.GetNumberOfInternalNodes(); count > 0;)
  {
    const std::size_t half = count / 2;
    const bool isBefore = this->Tree.GetBlockKey(first + half).GetDepth() < depth;
    first += isBefore ? half + 1 : 0;
    count = isBefore ? count - half - 1 : half;
  }
  return first;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class PointTree<Dim, float>;                                                            \
  template class PointTree<Dim, double>;
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
