// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeList_h
#define hashedoctree_NodeList_h

#include "CurveRange.h"
#include "Octree.h"

namespace hashedoctree
{
/** Which nodes a list holds, beside leaves with points. */
struct NodeListOptions
{
  bool EmptyLeaves = false;
  bool InternalNodes = false;
  int Depth = -1; ///< Of nodes at this depth only; of all when negative.
};

/** The nodes of a tree that are in a range of the curve, ordered by depth, then by key. O(nodes).
 * Throws Interrupted. */
template <int Dim>
Buffer<typename Octree<Dim>::Node> ListNodes(const Octree<Dim>& tree, NodeListOptions options,
  const Execution& execution, const CurveRange<Dim>& range = {});
}

#endif
