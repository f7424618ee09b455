// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_CenterDescent_h
#define Testing_Benchmarks_CenterDescent_h

#include "MortonKey.h"

/**
 * The way from the root to a position by comparing its coordinates with the centers of the nodes,
 * as trees with pointers are searched (paper section 2). Centers are not stored, but follow from
 * the way. They and the position are in cells of MaxDepth, so that no rounding parts this search
 * from the others.
 */
template <int Dim>
class CenterDescent
{
public:
  explicit CenterDescent(const hashedoctree::Cell<Dim>& x)
    : X(x)
  {
    this->Center.fill(this->Half);
  }

  /** Goes to the child that holds the position, and returns its octant. */
  unsigned GoDown()
  {
    this->Half /= 2;
    ++this->Depth;
    unsigned octant = 0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const bool isUpper = this->X[axis] >= this->Center[axis];
      octant = octant << 1 | (isUpper ? 1U : 0U);
      this->Center[axis] += isUpper ? this->Half : 0U - this->Half;
    }
    return octant;
  }

  int GetDepth() const { return this->Depth; }

  /** The node reached, in the grid of its depth. */
  hashedoctree::Cell<Dim> GetCell() const
  {
    hashedoctree::Cell<Dim> cell;
    for (int axis = 0; axis < Dim; ++axis)
    {
      cell[axis] = this->X[axis] >> (hashedoctree::MortonKey<Dim>::MaxDepth - this->Depth);
    }
    return cell;
  }

private:
  const hashedoctree::Cell<Dim> X;
  hashedoctree::Cell<Dim> Center;
  std::uint32_t Half = 1U << (hashedoctree::MortonKey<Dim>::MaxDepth - 1);
  int Depth = 0;
};

#endif
