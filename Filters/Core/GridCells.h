// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_GridCells_h
#define hashedoctree_GridCells_h

#include "Grid.h"

#include <cstddef>

namespace hashedoctree
{
/**
 * The cells of `count` positions, whose coordinates stand one position after the other: those that
 * Grid::GetCell() gives, several at a time: by the same divisions or, with AVX2 and where the
 * processor rounds to nearest, by products that give the same quotients. Which one runs is found at
 * run time. O(count). Thread safe. Instantiated for float and double.
 */
template <int Dim, typename Real>
void GetCells(const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells);

/** The same as it runs on every machine, to compare with. */
template <int Dim, typename Real>
void GetCellsPlainly(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells);
}

#endif
