// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MortonOrder_h
#define hashedoctree_MortonOrder_h

#include "MortonCodes.h"

namespace hashedoctree
{
/**
 * Sorts coded points along the Morton curve: by key, points of equal keys by id, given that they
 * come in the order of their ids. A radix partition from the most significant digit downwards:
 * the digits that all points of a range share cost one pass of reading, and ranges of a few
 * points are sorted by insertion. O(n) for n points; uses a second array of the same size.
 * The result does not depend on the number of threads. Throws Interrupted; the points are then in
 * no particular order.
 */
template <int Dim>
void SortAlongMortonCurve(Buffer<CodedPoint<Dim>>& points, const Execution& execution);
}

#endif
