// SPDX-License-Identifier: BSD-3-Clause
#ifndef DistributedOctree_h
#define DistributedOctree_h

#include "PointsOctree.h"

#include <vector>

namespace hashedoctree
{
/**
 * The tree over the points of several processes, each of which gives the keys of its own at
 * MaxDepth in the grid that all have, and gets a part of the tree. To be called by all of them. The
 * keys are sent to the process whose part they are in; parts have about as many points each. Where
 * they are to be merged, equal ones of different processes, which count for that, become one. Sets
 * Tree, Processes, Division, Range, Counts, PointsAcross and TreeBytes. O(n) for the points of each
 * process. Throws Interrupted, and std::exception with what to tell the user. Instantiated for 2
 * and 3 dimensions. Private to the module.
 */
template <int Dim>
PointsOctree<Dim> BuildDistributedOctree(const ProcessGroup& processes, const Grid<Dim>& grid,
  std::vector<MortonKey<Dim>> keys, bool merge, const typename Octree<Dim>::Options& options,
  const Execution& execution);
}

#endif
