// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointKeys_h
#define hashedoctree_PointKeys_h

#include "GridCells.h"
#include "PlaneSpan.h"
#include "PointSpan.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace hashedoctree
{
/** A view of the keys at MaxDepth of positions, in place of the positions; 0 where one is not
 * finite (GetQueryKeys()). */
template <int Dim>
struct KeySpan
{
  const MortonKey<Dim>* Keys = nullptr;
  std::size_t Count = 0;
};

/** How many keys are made at a time: their cells stay in the first cache. */
constexpr std::size_t MostKeysAtOnce = 128;

///@{
/** The cells of the points `first` to `first + count - 1` of a span, those of Grid::GetCell(). */
template <int Dim, typename Real>
void GetCells(const Grid<Dim>& grid, PointSpan<Dim, Real> points, std::size_t first,
  std::size_t count, Cell<Dim>* cells)
{
  GetCells<Dim>(grid, points[first], count, cells);
}
template <int Dim, typename Real>
void GetCells(const Grid<Dim>& grid, PlaneSpan<Real> points, std::size_t first, std::size_t count,
  Cell<Dim>* cells)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    cells[i] = grid.GetCell(points[first + i]);
  }
}
///@}

///@{
/** The keys at MaxDepth of these points, those of Grid::GetKey(), several at a time; `count` at
 * most MostKeysAtOnce. Points that are not finite get keys of the root's cells, too. O(count).
 * Thread safe. */
template <int Dim, typename Points>
void GetKeys(const Grid<Dim>& grid, const Points& points, std::size_t first, std::size_t count,
  MortonKey<Dim>* keys)
{
  std::array<Cell<Dim>, MostKeysAtOnce> cells;
  GetCells<Dim>(grid, points, first, count, cells.data());
  InterleaveCells<Dim>(cells.data(), count, keys);
}
template <int Dim>
void GetKeys(const Grid<Dim>&, const KeySpan<Dim>& points, std::size_t first, std::size_t count,
  MortonKey<Dim>* keys)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    keys[i] = std::max(points.Keys[first + i], MortonKey<Dim>::Root().GetFirstAtMaxDepth());
  }
}
///@}
}

#endif
