// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MortonCodes_h
#define hashedoctree_MortonCodes_h

#include "Buffer.h"
#include "PointSelection.h"

namespace hashedoctree
{
/** A point of a data set by its id, and its key at MaxDepth. */
template <int Dim>
struct CodedPoint
{
  MortonKey<Dim> Key;
  PointIndex Id;
};

/** The selected points with their keys, in the order of the data set. O(n). Throws Interrupted.
 * Instantiated for PointSpans of float and double, in two dimensions for PlaneSpans, too. */
template <int Dim, typename Points>
Buffer<CodedPoint<Dim>> EncodePoints(Points points, const PointSelection<Dim>& selection,
  const Grid<Dim>& grid, const Execution& execution);
}

#endif
