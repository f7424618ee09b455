// SPDX-License-Identifier: BSD-3-Clause
#include "InRadiusSearch.h"

#include "NeighborBuffer.h"
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
    , Leaves(found)
    , Examined(count)
  {
  }

  /** The ball must reach the border of the node, so that the cells that cover it are above. */
  void Search(int startDepth)
  {
    const NeighborCells<Dim> cover = this->Ball.GetCover();
    std::array<Parent, Key::NumberOfOctants> parents;
    std::size_t count = 0;
    ReachCells(
      this->Tree, cover, startDepth, this->Reading, this->Examined,
      [this, &cover, &parents, &count](const Cell<Dim>& cell, Key key, const Entry& entry) {
        parents[count++] = { key, this->Ball.GetLower(cell, cover.Depth), &entry };
      },
      [this](const FoundLeaf<Dim>& leaf)
      {
        const Key key = leaf.Key;
        if (this->Ball.Meets(key.GetCell(), key.GetDepth()))
        {
          this->Leaves.Add({ key, leaf.ParentBlock, NeighborCase::Above });
        }
      });
    this->Descend(parents.data(), count, cover.Depth);
    this->Leaves.Flush();
  }

private:
  using Key = MortonKey<Dim>;
  using Entry = typename Octree<Dim>::Entry;

  /** An internal node on the way down. */
  struct Parent
  {
    Key NodeKey;
    Position<Dim> Lower; ///< From the center of the ball, see NodeBall.
    const Entry* Children;
  };
  /** So many are looked at together: their children have one bit each in a word. */
  static constexpr std::size_t GroupSize = 64 / Key::NumberOfOctants;

  /** Lists the leaves below the parents, of this depth, that meet the ball. */
  void Descend(const Parent* parents, std::size_t count, int depth)
  {
    for (const Parent* const last = parents + count; parents < last; parents += GroupSize)
    {
      const auto size = std::min<std::size_t>(GroupSize, last - parents);
      std::uint64_t internal = this->ListLeaves(parents, size, depth + 1);
      while (internal != 0)
      {
        std::array<Parent, GroupSize> children;
        const std::size_t taken = this->TakeChildren(parents, depth + 1, internal, children);
        this->Descend(children.data(), taken, depth + 1);
      }
    }
  }

  /** Makes parents of the first group of internal nodes, of this depth, whose bits are taken out;
   * returns how many. The table is asked for all before the first is needed. */
  std::size_t TakeChildren(const Parent* parents, int depth, std::uint64_t& internal,
    std::array<Parent, GroupSize>& children) const
  {
    const double size = NodeBall<Dim>::GetSize(depth);
    std::size_t count = 0;
    for (; internal != 0 && count < GroupSize; internal &= internal - 1)
    {
      const auto bit = static_cast<unsigned>(__builtin_ctzll(internal));
      const Parent& parent = parents[bit / Key::NumberOfOctants];
      Parent& child = children[count++];
      child.NodeKey = parent.NodeKey.GetChild(bit % Key::NumberOfOctants);
      this->Tree.GetTable().Prefetch(child.NodeKey.GetValue());
      for (int axis = 0; axis < Dim; ++axis)
      {
        // (A product, since a choice is made by a branch, which nobody could foresee.)
        child.Lower[axis] = parent.Lower[axis] + size * (bit >> (Dim - 1 - axis) & 1U);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      children[i].Children = this->Tree.GetTable().Find(children[i].NodeKey.GetValue());
    }
    return count;
  }

  /** Lists those children, of this depth, that are leaves and meet the ball, and returns those that
   * are internal nodes and meet it. */
  std::uint64_t ListLeaves(const Parent* parents, std::size_t count, int depth)
  {
    const double size = NodeBall<Dim>::GetSize(depth);
    const NeighborCase kind = this->GetCase(depth);
    std::uint64_t internal = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::uint32_t others = this->GetOthers(parents[i].NodeKey);
      this->Examined.AddNodes(__builtin_popcount(others));
      const Entry& entry = *parents[i].Children;
      const std::uint32_t nodes = this->Reading == EmptyOctants::Leaves ? others : entry.Occupied;
      const std::uint32_t meeting =
        others & nodes & this->Ball.GetMeetingOctants(parents[i].Lower, size);
      internal |= std::uint64_t(meeting & entry.Internal) << (i * Key::NumberOfOctants);
      this->Leaves.AddChildren(parents[i].NodeKey, meeting & ~entry.Internal, entry.Block, kind);
    }
    return internal;
  }

  /** The children of a node without the node that is searched from. */
  std::uint32_t GetOthers(Key key) const
  {
    constexpr std::uint32_t all = (1U << Key::NumberOfOctants) - 1U;
    return key == this->Node.GetParent() ? all ^ 1U << this->Node.GetOctant() : all;
  }

  NeighborCase GetCase(int depth) const
  {
    constexpr NeighborCase cases[] = { NeighborCase::Above, NeighborCase::Leaf,
      NeighborCase::Descended };
    return cases[1 + (depth > this->Depth ? 1 : 0) - (depth < this->Depth ? 1 : 0)];
  }

  const Octree<Dim>& Tree;
  const Key Node;
  const int Depth;
  const NodeBall<Dim>& Ball;
  const EmptyOctants Reading;
  NeighborBuffer<Dim> Leaves;
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
