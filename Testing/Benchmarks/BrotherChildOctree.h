// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_BrotherChildOctree_h
#define Testing_Benchmarks_BrotherChildOctree_h

#include "CenterDescent.h"
#include "NodePool.h"
#include "PlacedNode.h"
#include "SortedPoints.h"

/** Whether nodes know their parents. */
enum class ParentPointers
{
  No,
  Yes
};

/** A pointer to the parent, or nothing. */
template <typename Node, ParentPointers Parents>
struct ParentPointer
{
  Node* Parent;
};
template <typename Node>
struct ParentPointer<Node, ParentPointers::No>
{
};

/**
 * The brother/child octree (paper Fig. 3b; README, rows 2, 3), for comparison only: 24 bytes a
 * node, 32 with a pointer to the parent. Siblings are chained in the order of octants, so that the
 * last of 2^Dim is reached by passing all others. TopDownSearch.h searches it for neighbours.
 * Immutable; thread safe.
 */
template <int Dim, ParentPointers Parents>
class BrotherChildOctree
{
public:
  using Point = typename SortedPoints<Dim>::Point;
  static constexpr bool HasParents = Parents == ParentPointers::Yes;
  static constexpr unsigned NumberOfOctants = 1U << Dim;

  struct Node : ParentPointer<Node, Parents>
  {
    Node* FirstChild;  ///< Null in a leaf.
    Node* Next;        ///< The next sibling, or null.
    const Point* Data; ///< In a leaf with points: the first of them.

    bool IsLeaf() const { return this->FirstChild == nullptr; }
  };

  /** The points must outlive the tree. O(nodes * log(points)). */
  explicit BrotherChildOctree(const SortedPoints<Dim>& points) { points.Split(*this, &this->Root); }
  BrotherChildOctree(const BrotherChildOctree&) = delete; // The pointers lead into this one.
  BrotherChildOctree& operator=(const BrotherChildOctree&) = delete;

  const Node* GetRoot() const { return &this->Root; }
  std::size_t GetBytes() const { return sizeof(Node) + this->Pool.GetBytes(); }

  /** The leaf that holds a cell of MaxDepth, from the root. */
  PlacedNode<Dim, Node> FindLeaf(const hashedoctree::Cell<Dim>& x) const
  {
    CenterDescent<Dim> descent(x);
    const Node* node = &this->Root;
    while (!node->IsLeaf())
    {
      node = node->FirstChild;
      for (unsigned octant = descent.GoDown(); octant > 0; --octant)
      {
        node = node->Next;
      }
    }
    return { node, descent.GetCell(), descent.GetDepth() };
  }

  /** Calls function(child) for each child of a node with wants(octant), in the order of octants,
   * each before the next is asked for. */
  template <typename Wants, typename Function>
  void ForEachChild(const Node& node, const Wants& wants, const Function& function) const
  {
    unsigned octant = 0;
    for (const Node* child = node.FirstChild; child != nullptr; child = child->Next)
    {
      if (wants(octant++))
      {
        function(*child);
      }
    }
  }

private:
  friend class SortedPoints<Dim>;
  static void MakeLeaf(Node* node, const Point* data) { node->Data = data; }
  Node* MakeChildren(Node* node)
  {
    node->FirstChild = this->Pool.AddSiblings();
    for (unsigned octant = 0; octant < NumberOfOctants; ++octant)
    {
      Node& child = node->FirstChild[octant];
      child.Next = octant + 1 < NumberOfOctants ? &child + 1 : nullptr;
      if constexpr (HasParents)
      {
        child.Parent = node;
      }
    }
    return node->FirstChild;
  }
  static Node* GetChild(Node* children, unsigned octant) { return children + octant; }

  Node Root{};
  NodePool<Node, NumberOfOctants> Pool;
};

#endif
