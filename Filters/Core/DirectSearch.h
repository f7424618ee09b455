// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DirectSearch_h
#define hashedoctree_DirectSearch_h

#include "Octree.h"

#include <array>
#include <cstdint>

namespace hashedoctree
{
/** The three cases of the direct search (paper section 3a). */
enum class SearchCase
{
  Hit,  ///< Case 1: the node at the start depth is the leaf.
  Down, ///< Case 2: it is an internal node; the leaf lies deeper.
  Up    ///< Case 3: it does not exist; the leaf lies higher.
};

/** The leaf of a position, or the empty cell that a sparse tree has in its place. */
template <int Dim>
struct FoundLeaf
{
  MortonKey<Dim> Key;
  std::uint32_t ParentBlock; ///< Block that describes it; no meaning for the root.
  SearchCase Case;
  /** False in the sparse reading where no leaf holds the position: Key is then the empty cell, the
   * missing child of the deepest existing node (paper E4). */
  bool Exists;
};

/** Counts nothing, and costs nothing. */
struct NoCount
{
  void AddNode() {}
};

/** Counts the nodes that one search, or several, examine: the cost in the sense of the paper. */
struct NodeCount
{
  std::uint64_t Nodes = 0;
  void AddNode() { ++this->Nodes; }
};

/**
 * Direct search (paper Algorithm 1): the leaf that holds a position, found by starting at an
 * estimated depth. The node there is reached directly through the table; from it the search goes
 * down child by child, or up parent by parent.
 *
 * The node at depth l is examined by reading what its parent's block tells of it: that it is
 * internal, that it is a leaf, or, when there is no such block, that the node does not exist. So a
 * leaf is known at first sight (paper E3), and finding the leaf at depth l examines exactly
 * 1 + |l - startDepth| nodes. Start depth 0 is the classical search from the root.
 *
 * `key` is the position's key at MaxDepth (Grid::GetKey()); `startDepth` may be any depth in
 * [0, MortonKey::MaxDepth] and changes the cost, never the leaf. In the sparse reading an empty
 * octant is seen in its parent, at the same cost. Thread safe; O(1 + |l - startDepth|).
 *
 * `Tree` is Octree, or another tree that has these members of it: GetTable(), GetBlock(),
 * GetRootBlock(), GetChildBlock(), IsRootInternal(), GetNumberOfPoints(); and whose table and
 * blocks tell which children are internal and which hold points.
 */
template <template <int> class Tree, int Dim, typename Count>
FoundLeaf<Dim> FindLeaf(const Tree<Dim>& tree, MortonKey<Dim> key, int startDepth, Count& count,
  EmptyOctants reading = EmptyOctants::Leaves)
{
  const auto found = [reading](MortonKey<Dim> leaf, std::uint32_t block, SearchCase searchCase,
                       bool occupied) {
    return FoundLeaf<Dim>{ leaf, block, searchCase, occupied || reading == EmptyOctants::Leaves };
  };

  // Up (case 3): no node at `depth` as long as its parent has no block.
  int depth = startDepth;
  unsigned octant = 0;
  const typename Tree<Dim>::Entry* parent = nullptr;
  for (; depth > 0; --depth)
  {
    count.AddNode();
    parent = tree.GetTable().Find(key.AtDepth(depth - 1).GetValue());
    if (parent != nullptr)
    {
      octant = key.AtDepth(depth).GetOctant();
      break;
    }
  }

  std::uint32_t block = tree.GetRootBlock();
  if (parent == nullptr)
  {
    count.AddNode();
    if (!tree.IsRootInternal())
    {
      return found(MortonKey<Dim>::Root(), 0, startDepth == 0 ? SearchCase::Hit : SearchCase::Up,
        tree.GetNumberOfPoints() != 0);
    }
  }
  else
  {
    if ((parent->Internal >> octant & 1U) == 0)
    {
      return found(key.AtDepth(depth), parent->Block,
        depth == startDepth ? SearchCase::Hit : SearchCase::Up,
        (parent->Occupied >> octant & 1U) != 0);
    }
    block = Tree<Dim>::GetChildBlock(tree.GetBlock(parent->Block), octant);
  }

  // Down (case 2): `block` is that of the node at `depth`.
  for (;;)
  {
    ++depth;
    count.AddNode();
    const typename Tree<Dim>::Block& here = tree.GetBlock(block);
    octant = key.AtDepth(depth).GetOctant();
    if ((here.Internal >> octant & 1U) == 0)
    {
      return found(
        key.AtDepth(depth), block, SearchCase::Down, (here.Occupied >> octant & 1U) != 0);
    }
    block = Tree<Dim>::GetChildBlock(here, octant);
  }
}

/** FindLeaf() without counting. */
template <template <int> class Tree, int Dim>
FoundLeaf<Dim> FindLeaf(const Tree<Dim>& tree, MortonKey<Dim> key, int startDepth,
  EmptyOctants reading = EmptyOctants::Leaves)
{
  NoCount count;
  return FindLeaf(tree, key, startDepth, count, reading);
}

/** How many nodes a search for the position examines. */
template <template <int> class Tree, int Dim>
std::uint64_t CountExaminedNodes(const Tree<Dim>& tree, MortonKey<Dim> key, int startDepth)
{
  NodeCount count;
  FindLeaf(tree, key, startDepth, count);
  return count.Nodes;
}
}

#endif
