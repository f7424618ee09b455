// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_LeafNumberShifts_h
#define hashedoctree_LeafNumberShifts_h

#include "CurveRange.h"
#include "Octree.h"

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/** How many leaves of each depth have a number in a reading (LeafNumbers). */
DepthHistogram CountNumberedLeaves(const DepthCounts& counts, EmptyOctants reading);

/**
 * What to add, by depth, to the number that a leaf has in the tree of one of several builders
 * (CurveDivision) for its number in the tree that they make together. It is right for all leaves
 * that hold a key of the builder's range: those of one depth stand side by side in both orders.
 *
 * `counts` are those of the whole tree; `before` says how many numbered leaves of each depth are in
 * the ranges of the builders before this one. O(nodes). Throws Interrupted.
 */
template <int Dim>
std::vector<std::int64_t> FindLeafNumberShifts(const Octree<Dim>& tree,
  const CurveRange<Dim>& range, const DepthCounts& counts, const DepthHistogram& before,
  EmptyOctants reading, const Execution& execution);
}

#endif
