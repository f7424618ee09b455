// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DecisionSearch_h
#define hashedoctree_DecisionSearch_h

#include "DepthDecisionTree.h"
#include "DirectSearch.h"

namespace hashedoctree
{
/**
 * Direct search that goes from depth to depth by decisions instead of child by child: the same leaf
 * as by FindLeaf() of DirectSearch.h, whatever the decisions are, and decisions.GetCost(l) nodes
 * examined for a leaf at depth l. They may come from any histogram that ends at MortonKey::MaxDepth
 * or before.
 *
 * Which node is examined next is known only when the last one is, while the search of
 * DirectSearch.h asks for nodes ahead: so the fewest nodes are not always the least time. Other
 * arguments as there. Thread safe; O(depths).
 */
template <template <int> class Tree, int Dim, typename Count>
FoundLeaf<Dim> FindLeaf(const Tree<Dim>& tree, MortonKey<Dim> key,
  const DepthDecisionTree& decisions, Count& count, EmptyOctants reading = EmptyOctants::Leaves)
{
  int depth = decisions.GetRootDepth();
  const auto found = [&](std::uint32_t block, bool occupied)
  {
    return FoundLeaf<Dim>{ key.AtDepth(depth), block, occupied || reading == EmptyOctants::Leaves };
  };
  for (;;)
  {
    count.AddNode();
    if (depth == 0)
    {
      if (!tree.IsRootInternal())
      {
        return found(0, tree.GetNumberOfPoints() != 0);
      }
      depth = decisions.GetDeeper(0);
      continue;
    }
    const auto* parent = tree.GetTable().Find(key.AtDepth(depth - 1).GetValue());
    if (parent == nullptr)
    {
      depth = decisions.GetHigher(depth);
      continue;
    }
    const unsigned octant = key.AtDepth(depth).GetOctant();
    if ((parent->Internal >> octant & 1U) == 0)
    {
      return found(parent->Block, (parent->Occupied >> octant & 1U) != 0);
    }
    depth = decisions.GetDeeper(depth);
  }
}
}

#endif
