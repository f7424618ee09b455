// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MeasuredCost_h
#define hashedoctree_MeasuredCost_h

#include "CurveRange.h"
#include "Octree.h"

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/** How many nodes searches examine, counted for each start depth from 0 on. */
struct ExaminedNodes
{
  std::vector<std::uint64_t> Leaves; ///< Every leaf searched for once, empty ones too.
  std::vector<std::uint64_t> Points; ///< Every point searched for once.
};

/** Mean number of nodes that searches examine, for each start depth from 0 to the tree's deepest,
 * and at least to 1: two make a curve. Nothing in it comes from the cost model. */
struct MeasuredCost
{
  std::vector<double> Leaves; ///< Every leaf searched for once, empty ones too.
  std::vector<double> Points; ///< Every point searched for once; 0 for a tree of no points.

  /** The means for the leaves that `counts` has. */
  MeasuredCost(const ExaminedNodes& examined, const DepthCounts& counts);

  /** The last start depth for a tree whose deepest leaf is at a depth. */
  static int GetLastStartDepth(int deepestDepth) { return deepestDepth > 1 ? deepestDepth : 1; }
};

/**
 * Searches for every leaf in a range of the curve, from every start depth up to a last one, and
 * counts. The points of a leaf share its path, so one search stands for all of them; and a search
 * that comes to a node goes on like the one that starts there, so each node on the way to a leaf is
 * looked up in the table once, for all start depths. The counts are those of FindLeaf().
 * O(leaves * depths). Throws Interrupted.
 */
template <int Dim>
ExaminedNodes MeasureExaminedNodes(const Octree<Dim>& tree, const CurveRange<Dim>& range,
  int lastStartDepth, const Execution& execution);

/** The means of a whole tree. */
template <int Dim>
MeasuredCost MeasureCost(const Octree<Dim>& tree, const Execution& execution)
{
  const int last = MeasuredCost::GetLastStartDepth(tree.GetDeepestDepth());
  return { MeasureExaminedNodes(tree, CurveRange<Dim>(), last, execution), tree.GetDepthCounts() };
}
}

#endif
