// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Neighbor_h
#define hashedoctree_Neighbor_h

#include "MortonKey.h"

#include <cstdint>

namespace hashedoctree
{
/** The three cases of the neighbour searches (paper section 3b): where a neighbour of a node lies
 * in the tree, beside the depth of that node. */
enum class NeighborCase
{
  SameDepth, ///< Case 1: at the same depth.
  Descended, ///< Case 2: deeper, below a node of the same depth.
  Above      ///< Case 3: higher; no node of the same depth is there.
};

/** A leaf that a neighbour search has found. It is never the root, which has no neighbours. */
template <int Dim>
struct Neighbor
{
  MortonKey<Dim> Key;
  std::uint32_t ParentBlock; ///< Block that describes it, as the child Key.GetOctant().
  NeighborCase Case;
};
}

#endif
