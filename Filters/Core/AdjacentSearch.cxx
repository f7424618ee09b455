// SPDX-License-Identifier: BSD-3-Clause
#include "AdjacentSearch.h"

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
    , Home(node.GetCell())
    , Reading(reading)
    , Found(found)
    , Examined(count)
  {
  }

  /** Not for the root. */
  void Search(int startDepth)
  {
    ReachCells(
      this->Tree, this->GetParentCells(), startDepth, this->Reading, this->Examined,
      [this](const Cell<Dim>& cell, Key key, const Entry& entry)
      { this->SearchChildren(cell, key, entry); },
      [this](const FoundLeaf<Dim>& leaf) {
        this->Found.push_back({ leaf.Key, leaf.ParentBlock, NeighborCase::Above });
      });
  }

private:
  using Key = MortonKey<Dim>;
  using Entry = typename Octree<Dim>::Entry;

  /** The parents of the cells around the node. */
  NeighborCells<Dim> GetParentCells() const
  {
    NeighborCells<Dim> parents;
    const int depth = this->Node.GetDepth();
    const std::uint32_t last = (1U << depth) - 1U;
    for (int axis = 0; axis < Dim; ++axis)
    {
      parents.Lower[axis] = (std::max(this->Home[axis], 1U) - 1U) / 2U;
      parents.Upper[axis] = std::min(this->Home[axis] + 1U, last) / 2U;
    }
    parents.Depth = depth - 1;
    return parents;
  }

  /** The cells around the node that are children of one of the parents. */
  void SearchChildren(const Cell<Dim>& parent, Key parentKey, const Entry& entry)
  {
    unsigned across = 0; // The axes along which it is not the node's own parent.
    for (int axis = 0; axis < Dim; ++axis)
    {
      across |= (parent[axis] != this->Home[axis] / 2U ? 1U : 0U) << (Dim - 1 - axis);
    }
    const unsigned own = this->Node.GetOctant();
    const NeighborDirection<Dim> toParent{ across, own & across };
    const OctantMask<Dim> touching = toParent.GetTouchingOctants();
    this->Tree.PrefetchChildren(parentKey, entry.Internal & touching);
    for (unsigned rest = touching; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      const unsigned axes = across | (octant ^ own);
      if (axes == 0)
      {
        continue; // The node itself.
      }
      this->Examined.AddNode();
      if ((entry.Internal >> octant & 1U) != 0)
      {
        // Across the border of the node's own parent a step up leads to a lower octant.
        const NeighborDirection<Dim> direction{ axes, (octant ^ across) & axes };
        this->Descend(parentKey.GetChild(octant), direction.GetTouchingOctants());
      }
      else if (this->IsLeaf(entry.Occupied, octant))
      {
        this->Found.push_back({ parentKey.GetChild(octant), entry.Block, NeighborCase::Leaf });
      }
    }
  }

  /** The leaves below a neighbour that touch the node: in any depth in the same octants. */
  void Descend(Key key, OctantMask<Dim> touching)
  {
    const Entry& entry = *this->Tree.GetTable().Find(key.GetValue());
    this->Tree.PrefetchChildren(key, entry.Internal & touching);
    for (unsigned rest = touching; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      this->Examined.AddNode();
      if ((entry.Internal >> octant & 1U) != 0)
      {
        this->Descend(key.GetChild(octant), touching);
      }
      else if (this->IsLeaf(entry.Occupied, octant))
      {
        this->Found.push_back({ key.GetChild(octant), entry.Block, NeighborCase::Descended });
      }
    }
  }

  /** Of a child that is not internal. */
  bool IsLeaf(OctantMask<Dim> occupied, unsigned octant) const
  {
    return this->Reading == EmptyOctants::Leaves || (occupied >> octant & 1U) != 0;
  }

  const Octree<Dim>& Tree;
  const Key Node;
  const Cell<Dim> Home;
  const EmptyOctants Reading;
  std::vector<Neighbor<Dim>>& Found;
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

#define HASHEDOCTREE_INSTANTIATE(Dim, Count)                                                       \
  template void FindAdjacentLeaves(                                                                \
    const Octree<Dim>&, MortonKey<Dim>, int, std::vector<Neighbor<Dim>>&, Count&, EmptyOctants);
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
