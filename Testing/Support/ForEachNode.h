// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_ForEachNode_h
#define Testing_Support_ForEachNode_h

#include "Octree.h"

/** Calls function(node) for every node of a tree, from the root downwards. */
template <int Dim, typename Function>
void ForEachNode(const hashedoctree::Octree<Dim>& tree, const Function& function)
{
  function(tree.GetRoot());
  for (std::size_t block = 0; block < tree.GetNumberOfInternalNodes(); ++block)
  {
    for (unsigned octant = 0; octant < hashedoctree::Octree<Dim>::NumberOfOctants; ++octant)
    {
      function(tree.GetChild(block, octant));
    }
  }
}

/** Calls function(leaf) for every leaf, empty ones too. */
template <int Dim, typename Function>
void ForEachLeaf(const hashedoctree::Octree<Dim>& tree, const Function& function)
{
  ForEachNode(tree,
    [&function](const typename hashedoctree::Octree<Dim>::Node& node)
    {
      if (!node.Internal)
      {
        function(node);
      }
    });
}

#endif
