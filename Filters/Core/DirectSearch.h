// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DirectSearch_h
#define hashedoctree_DirectSearch_h

#include "Octree.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace hashedoctree
{
/** The leaf of a position, or the empty cell that a sparse tree has in its place. */
template <int Dim>
struct FoundLeaf
{
  MortonKey<Dim> Key;
  std::uint32_t ParentBlock; ///< Block that describes it; 0 for the root.
  /** False in the sparse reading where no leaf holds the position: Key is then the empty cell, the
   * missing child of the deepest existing node (paper E4). */
  bool Exists;
};

/** What searches tell of the nodes that they examine: AddNode() of one, AddNodes() of several, and
 * Enter() of the one on whose behalf the next are. This counts nothing, and costs nothing. */
struct NoCount
{
  /** As of RangeCount. */
  template <int Dim>
  void Enter(MortonKey<Dim>)
  {
  }
  void AddNode() {}
  void AddNodes(int) {}
};

/** Counts the nodes that one search, or several, examine: the cost in the sense of the paper. */
struct NodeCount
{
  std::uint64_t Nodes = 0;
  void AddNode() { ++this->Nodes; }
};

/** Asks for no nodes ahead. */
struct PrefetchNone
{
  template <int Dim>
  void operator()(MortonKey<Dim>, int) const
  {
  }
};

/** Asks for nodes that are likely to be examined. Where a node is in the table follows from its key
 * alone, so the machine loads them while the search waits for the first. */
template <typename Table>
struct PrefetchNodes
{
  const Table& Nodes;

  template <int Dim>
  void operator()(MortonKey<Dim> key, int depth) const
  {
    this->Nodes.Prefetch(key.AtDepth(depth).GetValue());
  }
};

/** FindLeaf() with one of these, `prefetch`, which hears of nodes early. Private to it and to
 * FindLeaves(). */
template <template <int> class Tree, int Dim, typename Count, typename Prefetch>
FoundLeaf<Dim> FindLeafPrefetching(const Tree<Dim>& tree, MortonKey<Dim> key, int startDepth,
  Count& count, EmptyOctants reading, const Prefetch& prefetch)
{
  const auto& table = tree.GetTable();
  prefetch(key, startDepth);
  prefetch(key, std::max(startDepth - 2, 0));

  // Up (case 3): no node at `depth` as long as it has no parent.
  const typename Tree<Dim>::Entry* parent = nullptr;
  int depth = startDepth;
  for (; depth > 0; --depth)
  {
    count.AddNode();
    parent = table.Find(key.AtDepth(depth - 1).GetValue());
    if (parent != nullptr)
    {
      break;
    }
    prefetch(key, std::max(depth - 3, 0));
  }

  if (depth == 0)
  {
    count.AddNode();
    if (!tree.IsRootInternal())
    {
      return { MortonKey<Dim>::Root(), 0,
        tree.GetNumberOfPoints() != 0 || reading == EmptyOctants::Leaves };
    }
    parent = table.Find(MortonKey<Dim>::Root().GetValue());
    ++depth;
    count.AddNode();
  }

  // Down (case 2), as long as the node at `depth` is internal.
  unsigned octant = key.AtDepth(depth).GetOctant();
  while ((parent->Internal >> octant & 1U) != 0)
  {
    parent = table.Find(key.AtDepth(depth).GetValue());
    ++depth;
    prefetch(key, depth);
    count.AddNode();
    octant = key.AtDepth(depth).GetOctant();
  }
  return { key.AtDepth(depth), parent->Block,
    (parent->Occupied >> octant & 1U) != 0 || reading == EmptyOctants::Leaves };
}

/**
 * Direct search (paper Algorithm 1): the leaf that holds a position, found by starting at an
 * estimated depth. The node there is reached directly through the table. It is the leaf (case 1 of
 * paper section 3a), or an internal node, and the leaf is deeper (case 2), or does not exist, and
 * the leaf is higher (case 3): so the nodes below it or above it are reached, one after the other,
 * until one is a leaf.
 *
 * The node at depth l is examined by reading what the table tells of its parent: that the node is
 * internal, that it is a leaf, or, when there is no such parent, that it does not exist. So a leaf
 * is known at first sight (paper E3), and finding the leaf at depth l examines exactly
 * 1 + |l - startDepth| nodes. Start depth 0 is the classical search from the root.
 *
 * `key` is the position's key at MaxDepth (Grid::GetKey()); `startDepth` may be any depth in
 * [0, MortonKey::MaxDepth] and changes the cost, never the leaf. In the sparse reading an empty
 * octant is seen in its parent, at the same cost. Thread safe; O(1 + |l - startDepth|).
 *
 * `Tree` is Octree, or another tree that has these members of it: GetTable(), IsRootInternal(),
 * GetNumberOfPoints(); and whose table tells which children are internal and which hold points.
 */
template <template <int> class Tree, int Dim, typename Count>
FoundLeaf<Dim> FindLeaf(const Tree<Dim>& tree, MortonKey<Dim> key, int startDepth, Count& count,
  EmptyOctants reading = EmptyOctants::Leaves)
{
  const auto& table = tree.GetTable();
  using Table = std::decay_t<decltype(table)>;
  return table.IsCached()
    ? FindLeafPrefetching(tree, key, startDepth, count, reading, PrefetchNone())
    : FindLeafPrefetching(tree, key, startDepth, count, reading, PrefetchNodes<Table>{ table });
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
