// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Neighbor_h
#define hashedoctree_Neighbor_h

#include "MortonKey.h"

#include <cstdint>

namespace hashedoctree
{
/** A leaf that a neighbour search from a node has found: at the node's depth (case 1 of paper
 * section 3b), deeper, below a node of that depth (case 2), or higher, where no node of that depth
 * is (case 3). It is never the root, which has no neighbours. */
template <int Dim>
struct Neighbor
{
  MortonKey<Dim> Key;
  std::uint32_t ParentBlock; ///< Block that describes it, as the child Key.GetOctant().
};
}

#endif
