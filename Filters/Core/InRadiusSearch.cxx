// SPDX-License-Identifier: BSD-3-Clause
#include "InRadiusSearch.h"

#include "NodeBall.h"

namespace hashedoctree
{
namespace
{
/** One in-radius search. */
template <int Dim, typename Count>
class InRadiusWalk
{
public:
  InRadiusWalk(const Octree<Dim>& tree, MortonKey<Dim> node, const NodeBall<Dim>& ball,
    EmptyOctants reading, std::vector<Neighbor<Dim>>& found, Count& count)
    : Tree(tree)
    , Node(node)
    , Depth(node.GetDepth())
    , Ball(ball)
    , Reading(reading)
    , Found(found)
    , Examined(count)
  {
  }

  /** The ball must reach the border of the node, so that the cells that cover it are above. */
  void Search(int startDepth)
  {
    const NeighborCells<Dim> cover = this->Ball.GetCover();
    ReachCells(
      this->Tree, cover, startDepth, this->Reading, this->Examined,
      [this, &cover](const Cell<Dim>& cell, Key key, const Entry& entry)
      { this->Descend(entry, key, cell, cover.Depth); },
      [this](const FoundLeaf<Dim>& leaf)
      {
        const Key key = leaf.Key;
        if (this->Ball.GetSide(key.GetCell(), key.GetDepth()) != BallSide::Outside)
        {
          this->Found.push_back({ key, leaf.ParentBlock, NeighborCase::Above });
        }
      });
  }

private:
  using Key = MortonKey<Dim>;
  using Entry = typename Octree<Dim>::Entry;

  /** Through the children of an internal node that meet the ball; through all of them, without a
   * test, where the node lies inside it. */
  void Descend(const Entry& entry, Key key, const Cell<Dim>& cell, int depth, bool isInside = false)
  {
    const std::uint32_t others = this->GetOthers(key);
    for (std::uint32_t rest = others; rest != 0; rest &= rest - 1)
    {
      this->Examined.AddNode();
    }
    const BallSides sides =
      isInside ? BallSides{ others, others } : this->Ball.GetSidesOfChildren(cell, depth);
    const std::uint32_t nodes = this->Reading == EmptyOctants::Leaves ? others : entry.Occupied;
    const std::uint32_t found = others & sides.Meeting & nodes;
    this->Tree.PrefetchChildren(key, found & entry.Internal);
    for (std::uint32_t rest = found; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      const Key child = key.GetChild(octant);
      if ((entry.Internal >> octant & 1U) == 0)
      {
        this->Found.push_back({ child, entry.Block, this->GetCase(depth + 1) });
      }
      else
      {
        this->Descend(*this->Tree.GetTable().Find(child.GetValue()), child,
          GetChildCell(cell, octant), depth + 1, (sides.Inside >> octant & 1U) != 0);
      }
    }
  }

  /** The children of a node without the node that is searched from. */
  std::uint32_t GetOthers(Key key) const
  {
    constexpr std::uint32_t all = (1U << Key::NumberOfOctants) - 1U;
    return key == this->Node.GetParent() ? all ^ 1U << this->Node.GetOctant() : all;
  }

  static Cell<Dim> GetChildCell(const Cell<Dim>& cell, unsigned octant)
  {
    Cell<Dim> child;
    for (int axis = 0; axis < Dim; ++axis)
    {
      child[axis] = 2U * cell[axis] + (octant >> (Dim - 1 - axis) & 1U);
    }
    return child;
  }

  NeighborCase GetCase(int depth) const
  {
    return depth == this->Depth ? NeighborCase::Leaf
      : depth > this->Depth     ? NeighborCase::Descended
                                : NeighborCase::Above;
  }

  const Octree<Dim>& Tree;
  const Key Node;
  const int Depth;
  const NodeBall<Dim>& Ball;
  const EmptyOctants Reading;
  std::vector<Neighbor<Dim>>& Found;
  Count& Examined;
};
}

template <int Dim, typename Count>
void FindLeavesInRadius(const Octree<Dim>& tree, MortonKey<Dim> node, double radius, int startDepth,
  std::vector<Neighbor<Dim>>& found, Count& count, EmptyOctants reading)
{
  found.clear();
  if (!(radius >= 0.0) || node == MortonKey<Dim>::Root())
  {
    return;
  }
  const NodeBall<Dim> ball(tree.GetGrid(), node, radius);
  if (ball.ReachesBorder())
  {
    InRadiusWalk<Dim, Count>(tree, node, ball, reading, found, count).Search(startDepth);
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim, Count)                                                       \
  template void FindLeavesInRadius(const Octree<Dim>&, MortonKey<Dim>, double, int,                \
    std::vector<Neighbor<Dim>>&, Count&, EmptyOctants);
HASHEDOCTREE_INSTANTIATE(1, NoCount)
HASHEDOCTREE_INSTANTIATE(1, NodeCount)
HASHEDOCTREE_INSTANTIATE(2, NoCount)
HASHEDOCTREE_INSTANTIATE(2, NodeCount)
HASHEDOCTREE_INSTANTIATE(3, NoCount)
HASHEDOCTREE_INSTANTIATE(3, NodeCount)
HASHEDOCTREE_INSTANTIATE(4, NoCount)
HASHEDOCTREE_INSTANTIATE(4, NodeCount)
#undef HASHEDOCTREE_INSTANTIATE
}
