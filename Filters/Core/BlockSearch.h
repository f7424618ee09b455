// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_BlockSearch_h
#define hashedoctree_BlockSearch_h

#include "Octree.h"

namespace hashedoctree
{
/** An internal node, by its block. */
struct FoundBlock
{
  std::uint32_t Block;
  int Depth;
};

/**
 * The deepest internal node that holds a position, at a depth or above it: the one at the depth is
 * looked for directly, then parent after parent. `key` is the position's at MaxDepth, `depth` in
 * [0, MaxDepth - 1]; the root must be internal. Every look into the table counts. Thread safe.
 */
template <int Dim, typename Count>
FoundBlock FindBlock(const Octree<Dim>& tree, MortonKey<Dim> key, int depth, Count& count)
{
  for (; depth > 0; --depth)
  {
    count.AddNode();
    if (const auto* entry = tree.GetTable().Find(key.AtDepth(depth).GetValue()))
    {
      return { entry->Block, depth };
    }
  }
  return { 0, 0 };
}
}

#endif
