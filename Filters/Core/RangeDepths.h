// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_RangeDepths_h
#define hashedoctree_RangeDepths_h

#include "CurveRange.h"
#include "Octree.h"

namespace hashedoctree
{
/** Leaves, empty leaves and points of each depth, as Octree::GetDepthCounts(), of the leaves in a
 * range of the curve only: those of ranges that divide the curve add up. Empty histograms where
 * there is none. O(nodes). Throws Interrupted. */
template <int Dim>
DepthCounts CountDepths(
  const Octree<Dim>& tree, const CurveRange<Dim>& range, const Execution& execution);
}

#endif
