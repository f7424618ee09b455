// SPDX-License-Identifier: BSD-3-Clause
#include "InRadiusSearch.h"

#include "ForEachDimension.h"
#include "NeighborBuffer.h"
#include "NodeBall.h"

#include <type_traits>

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
    , Parent(node.GetParent())
    , OctantBit(1U << node.GetOctant())
    , Ball(ball)
    , Reading(reading)
    , Leaves(found)
    , Examined(count)
  {
  }

  // The ball must reach the border of the node, so that the cells that cover it are above.
  void Search(PlainMachine machine, int startDepth) { this->ListInCover(machine, startDepth); }
  HASHEDOCTREE_WITH_AVX2 void Search(Avx2Machine machine, int startDepth)
  {
    this->ListInCover(machine, startDepth);
  }

private:
  using Key = MortonKey<Dim>;
  using Corner = typename NodeBall<Dim>::Corner;
  using Entry = typename Octree<Dim>::Entry;
  using Octants = typename Octree<Dim>::Octants;

  /** An internal node that meets the ball. */
  struct Node
  {
    Key NodeKey;
    std::uint32_t Block;
    Corner Lower;
  };
  /** So many are looked at together: their children have one bit each in a word. */
  static constexpr std::size_t GroupSize = 64 / Key::NumberOfOctants;
  /** Of one depth. They are made in their places: to copy what has just been written part by part
   * is to wait for it. */
  using Group = std::array<Node, GroupSize>;

  /** Lists the leaves that meet the ball. For each machine the same is compiled, all that lies
   * within included. */
  template <typename Machine>
  HASHEDOCTREE_INLINE void ListInCover(Machine machine, int startDepth)
  {
    const NeighborCells<Dim> cover = this->Ball.GetCover();
    Corner lower;
    this->Ball.GetLower(cover.Lower, cover.Depth, lower);
    const double side = NodeBall<Dim>::GetSide(cover.Depth);
    Group cells;
    std::size_t count = 0;
    std::uint64_t internal = 0;
    ReachCells(
      this->Tree, cover, startDepth, this->Examined, this->Reading,
      [&](unsigned corner, Key key, const Entry& entry) __attribute__((always_inline)) {
        if (count == GroupSize)
        {
          this->Descend(machine, cells, internal, cover.Depth + 1);
          count = 0;
          internal = 0;
        }
        Node& cell = cells[count];
        cell.NodeKey = key;
        cell.Block = entry.Block;
        NodeBall<Dim>::GetLowerOfOctant(lower, side, corner, cell.Lower);
        this->Tree.PrefetchOctants(cell.Block);
        internal |= std::uint64_t(this->ListLeaves(machine, cell, entry, 0.5 * side))
          << (count * Key::NumberOfOctants);
        ++count;
      },
      [this](const FoundLeaf<Dim>& leaf)
      {
        const Key key = leaf.Key;
        if (this->Ball.Meets(key.GetCell(), key.GetDepth()))
        {
          this->Leaves.Add({ key, leaf.ParentBlock });
        }
      });
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Tree.PrefetchOctants(this->Tree.GetOctants(cells[i].Block).FirstChild);
    }
    this->Descend(machine, cells, internal, cover.Depth + 1);
    this->Leaves.Flush();
  }

  void Descend(PlainMachine machine, const Group& parents, std::uint64_t internal, int depth)
  {
    this->ListBelow(machine, parents, internal, depth);
  }
  HASHEDOCTREE_WITH_AVX2 void Descend(
    Avx2Machine machine, const Group& parents, std::uint64_t internal, int depth)
  {
    this->ListBelow(machine, parents, internal, depth);
  }

  /** Lists the leaves that meet the ball below children of a group. These children, which have a
   * bit each in `internal`, are of this depth; they meet the ball and are no leaves. */
  template <typename Machine>
  HASHEDOCTREE_INLINE void ListBelow(
    Machine machine, const Group& parents, std::uint64_t internal, int depth)
  {
    const double side = NodeBall<Dim>::GetSide(depth);
    while (internal != 0)
    {
      Group nodes;
      Node* node = nodes.data();
      std::uint64_t below = 0;
      for (unsigned shift = 0; internal != 0 && shift < 64; shift += Key::NumberOfOctants)
      {
        const auto bit = static_cast<unsigned>(__builtin_ctzll(internal));
        internal &= internal - 1;
        const Node& parent = parents[bit / Key::NumberOfOctants];
        const unsigned octant = bit % Key::NumberOfOctants;
        node->NodeKey = parent.NodeKey.GetChild(octant);
        node->Block = this->Tree.GetChildBlock(parent.Block, octant);
        NodeBall<Dim>::GetLowerOfOctant(parent.Lower, side, octant, node->Lower);
        const Octants& children = this->Tree.GetOctants(node->Block);
        this->Tree.PrefetchOctants(children.FirstChild);
        below |= std::uint64_t(this->ListLeaves(machine, *node, children, 0.5 * side)) << shift;
        ++node;
      }
      if (below != 0)
      {
        this->Descend(machine, nodes, below, depth + 1);
      }
    }
  }

  /** Lists those children of a node that are leaves and meet the ball, and returns those that are
   * internal nodes and meet it. `side` is theirs. */
  template <typename Machine, typename Children>
  HASHEDOCTREE_INLINE std::uint32_t ListLeaves(
    Machine machine, const Node& node, const Children& children, double side)
  {
    const std::uint32_t others = this->GetOthers(node.NodeKey);
    this->Examined.Enter(node.NodeKey);
    this->Examined.AddNodes(__builtin_popcount(others));
    const std::uint32_t nodes = this->Reading == EmptyOctants::Leaves ? others : children.Occupied;
    const std::uint32_t meeting =
      others & nodes & this->Ball.GetMeetingOctants(machine, node.Lower, side);
    this->Leaves.AddChildren(machine, node.NodeKey, meeting & ~children.Internal, node.Block);
    return meeting & children.Internal;
  }

  /** The children of a node without the node that is searched from. (By a product, since nobody
   * could foresee a branch.) */
  std::uint32_t GetOthers(Key key) const
  {
    constexpr std::uint32_t all = (1U << Key::NumberOfOctants) - 1U;
    return all ^ this->OctantBit * static_cast<std::uint32_t>(key == this->Parent);
  }

  const Octree<Dim>& Tree;
  const Key Parent;              ///< Of the node that is searched from,
  const std::uint32_t OctantBit; ///< and the bit of its octant there.
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
  if (!ball.ReachesBorder())
  {
    return;
  }
  InRadiusWalk<Dim, Count> walk(tree, node, ball, reading, found, count);
#if defined(__x86_64__)
  // Counts are looked at, not waited for; and of more copies GCC inlines less in each.
  if constexpr (std::is_same<Count, NoCount>::value)
  {
    if (HasAvx2())
    {
      walk.Search(Avx2Machine(), startDepth);
      return;
    }
  }
#endif
  walk.Search(PlainMachine(), startDepth);
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void FindLeavesInRadius(const Octree<Dim>&, MortonKey<Dim>, double, int,                \
    std::vector<Neighbor<Dim>>&, NoCount&, EmptyOctants);                                          \
  template void FindLeavesInRadius(const Octree<Dim>&, MortonKey<Dim>, double, int,                \
    std::vector<Neighbor<Dim>>&, RangeCount<Dim>&, EmptyOctants);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
