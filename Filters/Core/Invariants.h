// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Invariants_h
#define hashedoctree_Invariants_h

#include "Octree.h"

#include <string>
#include <vector>

namespace hashedoctree
{
/**
 * Names every law that the tree breaks, once each with the first place where it does; empty for a
 * sound tree. The laws:
 * - the leaves tile the root: their keys cover all cells of MaxDepth once;
 * - the ranges of the children partition their parent's, and the root's is all points;
 * - every point that the selection keeps stands in the order once, in a leaf whose cell holds it,
 *   equal keys by id; no other point does (an id of no point ends the check);
 * - a node is internal just when it holds more than MaxPointsPerLeaf points above MaxDepth;
 * - blocks are in breadth-first order and the first child follows from the masks;
 * - the table finds every internal node, with the same masks, and nothing else;
 * - the counts per depth are those of the leaves.
 *
 * Written to be independent of how the tree is built: it walks all nodes from the root. O(nodes +
 * points * log(points of a leaf)), one thread. For tests and debugging.
 */
template <int Dim, typename Real>
std::vector<std::string> FindBrokenLaws(
  const Octree<Dim>& tree, PointSpan<Dim, Real> points, const PointSelection<Dim>& selection);
}

#endif
