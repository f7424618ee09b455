// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MortonOrder_h
#define hashedoctree_MortonOrder_h

#include "KeyedPoints.h"
#include "SpareMemory.h"

namespace hashedoctree
{
/**
 * Sorts points by their keys along the Morton curve as far as the leaves of a tree need it: leaf
 * after leaf in the order of their keys, where a node is split while it holds more than
 * maxPointsPerLeaf points, at least 1, and is not at maxDepth. In a leaf, points of equal keys
 * stand by id, given that they come in the order of their ids; the others in an order that follows
 * from the points and the limits alone, not from the number of threads. With one point per leaf and
 * MortonKey::MaxDepth, all points stand by key, then by id.
 *
 * Points that come in the order of their keys are left as they are. Others are partitioned by
 * radix, from the root downwards, several depths at a time. Depths that do not part the points of a
 * node cost one pass of reading; a large node passes over all of them in one more. A few points are
 * sorted by insertion. O(n) for n points; uses a second array of the same size, which is in the
 * spare memory if that is large enough. Throws Interrupted; the points are then in no particular
 * order.
 */
template <int Dim>
void SortAlongMortonCurve(Buffer<KeyedPoint<Dim>>& points, std::size_t maxPointsPerLeaf,
  int maxDepth, const Execution& execution, SpareMemory spare = {});
}

#endif
