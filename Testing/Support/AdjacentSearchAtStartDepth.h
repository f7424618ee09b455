// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_AdjacentSearchAtStartDepth_h
#define Testing_Support_AdjacentSearchAtStartDepth_h

#include "DirectSearch.h"
#include "Neighbor.h"
#include "NodeBox.h"

#include <algorithm>
#include <vector>

/**
 * The first option of the adjacent search (paper section 3b), which the paper rejects, for
 * comparison only: from all cells of the start depth around the node, each reached directly, it
 * follows the hierarchy to the leaves, up or down. Finds what FindAdjacentLeaves() does, in the
 * order of the keys. Where the start depth is k below the node, there are of the order of
 * 2^(k * (Dim - 1)) cells.
 */
template <int Dim, typename Count>
class AdjacentSearchAtStartDepth
{
public:
  using Key = hashedoctree::MortonKey<Dim>;
  using Neighbor = hashedoctree::Neighbor<Dim>;

  AdjacentSearchAtStartDepth(const hashedoctree::Octree<Dim>& tree, Count& count,
    hashedoctree::EmptyOctants reading = hashedoctree::EmptyOctants::Leaves)
    : Tree(tree)
    , Examined(count)
    , Reading(reading)
  {
  }

  void Find(Key node, int startDepth, std::vector<Neighbor>& found)
  {
    found.clear();
    this->Node = node;
    this->Box = NodeBox<Dim>(node);
    this->Found = &found;
    hashedoctree::Cell<Dim> cell;
    this->SearchCells(cell, startDepth, 0, false);
    std::sort(found.begin(), found.end(),
      [](const Neighbor& a, const Neighbor& b) { return a.Key < b.Key; });
    found.erase(std::unique(found.begin(), found.end(),
                  [](const Neighbor& a, const Neighbor& b) { return a.Key == b.Key; }),
      found.end());
  }

private:
  /** The cells around the node, axis after axis. Those within it are left out. */
  void SearchCells(hashedoctree::Cell<Dim>& cell, int depth, int axis, bool isOutside)
  {
    if (axis == Dim)
    {
      this->SearchCell(Key::FromCell(cell, depth));
      return;
    }
    const int shift = Key::MaxDepth - depth;
    const std::int64_t before = (this->Box.Lower[axis] >> shift) - 1;
    const std::int64_t after = ((this->Box.Upper[axis] - 1) >> shift) + 1;
    const bool isWithin = !isOutside && axis == Dim - 1 && depth >= this->Box.Depth;
    for (std::int64_t place = before; place <= after; place += isWithin ? after - before : 1)
    {
      if (place >= 0 && place < std::int64_t(1) << depth)
      {
        cell[axis] = static_cast<std::uint32_t>(place);
        this->SearchCells(cell, depth, axis + 1, isOutside || place == before || place == after);
      }
    }
  }

  void SearchCell(Key cell)
  {
    if (!this->IsOfUse(cell))
    {
      return;
    }
    if (const auto* entry = this->Tree.GetTable().Find(cell.GetValue()))
    {
      this->Examined.AddNode();
      this->Descend(entry->Block, cell);
      return;
    }
    const auto leaf = hashedoctree::FindLeaf(
      this->Tree, cell.GetFirstAtMaxDepth(), cell.GetDepth(), this->Examined, this->Reading);
    if (leaf.Exists && leaf.Key != this->Node)
    {
      this->Add(leaf.Key, leaf.ParentBlock);
    }
  }

  void Descend(std::uint32_t number, Key key)
  {
    const auto octants = this->Tree.GetOctants(number);
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      const Key child = key.GetChild(octant);
      if (!this->IsOfUse(child))
      {
        continue;
      }
      this->Examined.AddNode();
      if ((octants.Internal >> octant & 1U) != 0)
      {
        this->Descend(this->Tree.GetChildBlock(number, octant), child);
      }
      else if (this->Reading == hashedoctree::EmptyOctants::Leaves ||
        (octants.Occupied >> octant & 1U) != 0)
      {
        this->Add(child, number);
      }
    }
  }

  /** Whether a cell touches the node and is not a part of it. */
  bool IsOfUse(Key key) const
  {
    const NodeBox<Dim> box(key);
    return box.Touches(this->Box) && !this->Box.Contains(box);
  }

  void Add(Key leaf, std::uint32_t parentBlock) { this->Found->push_back({ leaf, parentBlock }); }

  const hashedoctree::Octree<Dim>& Tree;
  Count& Examined;
  const hashedoctree::EmptyOctants Reading;
  Key Node = Key::Root();
  NodeBox<Dim> Box = NodeBox<Dim>(Key::Root());
  std::vector<Neighbor>* Found = nullptr;
};

#endif
