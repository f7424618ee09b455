// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperHashedOctree_h
#define Testing_Benchmarks_PaperHashedOctree_h

#include "CellsAround.h"
#include "ChainedNodeTable.h"
#include "DepthStatistics.h"
#include "DirectSearch.h"
#include "NodeBall.h"
#include "SortedPoints.h"

#include <vector>

/** The slots of the paper's hash: the 21 low bits of the key, whatever the number of nodes. */
inline hashedoctree::LowBitsHash GetPaperHash()
{
  return hashedoctree::LowBitsHash(std::size_t(1) << 20);
}

/**
 * The hashed octree as in the paper (section 2, Fig. 3c; README, rows 4, 5), for comparison only:
 * every node, leaf or not, is in one table, under its key, and reaching it takes one access to the
 * table. 24 bytes a node, and as much for each slot that stays free. The searches are Algorithms 1
 * and 2 with the right reading of what is unclear in them; `startDepth` is in [0,
 * MortonKey::MaxDepth] and changes their cost, never their answer. `count` may be a NodeCount, of
 * the looks that a search for neighbours takes in the table. Immutable; thread safe.
 */
template <int Dim, typename Hash>
class PaperHashedOctree
{
public:
  using Key = hashedoctree::MortonKey<Dim>;
  using Point = typename SortedPoints<Dim>::Point;
  static constexpr bool HasParents = false;

  struct Node
  {
    std::uint64_t Key;
    const Point* Data;  ///< In a leaf with points: the first of them.
    std::uint32_t Next; ///< The table's.
    bool Leaf;          ///< Known without looking for a child (E3).

    bool IsLeaf() const { return this->Leaf; }
  };

  /** The points must outlive the tree. O(nodes * log(points)). */
  PaperHashedOctree(const SortedPoints<Dim>& points, const Hash& hash)
    : RootGrid(points.GetGrid())
    , Table(hash)
  {
    points.Split(*this, Key::Root());
  }

  const Node* GetRoot() const { return this->Find(Key::Root()); }
  std::size_t GetBytes() const { return this->Table.GetNodes().size() * sizeof(Node); }

  /** How many nodes are found by looking at i + 1 in the table, at index i. O(slots + nodes). */
  std::vector<std::size_t> GetProbeLengths() const { return this->Table.GetProbeLengths(); }

  /** The node of a key, or null. */
  const Node* Find(Key key) const { return this->Table.Find(key.GetValue()); }

  /** Calls function(child) for each child of an internal node with wants(octant), in the order of
   * octants, each before the next is asked for: what a search from the root down looks at
   * (TopDownSearch.h). The others are not looked up. */
  template <typename Wants, typename Function>
  void ForEachChild(const Node& node, const Wants& wants, const Function& function) const
  {
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      if (wants(octant))
      {
        function(*this->Find(Key(node.Key).GetChild(octant)));
      }
    }
  }

  /** The leaf of a position, given its key at MaxDepth (Algorithm 1). */
  template <typename Count = hashedoctree::NoCount>
  const Node* FindLeaf(Key key, int startDepth, Count&& count = {}) const
  {
    int depth = startDepth;
    const Node* node = this->Find(key.AtDepth(depth), count);
    while (node == nullptr)
    {
      node = this->Find(key.AtDepth(--depth), count);
    }
    while (!node->Leaf)
    {
      node = this->Find(key.AtDepth(++depth), count);
    }
    return node;
  }

  /** The leaves that touch a node, each once (Algorithm 2). `found` is replaced. */
  template <typename Count = hashedoctree::NoCount>
  void FindAdjacent(Key node, int startDepth, std::vector<Key>& found, Count&& count = {}) const
  {
    found.clear();
    NodesAround around;
    ForEachCellAround(node,
      [&](Key cell, Direction direction)
      {
        if (cell != node)
        {
          this->Look(cell, direction, startDepth, around, found, count);
        }
      });
    for (std::size_t i = 0; i < around.Count; ++i)
    {
      this->AddTouching(*around.Nodes[i], around.Directions[i].GetTouchingOctants(), found, count);
    }
  }

  /**
   * The leaves that meet a ball around the center of a node, each once (section 3c). `radius` is in
   * world units and not negative; `found` is replaced. It begins with the cells of the node's depth
   * around it, or, where the ball is larger than these (E14), with those of the deepest depth above
   * whose cells are wider than the radius, around the node's ancestor, so that there are 3^Dim at
   * most.
   */
  template <typename Count = hashedoctree::NoCount>
  void FindInRadius(
    Key node, double radius, int startDepth, std::vector<Key>& found, Count&& count = {}) const
  {
    found.clear();
    const hashedoctree::NodeBall<Dim> ball(this->RootGrid, node, radius);
    const int depth = node.GetDepth();
    const Key middle(node.GetValue() >> (Dim * (depth - this->GetRingDepth(depth, radius))));
    NodesAround around;
    ForEachCellAround(middle,
      [&](Key cell, Direction direction)
      {
        if (cell != node && Meets(ball, cell))
        {
          this->Look(cell, direction, startDepth, around, found, count);
        }
      });
    for (std::size_t i = 0; i < around.Count; ++i)
    {
      this->AddInBall(*around.Nodes[i], node, ball, found, count);
    }
  }

  /** How many leaves there are at each depth to the deepest, by looking at every node: from it
   * follows the start depth. O(slots + nodes). */
  hashedoctree::DepthHistogram CountLeaves() const
  {
    hashedoctree::DepthHistogram leaves(Key::MaxDepth + 1);
    for (const Node& node : this->Table.GetNodes())
    {
      if (node.Leaf)
      {
        ++leaves[static_cast<std::size_t>(Key(node.Key).GetDepth())];
      }
    }
    while (leaves.back() == 0)
    {
      leaves.pop_back();
    }
    return leaves;
  }

