// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeStartDepths_h
#define hashedoctree_NodeStartDepths_h

#include "Octree.h"

#include <cstdint>

namespace hashedoctree
{
/**
 * For every node the start depth from which its adjacent search examines the fewest nodes (end of
 * paper section 4). The paper asks for a median for each node, and uses it in case 3 only. So this
 * is the median depth of the leaves that case 3 finds for the node, each weighing one, with the
 * ties of GetMedianDepth(). 0 where there is no case 3.
 *
 * One byte for each node but the root, 2^Dim for each block. Immutable; thread safe. Not for
 * in-radius searches, in which the leaves above depend on the radius.
 */
template <int Dim>
class NodeStartDepths
{
public:
  NodeStartDepths() = default;

  /** One adjacent search for each node: O(nodes), on the threads of `execution`. Throws
   * Interrupted. */
  NodeStartDepths(const Octree<Dim>& tree, const Execution& execution);

  /** Of a node that is not the root, given the block that describes it. O(1). */
  int Get(std::size_t block, unsigned octant) const { return this->Depths[block << Dim | octant]; }

  std::size_t GetBytes() const { return this->Depths.GetBytes(); }

private:
  Buffer<std::uint8_t> Depths;
};
}

#endif
