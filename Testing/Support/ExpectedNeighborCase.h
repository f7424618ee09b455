// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_ExpectedNeighborCase_h
#define Testing_Support_ExpectedNeighborCase_h

#include "Neighbor.h"

/** The case of a neighbour of a node, by their depths. */
template <int Dim>
hashedoctree::NeighborCase GetExpectedCase(
  hashedoctree::MortonKey<Dim> neighbor, hashedoctree::MortonKey<Dim> node)
{
  const int deeper = neighbor.GetDepth() - node.GetDepth();
  return deeper == 0 ? hashedoctree::NeighborCase::SameDepth
    : deeper > 0     ? hashedoctree::NeighborCase::Descended
                     : hashedoctree::NeighborCase::Above;
}

#endif
