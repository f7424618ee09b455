// SPDX-License-Identifier: BSD-3-Clause
#include "FreeSpace.h"

#include "ForEachDimension.h"

namespace hashedoctree
{
template <int Dim>
FreeSpace<Dim>::FreeSpace(const Octree<Dim>& tree, const Buffer<ChildBoxes<Dim>>& boxes)
  : Depth(std::min(HighestBit(tree.GetNumberOfPoints()) / Dim, MaxCoarseDepth))
  , CellsToPoints(std::size_t(1) << (Dim * this->Depth), 0)
{
  CellSet reached = this->GetOccupied(tree, boxes);
  for (std::uint8_t steps = 1;; ++steps)
  {
    CellSet grown = reached;
    this->Grow(grown);
    if (grown == reached)
    {
      return;
    }
    for (std::size_t row = 0; row < grown.size(); ++row)
    {
      for (std::uint64_t next = grown[row] & ~reached[row]; next != 0; next &= next - 1)
      {
        const auto place = static_cast<std::size_t>(__builtin_ctzll(next));
        this->CellsToPoints[row << this->Depth | place] = steps;
      }
    }
    reached.swap(grown);
  }
}

/** The cells that the box of some node reaches into: of a node at Depth, or a leaf above. */
template <int Dim>
typename FreeSpace<Dim>::CellSet FreeSpace<Dim>::GetOccupied(
  const Octree<Dim>& tree, const Buffer<ChildBoxes<Dim>>& boxes) const
{
  CellSet cells(std::size_t(1) << ((Dim - 1) * this->Depth), 0);
  for (std::size_t block = 0; block < tree.GetNumberOfInternalNodes(); ++block)
  {
    const Key key = tree.GetBlockKey(block);
    const int depths = this->Depth - key.GetDepth();
    if (depths <= 0)
    {
      break;
    }
    const auto octants = tree.GetOctants(block);
    if (depths == 1)
    {
      this->AddChildren(key.GetCell(), octants.Occupied, cells);
      continue;
    }
    const unsigned leaves = octants.Occupied & ~unsigned(octants.Internal);
    for (unsigned rest = leaves; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      Cell<Dim> lower = key.GetCell();
      Cell<Dim> upper = lower;
      for (int axis = 0; axis < Dim; ++axis)
      {
        constexpr std::uint32_t steps = ChildBoxes<Dim>::Steps;
        const std::uint32_t first = lower[axis] * steps + boxes[block].Lower[axis][octant];
        const std::uint32_t last = upper[axis] * steps + boxes[block].Upper[axis][octant];
        lower[axis] = (first << depths) / steps;
        upper[axis] = (((last + 1) << depths) - 1) / steps;
      }
      this->AddCells(lower, upper, cells);
    }
  }
  return cells;
}

template <int Dim>
std::size_t FreeSpace<Dim>::GetRow(const Cell<Dim>& cell) const
{
  std::size_t row = 0;
  for (int axis = 0; axis < Dim - 1; ++axis)
  {
    row = row << this->Depth | cell[axis];
  }
  return row;
}

/** Adds those children of a node that some bits tell, where they are coarse cells themselves: two
 * at a time, which are side by side in a row. */
template <int Dim>
void FreeSpace<Dim>::AddChildren(const Cell<Dim>& node, unsigned octants, CellSet& cells) const
{
  for (unsigned pair = 0; pair < Octree<Dim>::NumberOfOctants / 2; ++pair)
  {
    Cell<Dim> first;
    for (int axis = 0; axis < Dim; ++axis)
    {
      first[axis] = 2 * node[axis] + (2 * pair >> (Dim - 1 - axis) & 1U);
    }
    cells[this->GetRow(first)] |= std::uint64_t(octants >> 2 * pair & 3U) << first[Dim - 1];
  }
}

/** Adds the cells between two corners, both of them included. */
template <int Dim>
void FreeSpace<Dim>::AddCells(const Cell<Dim>& lower, const Cell<Dim>& upper, CellSet& cells) const
{
  const std::uint64_t places =
    (~std::uint64_t(0) >> (63 - upper[Dim - 1])) & (~std::uint64_t(0) << lower[Dim - 1]);
  Cell<Dim> cell = lower;
  for (;;)
  {
    cells[this->GetRow(cell)] |= places;
    int axis = Dim - 2;
    while (axis >= 0 && cell[axis] == upper[axis])
    {
      cell[axis] = lower[axis];
      --axis;
    }
    if (axis < 0)
    {
      return;
    }
    ++cell[axis];
  }
}

/** Adds all cells around those of a set, those at edges and corners included. */
template <int Dim>
void FreeSpace<Dim>::Grow(CellSet& cells) const
{
  const std::uint64_t row = ~std::uint64_t(0) >> (64 - (std::size_t(1) << this->Depth));
  for (std::uint64_t& places : cells)
  {
    places |= (places << 1 | places >> 1) & row;
  }
  // Axis by axis: what has grown along one grows along the next.
  for (std::size_t stride = 1; stride < cells.size(); stride <<= this->Depth)
  {
    const CellSet before = cells;
    const std::size_t layer = stride << this->Depth;
    for (std::size_t first = 0; first < cells.size(); first += layer)
    {
      for (std::size_t i = first + stride; i < first + layer; ++i)
      {
        cells[i] |= before[i - stride];
        cells[i - stride] |= before[i];
      }
    }
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim) template class FreeSpace<Dim>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