private:
  friend class SortedPoints<Dim>;
  using Direction = hashedoctree::NeighborDirection<Dim>;

  /** The set s of Algorithm 2: nodes around a node, at its depth, and where they lie. */
  struct NodesAround
  {
    static constexpr std::size_t MostNodes = Dim == 4 ? 81 : Dim == 3 ? 27 : Dim == 2 ? 9 : 3;
    std::array<const Node*, MostNodes> Nodes;
    std::array<Direction, MostNodes> Directions;
    std::size_t Count = 0;
  };

  void MakeLeaf(Key key, const Point* data)
  {
    this->Table.Insert({ key.GetValue(), data, 0, true });
  }
  Key MakeChildren(Key key)
  {
    this->Table.Insert({ key.GetValue(), nullptr, 0, false });
    return key;
  }
  static Key GetChild(Key parent, unsigned octant) { return parent.GetChild(octant); }

  template <typename Count>
  const Node* Find(Key key, Count& count) const
  {
    count.AddNode();
    return this->Find(key);
  }

  static bool Meets(const hashedoctree::NodeBall<Dim>& ball, Key cell)
  {
    return ball.Meets(cell.GetCell(), cell.GetDepth());
  }

  int GetRingDepth(int nodeDepth, double radius) const
  {
    const double share = radius / this->RootGrid.GetSide();
    if (std::ldexp(share, nodeDepth) < 1.5)
    {
      return nodeDepth;
    }
    int depth = nodeDepth;
    while (depth > 0 && std::ldexp(share, depth) >= 1.0)
    {
      --depth;
    }
    return depth;
  }

  /** Cases 1 and 2: the node of a cell is listed, to go on from. Case 3, with the start depth of
   * E5: the leaf above is found, unless it is there already, among few others still. */
  template <typename Count>
  void Look(Key cell, Direction direction, int startDepth, NodesAround& around,
    std::vector<Key>& found, Count& count) const
  {
    if (const Node* node = this->Find(cell, count))
    {
      around.Nodes[around.Count] = node;
      around.Directions[around.Count++] = direction;
      return;
    }
    const int start = std::min(startDepth, cell.GetDepth() - 1);
    const Key leaf(this->FindLeaf(cell.GetFirstAtMaxDepth(), start, count)->Key);
    if (std::find(found.begin(), found.end(), leaf) == found.end())
    {
      found.push_back(leaf);
    }
  }

  template <typename Count>
  void AddTouching(const Node& node, hashedoctree::OctantMask<Dim> touching,
    std::vector<Key>& found, Count& count) const
  {
    const Key key(node.Key);
    if (node.Leaf)
    {
      found.push_back(key);
      return;
    }
    for (unsigned rest = touching; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      this->AddTouching(*this->Find(key.GetChild(octant), count), touching, found, count);
    }
  }

  template <typename Count>
  void AddInBall(const Node& node, Key home, const hashedoctree::NodeBall<Dim>& ball,
    std::vector<Key>& found, Count& count) const
  {
    const Key key(node.Key);
    if (node.Leaf)
    {
      found.push_back(key);
      return;
    }
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      const Key child = key.GetChild(octant);
      if (child != home && Meets(ball, child))
      {
        this->AddInBall(*this->Find(child, count), home, ball, found, count);
      }
    }
  }

  hashedoctree::Grid<Dim> RootGrid;
  ChainedNodeTable<Node, Hash> Table;
};

#endif
