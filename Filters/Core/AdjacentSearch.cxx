// SPDX-License-Identifier: BSD-3-Clause
#include "AdjacentSearch.h"

#include "ForEachDimension.h"
#include "NeighborBuffer.h"
#include "NeighborCells.h"
#include "NeighborDirection.h"

namespace hashedoctree
{
namespace
{
/** One adjacent search. */
template <int Dim, typename Count>
class AdjacentWalk
{
public:
  AdjacentWalk(const Octree<Dim>& tree, MortonKey<Dim> node, EmptyOctants reading,
    std::vector<Neighbor<Dim>>& found, Count& count)
    : Tree(tree)
    , Node(node)
    , Reading(reading)
    , Leaves(found)
    , Examined(count)
  {
  }

  /** Not for the root. */
  void Search(int startDepth)
  {
    const NeighborCells<Dim> parents = this->GetParentCells();
    const unsigned apart = parents.GetAxesApart();
    // Of two along an axis the node's own is the upper one where the node is the lower child.
    const unsigned own = ~this->Node.GetOctant();
    ReachCells(
      this->Tree, parents, startDepth, this->Examined, this->Reading,
      [this, apart, own](unsigned corner, Key key, const Entry& entry)
      { this->SearchChildren((corner ^ own) & apart, key, entry); },
      [this](const FoundLeaf<Dim>& leaf) {
        this->Leaves.Add({ leaf.Key, leaf.ParentBlock });
      });
    this->Leaves.Flush();
  }

private:
  using Key = MortonKey<Dim>;
  using Entry = typename Octree<Dim>::Entry;

  /** The parents of the cells around the node. */
  NeighborCells<Dim> GetParentCells() const
  {
    NeighborCells<Dim> parents;
    const Cell<Dim> home = this->Node.GetCell();
    const int depth = this->Node.GetDepth();
    const std::uint32_t last = (1U << depth) - 1U;
    for (int axis = 0; axis < Dim; ++axis)
    {
      parents.Lower[axis] = (std::max(home[axis], 1U) - 1U) / 2U;
      parents.Upper[axis] = std::min(home[axis] + 1U, last) / 2U;
    }
    parents.Depth = depth - 1;
    return parents;
  }

  /** The cells around the node that are children of one of the parents, which lies across the
   * border of the node's own parent along these axes. */
  void SearchChildren(unsigned across, Key parentKey, const Entry& entry)
  {
    const unsigned own = this->Node.GetOctant();
    const NeighborDirection<Dim> toParent{ across, own & across };
    const OctantMask<Dim> touching = toParent.GetTouchingOctants();
    this->Tree.PrefetchChildren(parentKey, entry.Internal & touching);
    const unsigned others =
      across == 0 ? touching & ~(1U << own) : touching; // Not the node itself.
    this->SearchOctants(parentKey, entry, others,
      [this, parentKey, across, own](unsigned octant)
      {
        // Across the border of the node's own parent a step up leads to a lower octant.
        const unsigned axes = across | (octant ^ own);
        const NeighborDirection<Dim> direction{ axes, (octant ^ across) & axes };
        this->Descend(parentKey.GetChild(octant), direction.GetTouchingOctants());
      });
  }

  /** The leaves below a neighbour that touch the node: in any depth in the same octants. */
  void Descend(Key key, OctantMask<Dim> touching)
  {
    const Entry& entry = *this->Tree.GetTable().Find(key.GetValue());
    this->Tree.PrefetchChildren(key, entry.Internal & touching);
    this->SearchOctants(key, entry, touching,
      [this, key, touching](unsigned octant) { this->Descend(key.GetChild(octant), touching); });
  }

  /** Lists those children of a node that are leaves, and calls onInternal(octant) for those that
   * are internal, in the order of octants. */
  template <typename OnInternal>
  void SearchOctants(Key key, const Entry& entry, unsigned octants, const OnInternal& onInternal)
  {
    this->Examined.Enter(key);
    this->Examined.AddNodes(__builtin_popcount(octants));
    unsigned rest = this->Reading == EmptyOctants::Leaves ? octants : octants & entry.Occupied;
    for (unsigned internal = rest & entry.Internal; internal != 0; internal &= internal - 1)
    {
      const unsigned first = internal & -internal;
      this->Leaves.AddChildren(PlainMachine(), key, rest & (first - 1U), entry.Block);
      onInternal(static_cast<unsigned>(__builtin_ctz(first)));
      rest &= ~(2U * first - 1U);
    }
    this->Leaves.AddChildren(PlainMachine(), key, rest, entry.Block);
  }

  const Octree<Dim>& Tree;
  const Key Node;
  const EmptyOctants Reading;
  NeighborBuffer<Dim> Leaves;
  Count& Examined;
};
}

template <int Dim, typename Count>
void FindAdjacentLeaves(const Octree<Dim>& tree, MortonKey<Dim> node, int startDepth,
  std::vector<Neighbor<Dim>>& found, Count& count, EmptyOctants reading)
{
  found.clear();
  if (node != MortonKey<Dim>::Root())
  {
    AdjacentWalk<Dim, Count>(tree, node, reading, found, count).Search(startDepth);
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void FindAdjacentLeaves(                                                                \
    const Octree<Dim>&, MortonKey<Dim>, int, std::vector<Neighbor<Dim>>&, NoCount&, EmptyOctants); \
  template void FindAdjacentLeaves(const Octree<Dim>&, MortonKey<Dim>, int,                        \
    std::vector<Neighbor<Dim>>&, RangeCount<Dim>&, EmptyOctants);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
