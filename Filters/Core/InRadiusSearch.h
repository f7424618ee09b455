// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_InRadiusSearch_h
#define hashedoctree_InRadiusSearch_h

#include "DirectSearch.h"
#include "Neighbor.h"
#include "RangeCount.h"

#include <vector>

namespace hashedoctree
{
/**
 * In-radius search (paper section 3c): the leaves around a node whose closed cells meet the closed
 * ball around its center. NodeBall.h says what is computed, to the last digit.
 *
 * `node` is any existing node, leaf or internal; itself, and what lies in it, is left out. The root
 * has no neighbours. `radius` is in world units: negative or NaN finds nothing, infinite all other
 * leaves. It may be larger than the node (E14). The cells of the node's size in the ball can be
 * millions, so the search begins with the cells that cover the ball: at most 2^Dim, of the deepest
 * depth whose cells are as wide (NodeBall::GetCover()). Each is reached directly through the table;
 * where there is none, a direct search from min(startDepth, depth of these cells) finds the leaf
 * above. From there the search goes down through the octants of the children that meet the ball,
 * which stand side by side: some nodes of one depth together, so that the machine loads what they
 * tell at once.
 *
 * `found` is replaced by the leaves, each once. Their order depends on the tree, the node and the
 * radius alone: for one covering cell after the other the leaf above it or its children that are
 * leaves; then what is below its other children, depth by depth as long as these are few, else
 * group by group. In the sparse reading empty octants are no leaves, and an internal node is never
 * found in their place (E4, E5).
 *
 * `startDepth`, any depth in [0, MortonKey::MaxDepth], changes the cost, never the answer. Counted
 * are the children looked at on the way down, and for each leaf above, or empty cell in its place,
 * one node and those that the direct search for it examines, however many of the covering cells it
 * holds. O(nodes that meet the ball, and their children), plus O(MaxDepth). Allocates only where
 * `found` grows. Thread safe.
 *
 * Instantiated for NoCount, for AVX2, too (which one runs is found at run time), and for
 * RangeCount, only as it runs on every machine.
 */
template <int Dim, typename Count>
void FindLeavesInRadius(const Octree<Dim>& tree, MortonKey<Dim> node, double radius, int startDepth,
  std::vector<Neighbor<Dim>>& found, Count& count, EmptyOctants reading = EmptyOctants::Leaves);

/** FindLeavesInRadius() that counts all nodes. */
template <int Dim>
void FindLeavesInRadius(const Octree<Dim>& tree, MortonKey<Dim> node, double radius, int startDepth,
  std::vector<Neighbor<Dim>>& found, NodeCount& count, EmptyOctants reading = EmptyOctants::Leaves)
{
  RangeCount<Dim> all;
  FindLeavesInRadius(tree, node, radius, startDepth, found, all, reading);
  count.Nodes += all.GetNodes();
}

/** FindLeavesInRadius() without counting. */
template <int Dim>
void FindLeavesInRadius(const Octree<Dim>& tree, MortonKey<Dim> node, double radius, int startDepth,
  std::vector<Neighbor<Dim>>& found, EmptyOctants reading = EmptyOctants::Leaves)
{
  NoCount count;
  FindLeavesInRadius(tree, node, radius, startDepth, found, count, reading);
}
}

#endif
