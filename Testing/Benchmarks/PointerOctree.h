// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PointerOctree_h
#define Testing_Benchmarks_PointerOctree_h

#include "CenterDescent.h"
#include "NodePool.h"
#include "PlacedNode.h"
#include "SortedPoints.h"

#include <array>

/**
 * The octree with a pointer to each child (paper Fig. 3a; README, row 1), for comparison only: 72
 * bytes a node in 3D. TopDownSearch.h searches it for neighbours. Immutable; thread safe.
 */
template <int Dim>
class PointerOctree
{
public:
  using Point = typename SortedPoints<Dim>::Point;
  static constexpr bool HasParents = false;
  static constexpr unsigned NumberOfOctants = 1U << Dim;

  struct Node
  {
    std::array<Node*, NumberOfOctants> Children; ///< All null in a leaf, none elsewhere.
    const Point* Data;                           ///< In a leaf with points: the first of them.

    bool IsLeaf() const { return this->Children[0] == nullptr; }
  };

  /** The points must outlive the tree. O(nodes * log(points)). */
  explicit PointerOctree(const SortedPoints<Dim>& points) { points.Split(*this, &this->Root); }
  PointerOctree(const PointerOctree&) = delete; // The pointers lead into this one.
  PointerOctree& operator=(const PointerOctree&) = delete;

  const Node* GetRoot() const { return &this->Root; }
  std::size_t GetBytes() const { return sizeof(Node) + this->Pool.GetBytes(); }

  /** The leaf that holds a cell of MaxDepth, from the root. */
  PlacedNode<Dim, Node> FindLeaf(const hashedoctree::Cell<Dim>& x) const
  {
    CenterDescent<Dim> descent(x);
    const Node* node = &this->Root;
    while (!node->IsLeaf())
    {
      node = node->Children[descent.GoDown()];
    }
    return { node, descent.GetCell(), descent.GetDepth() };
  }

  /** Calls function(child) for each child of a node with wants(octant), in the order of octants,
   * each before the next is asked for. */
  template <typename Wants, typename Function>
  void ForEachChild(const Node& node, const Wants& wants, const Function& function) const
  {
    for (unsigned octant = 0; octant < NumberOfOctants; ++octant)
    {
      if (wants(octant))
      {
        function(*node.Children[octant]);
      }
    }
  }

private:
  friend class SortedPoints<Dim>;
  static void MakeLeaf(Node* node, const Point* data) { node->Data = data; }
  Node* MakeChildren(Node* node)
  {
    Node* children = this->Pool.AddSiblings();
    for (unsigned octant = 0; octant < NumberOfOctants; ++octant)
    {
      node->Children[octant] = children + octant;
    }
    return children;
  }
  static Node* GetChild(Node* children, unsigned octant) { return children + octant; }

  Node Root{};
  NodePool<Node, NumberOfOctants> Pool;
};

#endif
