// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_LeafQuery_h
#define Testing_Fuzz_LeafQuery_h

#include "Grid.h"

/** A node of an octree, and how the leaves around it are searched for. */
template <int Dim>
struct LeafQuery
{
  hashedoctree::Position<Dim> X;
  int Depth;      ///< The node that holds X at this depth, or the leaf above where there is none.
  int StartDepth; ///< Of all searches.
  double Radius;  ///< In world units.
};

#endif
