// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_TopDownSearch_h
#define Testing_Benchmarks_TopDownSearch_h

#include "NodeSurroundings.h"
#include "PlacedNode.h"

#include <vector>

/**
 * The classical search for the leaves around a node (paper section 2): from the root down through
 * all children that meet what is around the node, by geometric tests. In a tree whose nodes know
 * their parents it starts at the smallest ancestor of the node that holds all of it (README, row
 * 3). `found` is replaced by the leaves, each once, along the Morton curve. O(nodes that meet it).
 */
template <typename Tree, typename Surroundings, int Dim>
class TopDownSearch
{
public:
  using Node = typename Tree::Node;
  using Placed = PlacedNode<Dim, Node>;

  static void Find(
    const Tree& tree, const Placed& node, const Surroundings& around, std::vector<Placed>& found)
  {
    found.clear();
    const Placed start = GetStart(tree, node, around);
    if (!start.Node->IsLeaf())
    {
      TopDownSearch(tree, node, around, found).SearchChildren(start);
    }
  }

private:
  TopDownSearch(
    const Tree& tree, const Placed& home, const Surroundings& around, std::vector<Placed>& found)
    : Nodes(tree)
    , Home(home)
    , Around(around)
    , Found(found)
  {
  }

  static Placed GetStart(const Tree& tree, const Placed& node, const Surroundings& around)
  {
    Placed start{ tree.GetRoot(), {}, 0 };
    if constexpr (Tree::HasParents)
    {
      start = node;
      const int depth = std::min(around.GetHoldingDepth(), node.Depth - 1);
      for (; start.Depth > std::max(depth, 0); --start.Depth)
      {
        start.Node = start.Node->Parent;
      }
      for (int axis = 0; axis < Dim; ++axis)
      {
        start.Cell[axis] >>= node.Depth - start.Depth;
      }
    }
    return start;
  }

  void SearchChildren(const Placed& parent)
  {
    Placed child{ nullptr, {}, parent.Depth + 1 };
    this->Nodes.ForEachChild(
      *parent.Node,
      [&](unsigned octant)
      {
        for (int axis = 0; axis < Dim; ++axis)
        {
          child.Cell[axis] = 2U * parent.Cell[axis] + (octant >> (Dim - 1 - axis) & 1U);
        }
        const bool isHome = child.Depth == this->Home.Depth && child.Cell == this->Home.Cell;
        return !isHome && this->Around.Meets(child.Cell, child.Depth);
      },
      [&](const Node& node)
      {
        child.Node = &node;
        if (node.IsLeaf())
        {
          this->Found.push_back(child);
        }
        else
        {
          this->SearchChildren(child);
        }
      });
  }

  const Tree& Nodes;
  const Placed& Home;
  const Surroundings& Around;
  std::vector<Placed>& Found;
};

/** The leaves that touch a node. */
template <int Dim, typename Tree, typename Node>
void FindAdjacentTopDown(
  const Tree& tree, const PlacedNode<Dim, Node>& node, std::vector<PlacedNode<Dim, Node>>& found)
{
  const NodeSurroundings<Dim> around(node.Cell, node.Depth);
  TopDownSearch<Tree, NodeSurroundings<Dim>, Dim>::Find(tree, node, around, found);
}

/** The leaves that meet a ball around the center of a node; `radius` is in world units and not
 * negative. */
template <int Dim, typename Tree, typename Node>
void FindInRadiusTopDown(const Tree& tree, const hashedoctree::Grid<Dim>& grid,
  const PlacedNode<Dim, Node>& node, double radius, std::vector<PlacedNode<Dim, Node>>& found)
{
  const BallSurroundings<Dim> around(grid, node.GetKey(), radius);
  TopDownSearch<Tree, BallSurroundings<Dim>, Dim>::Find(tree, node, around, found);
}

#endif
