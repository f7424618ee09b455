// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_CellsAround_h
#define Testing_Benchmarks_CellsAround_h

#include "Interleaving.h"
#include "NeighborDirection.h"

/** Moves a cell of a depth by one; false where that is outside the root. */
template <int Dim>
bool Step(hashedoctree::Cell<Dim>& cell, int depth, hashedoctree::NeighborDirection<Dim> direction)
{
  for (int axis = 0; axis < Dim; ++axis)
  {
    const unsigned bit = 1U << (Dim - 1 - axis);
    cell[axis] += (direction.Axes & bit) == 0 ? 0U : (direction.Upper & bit) != 0 ? 1U : 0U - 1U;
    if (cell[axis] >> depth != 0)
    {
      return false;
    }
  }
  return true;
}

/** Calls function(key, direction) for a cell and the 3^Dim - 1 of its size around it, those outside
 * the root left out. */
template <int Dim, typename Function>
void ForEachCellAround(hashedoctree::MortonKey<Dim> middle, const Function& function)
{
  using Direction = hashedoctree::NeighborDirection<Dim>;
  const int depth = middle.GetDepth();
  const hashedoctree::Cell<Dim> home = middle.GetCell();
  for (unsigned axes = 0; axes < 1U << Dim; ++axes)
  {
    for (unsigned upper = 0; upper <= axes; ++upper)
    {
      hashedoctree::Cell<Dim> cell = home;
      const Direction direction{ axes, upper };
      if ((upper & ~axes) == 0 && Step<Dim>(cell, depth, direction))
      {
        function(hashedoctree::InterleaveCell<Dim>(cell, depth), direction);
      }
    }
  }
}

#endif
