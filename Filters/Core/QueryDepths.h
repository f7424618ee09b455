// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_QueryDepths_h
#define hashedoctree_QueryDepths_h

#include "Buffer.h"
#include "Octree.h"
#include "PointKeys.h"

#include <cstddef>

namespace hashedoctree
{
/**
 * The keys at MaxDepth of positions, as by Grid::GetKey(); key 0, which names no node, for those
 * that are not finite. O(n). The same whatever the threads. Instantiated for PointSpans of float
 * and double, in two dimensions for PlaneSpans, too. Throws Interrupted.
 */
template <int Dim, typename Points>
Buffer<MortonKey<Dim>> GetQueryKeys(
  const Grid<Dim>& grid, Points queries, const Execution& execution);

/**
 * The histogram of what is really searched for: how many of the positions with these keys lie
 * in leaves of each depth. It is the p_l * f_l of the paper (section 4) with f measured from a
 * second set of points instead of being modelled, from depth 0 to the tree's deepest.
 *
 * Positions outside the root count for the leaf nearest to them, as in Grid; key 0 is left out.
 * O(1 + |l - median|) for each position whose leaf is at depth l. The same whatever the threads.
 * Throws Interrupted.
 */
template <int Dim>
DepthHistogram MeasureQueryDepths(
  const Octree<Dim>& tree, KeySpan<Dim> keys, const Execution& execution);
}

#endif
