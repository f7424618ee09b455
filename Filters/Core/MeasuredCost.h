// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MeasuredCost_h
#define hashedoctree_MeasuredCost_h

#include "TreePart.h"

#include <vector>

namespace hashedoctree
{
/** Mean number of nodes that searches examine, counted for each start depth from 0 to the tree's
 * deepest, and at least to 1: two make a curve. Nothing in it comes from the cost model. */
struct MeasuredCost
{
  std::vector<double> Leaves; ///< Every leaf searched for once, empty ones too.
  std::vector<double> Points; ///< Every point searched for once; 0 for a tree of no points.
};

/**
 * Searches for every leaf of the tree from every start depth and counts, each builder of a tree for
 * those in its part. The points of a leaf share its path, so one search stands for all of them; and
 * a search that comes to a node goes on like the one that starts there, so each node on the way to
 * a leaf is looked up in the table once, for all start depths. The counts are those of FindLeaf().
 * All builders have to call it. O(leaves * depths). Throws Interrupted.
 */
template <int Dim>
MeasuredCost MeasureCost(const TreePart<Dim>& part, const Execution& execution);
}

#endif
