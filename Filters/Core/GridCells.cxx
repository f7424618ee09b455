// SPDX-License-Identifier: BSD-3-Clause
#include "GridCells.h"

#include "Lanes.h"

#include <cstring>

namespace hashedoctree
{
namespace
{
constexpr std::size_t Width = 4; // Coordinates at a time.
using Doubles = Lanes<double, Width>;

/** Dim vectors hold the coordinates of Width positions as they stand, so that each lane always has
 * the same axis. */
template <int Dim, typename Real>
HASHEDOCTREE_INLINE void ComputeCells(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  constexpr double size = MortonKey<Dim>::CellsPerSide;
  const Doubles zero = {};
  const Doubles last = zero + (size - 1.0);
  const Doubles side = zero + grid.GetSide();
  Doubles lower[Dim];
  for (std::size_t i = 0; i < Dim * Width; ++i)
  {
    lower[i / Width][i % Width] = grid.GetLower()[i % Dim];
  }
  std::size_t done = 0;
  for (; done + Width <= count; done += Width)
  {
    for (std::size_t i = 0; i < Dim; ++i)
    {
      Lanes<Real, Width> x;
      std::memcpy(&x, coordinates + Dim * done + Width * i, sizeof(x));
      Doubles t = (__builtin_convertvector(x, Doubles) - lower[i]) / side * size;
      t = t > zero ? t : zero;
      t = t < last ? t : last;
      const auto cell = __builtin_convertvector(t, Lanes<std::int32_t, Width>); // Never negative.
      std::memcpy(cells[done].data() + Width * i, &cell, sizeof(cell));
    }
  }
  for (; done < count; ++done)
  {
    cells[done] = grid.GetCell(coordinates + Dim * done);
  }
}

template <int Dim, typename Real>
HASHEDOCTREE_WITH_AVX2 void ComputeCellsByAvx2(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  ComputeCells<Dim>(grid, coordinates, count, cells);
}
}

template <int Dim, typename Real>
void GetCells(const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  if (HasAvx2())
  {
    ComputeCellsByAvx2<Dim>(grid, coordinates, count, cells);
  }
  else
  {
    ComputeCells<Dim>(grid, coordinates, count, cells);
  }
}

template <int Dim, typename Real>
void GetCellsPlainly(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  ComputeCells<Dim>(grid, coordinates, count, cells);
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void GetCells<Dim>(const Grid<Dim>&, const float*, std::size_t, Cell<Dim>*);            \
  template void GetCells<Dim>(const Grid<Dim>&, const double*, std::size_t, Cell<Dim>*);           \
  template void GetCellsPlainly<Dim>(const Grid<Dim>&, const float*, std::size_t, Cell<Dim>*);     \
  template void GetCellsPlainly<Dim>(const Grid<Dim>&, const double*, std::size_t, Cell<Dim>*);
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
