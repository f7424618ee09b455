// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_PointQuery_h
#define Testing_Fuzz_PointQuery_h

#include "Grid.h"

#include <cstddef>

/** What is searched for. */
struct PointQuery
{
  enum Kinds
  {
    Closest,
    ClosestWithin,
    ClosestFew,
    Within,
    InBox
  };
  enum Radii
  {
    Given,
    OfNeighbor, ///< The distance of a neighbor, exactly.
    BelowNeighbor,
    AboveNeighbor
  };

  Kinds Kind;
  hashedoctree::Position<3> X;
  hashedoctree::Position<3> Upper; ///< Of a box from X.
  std::size_t Count;
  Radii RadiusKind;
  double Radius;        ///< Where it is given.
  std::size_t Neighbor; ///< Which, by distance and modulo their number, where it is not.
};

#endif
