// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_AdjacentSearch_h
#define hashedoctree_AdjacentSearch_h

#include "DirectSearch.h"
#include "Neighbor.h"
#include "RangeCount.h"

#include <vector>

namespace hashedoctree
{
/**
 * Adjacent search (paper Algorithm 2): the leaves around a node, touching its cell by a face, an
 * edge or a corner. It is the second option of paper section 3b. The cells of the node's own depth
 * around it are looked at, none beyond the border of the root (row 26 of README): up to 3^Dim - 1,
 * in 3D 26, of which 2^Dim - 1 are its siblings. Where one is a leaf, it is found (case 1); where
 * it is internal, the search goes down into the children that touch the node only (case 2, E2);
 * where it does not exist, the leaf above is found by a direct search from min(startDepth, the
 * node's depth - 1) (case 3, E5).
 *
 * The 3^Dim - 1 cells are children of 2^Dim cells at most, so that reaching them takes that many
 * table accesses, and going down one for each internal node; those that are known together are made
 * together. Where such a parent is not internal, none of its children exist, which is known at one
 * look, and one leaf holds them all.
 *
 * `node` is any existing node, leaf or internal; leaves inside an internal one are not its
 * neighbours. The root has none. `found` is replaced by the leaves, each once. In the sparse
 * reading empty octants are no leaves, and an internal node is never found in their place (E4, E5).
 * Their order depends on the tree and the node alone: by the 2^Dim parents, lower ones first, the
 * first coordinate counting most, and within each along the Morton curve. A leaf that holds several
 * of the parents stands where the first of them does.
 *
 * `startDepth`, any depth in [0, MortonKey::MaxDepth], changes the cost, never the answer. The leaf
 * above most often lies just above: MaxDepth, which climbs to it from parent to parent, examines no
 * more nodes than the median of all leaves on any of the standing samples, against what the paper
 * expects (row 25 of README). NodeStartDepths.h has the one that examines the fewest, for each
 * node.
 *
 * Counted are the neighbours of the node's depth that are seen in their parents, the children that
 * case 2 looks at, and for each leaf above, or empty cell in its place, one node and those that the
 * direct search of case 3 for it examines, however many of the parents it holds. Allocates only
 * where `found` grows. Thread safe.
 *
 * Instantiated for NoCount and RangeCount.
 */
template <int Dim, typename Count>
void FindAdjacentLeaves(const Octree<Dim>& tree, MortonKey<Dim> node, int startDepth,
  std::vector<Neighbor<Dim>>& found, Count& count, EmptyOctants reading = EmptyOctants::Leaves);

/** FindAdjacentLeaves() that counts all nodes. */
template <int Dim>
void FindAdjacentLeaves(const Octree<Dim>& tree, MortonKey<Dim> node, int startDepth,
  std::vector<Neighbor<Dim>>& found, NodeCount& count, EmptyOctants reading = EmptyOctants::Leaves)
{
  RangeCount<Dim> all;
  FindAdjacentLeaves(tree, node, startDepth, found, all, reading);
  count.Nodes += all.GetNodes();
}

/** FindAdjacentLeaves() without counting. */
template <int Dim>
void FindAdjacentLeaves(const Octree<Dim>& tree, MortonKey<Dim> node, int startDepth,
  std::vector<Neighbor<Dim>>& found, EmptyOctants reading = EmptyOctants::Leaves)
{
  NoCount count;
  FindAdjacentLeaves(tree, node, startDepth, found, count, reading);
}
}

#endif
