// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PlacedNode_h
#define Testing_Benchmarks_PlacedNode_h

#include "MortonKey.h"

/** A node of a tree, and where it lies, which a node with pointers does not know itself. */
template <int Dim, typename TreeNode>
struct PlacedNode
{
  const TreeNode* Node;
  hashedoctree::Cell<Dim> Cell; ///< In the grid of its depth.
  int Depth;

  hashedoctree::MortonKey<Dim> GetKey() const
  {
    return hashedoctree::MortonKey<Dim>::FromCell(this->Cell, this->Depth);
  }
};

#endif
