// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Interleaving_h
#define hashedoctree_Interleaving_h

#include "MortonKey.h"

#include <cstddef>

namespace hashedoctree
{
/** Whether the machine has the parallel bit deposit instruction of BMI2. */
bool HasPdep();

/** Whether that is the fastest way to interleave: not where it is microcoded and slower than shifts
 * (AMD before Zen 3). Found before main(); false until then. */
extern const bool PdepIsFastest;

/** As InterleaveCell(), by bit deposit; only where HasPdep(). The cell comes by reference, because
 * to pass it in registers it would have to be packed first. Instantiated for 1 to 4 dimensions. */
template <int Dim>
MortonKey<Dim> DepositCell(const Cell<Dim>& cell, int depth);

/** The key of a cell of the grid at `depth`: MortonKey::FromCell() by the machine's fastest way. */
template <int Dim>
MortonKey<Dim> InterleaveCell(const Cell<Dim>& cell, int depth)
{
  return PdepIsFastest ? DepositCell<Dim>(cell, depth) : MortonKey<Dim>::FromCell(cell, depth);
}

/** DepositCell() at MaxDepth for `count` cells, in their order. Instantiated for 1 to 4 dimensions.
 */
template <int Dim>
void DepositCells(const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys);

/** The same by shifts, on every machine. */
template <int Dim>
void DilateCells(const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    keys[i] = MortonKey<Dim>::FromCell(cells[i], MortonKey<Dim>::MaxDepth);
  }
}

/** The same by the machine's fastest way, which is chosen once. */
template <int Dim>
void InterleaveCells(const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys)
{
  PdepIsFastest ? DepositCells<Dim>(cells, count, keys) : DilateCells<Dim>(cells, count, keys);
}
}

#endif
