// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointWalk_h
#define hashedoctree_PointWalk_h

#include "BallInGrid.h"
#include "BlockSearch.h"
#include "DirectSearch.h"
#include "PointDescent.h"

#include <algorithm>
#include <limits>

namespace hashedoctree
{
/**
 * One search around a position. It hands the points of the leaves that may matter to a collector
 * (PointCollectors.h), always including every point within the collector's bound. Private to
 * PointSearch.cxx.
 *
 * It finds the leaf of the position from the start depth and scans it; as long as the collector's
 * ball reaches further, it searches the block around the leaf, and then the cells that cover the
 * ball, which it reaches directly. A search that starts at the root is the classical one: down from
 * the root, nearer children first, without the table.
 */
template <int Dim, typename Real, typename Collector, typename Count>
class PointWalk
{
public:
  PointWalk(
    const PointTree<Dim, Real>& tree, const Position<Dim>& x, Collector& collector, Count& count)
    : Starts(tree.GetStartDepths())
    , Free(tree.GetFreeSpace())
    , Nodes(tree.GetOctree())
    , Found(collector)
    , Examined(count)
    , Ball(this->Nodes.GetGrid(), x, tree.GetFlatAxes())
    , Below(tree, x, this->Ball.GetPlace(), collector, count)
  {
  }

  /** `wanted` points at least are asked for; a hint where to begin. */
  void Search(std::size_t wanted)
  {
    if (!this->Nodes.IsRootInternal())
    {
      this->Examined.AddNode();
      this->Below.ScanLeaf(0, static_cast<PointIndex>(this->Nodes.GetNumberOfPoints()));
      return;
    }
    if (Collector::HasFixedBall || this->Found.GetBound2() < Infinity)
    {
      const double reach = this->Ball.GetReach(this->Found.GetBound2());
      if (this->Free.Holds(this->Ball, reach))
      {
        return;
      }
      if (Collector::HasFixedBall)
      {
        this->Ball.SetReach(reach);
      }
    }
    const Key key = InterleaveCell<Dim>(this->Ball.GetHome(), Key::MaxDepth);
    // The leaf of a position far from all points is of no use when these are to be found.
    const bool isFar = !Collector::HasFixedBall && this->Free.HoldsHomeOf(this->Ball);
    const int startDepth = isFar ? 0 : this->Starts.Get(key);
    if (startDepth == 0)
    {
      this->Below.SearchBlock(0, this->Ball.GetHome(), 0);
    }
    else if constexpr (Collector::HasFixedBall)
    {
      this->SearchFixedBall(key, startDepth);
    }
    else
    {
      this->SearchOutwards(key, startDepth, wanted);
    }
  }

private:
  using Key = MortonKey<Dim>;
  using Block = typename Octree<Dim>::Block;
  using Entry = typename Octree<Dim>::Entry;
  static constexpr unsigned NumberOfOctants = Octree<Dim>::NumberOfOctants;
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  void SearchFixedBall(Key key, int startDepth)
  {
    const FoundLeaf<Dim> leaf =
      FindLeaf(this->Nodes, key, std::min(startDepth, this->Ball.GetCoverDepth()), this->Examined);
    const int depth = leaf.Key.GetDepth();
    if (this->Ball.GetDepth() >= depth)
    {
      this->Below.ScanChild(this->Nodes.GetBlock(leaf.ParentBlock), leaf.Key.GetOctant());
      return;
    }
    this->SearchBall(key, depth - 1);
  }

  void SearchOutwards(Key key, int startDepth, std::size_t wanted)
  {
    const FoundLeaf<Dim> leaf = FindLeaf(this->Nodes, key, startDepth, this->Examined);
    std::uint32_t block = leaf.ParentBlock;
    const Block& parent = this->Nodes.GetBlock(block);
    const unsigned octant = leaf.Key.GetOctant();
    int depth = leaf.Key.GetDepth();
    // Often searched next; loaded while the search waits for the block and the leaf.
    this->Below.PrefetchBoxes(block);
    if (parent.FirstPoint[octant + 1] - parent.FirstPoint[octant] >= wanted)
    {
      this->Below.ScanChild(parent, octant);
      if (this->Ball.FitsInCell(depth, this->Found.GetBound2()))
      {
        return;
      }
      this->Below.LeaveOutLeaf(parent.FirstPoint[octant]);
    }

    // The block around the leaf, or the smallest above it with enough points.
    --depth;
    while (depth > 0 && CountPoints(this->Nodes.GetBlock(block)) < wanted)
    {
      --depth;
      block = depth > 0 ? this->Find(key.AtDepth(depth))->Block : 0;
    }
    this->Below.SearchBlock(block, this->Ball.GetHome(), depth);
    if (depth > 0)
    {
      this->Ball.SetRadius2(this->Found.GetBound2());
      if (this->Ball.GetDepth() < depth)
      {
        this->Below.LeaveOutBlock(block);
        this->HasSearched = true;
        this->SearchedDepth = depth;
        this->SearchBall(key, depth);
      }
    }
  }

  static std::size_t CountPoints(const Block& block)
  {
    return block.FirstPoint[NumberOfOctants] - block.FirstPoint[0];
  }

  const Entry* Find(Key key)
  {
    this->Examined.AddNode();
    return this->Nodes.GetTable().Find(key.GetValue());
  }

  /** Searches where the ball is: the few cells that cover it, not below `deepest`, or the one
   * around it where that is hardly larger. */
  void SearchBall(Key key, int deepest)
  {
    const int coverDepth = std::min(deepest, this->Ball.GetCoverDepth());
    if (this->Ball.GetDepth() + 1 < coverDepth)
    {
      Cell<Dim> cell;
      this->SearchCells(cell, coverDepth, 0);
      return;
    }
    const FoundBlock around = FindBlock(this->Nodes, key, this->Ball.GetDepth(), this->Examined);
    this->Below.SearchBlock(around.Block, this->Ball.GetHome(), around.Depth);
  }

  /** Searches the cells of a depth between the ball's corners, axis after axis. */
  void SearchCells(Cell<Dim>& cell, int depth, int axis)
  {
    if (axis == Dim)
    {
      this->SearchCell(cell, depth);
      return;
    }
    const int shift = Key::MaxDepth - depth;
    const std::uint32_t last = this->Ball.GetUpper()[axis] >> shift;
    for (std::uint32_t c = this->Ball.GetLower()[axis] >> shift; c <= last; ++c)
    {
      cell[axis] = c;
      this->SearchCells(cell, depth, axis + 1);
    }
  }

  /** The node of a cell, or the leaf above it; a leaf only for the first of its cells. */
  void SearchCell(const Cell<Dim>& cell, int depth)
  {
    if (this->IsSearched(cell, depth))
    {
      return;
    }
    const int shift = Key::MaxDepth - depth;
    const Key key = InterleaveCell<Dim>(cell, depth);
    if (const Entry* entry = this->Find(key))
    {
      Cell<Dim> inside = cell;
      for (std::uint32_t& coordinate : inside)
      {
        coordinate <<= shift;
      }
      this->Below.SearchBlock(entry->Block, inside, depth);
      return;
    }
    Key leaf = key;
    const Entry* parent = nullptr;
    while ((parent = this->Find(leaf.GetParent())) == nullptr)
    {
      leaf = leaf.GetParent();
    }
    const int depths = depth - leaf.GetDepth();
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::uint32_t lower = this->Ball.GetLower()[axis] >> shift;
      if (cell[axis] != std::max(lower, cell[axis] >> depths << depths))
      {
        return;
      }
    }
    this->Below.ScanChild(this->Nodes.GetBlock(parent->Block), leaf.GetOctant());
  }

  /** Whether a cell lies in the block that has been searched. */
  bool IsSearched(const Cell<Dim>& cell, int depth) const
  {
    if (!this->HasSearched || depth < this->SearchedDepth)
    {
      return false;
    }
    bool isIn = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      isIn &= cell[axis] >> (depth - this->SearchedDepth) ==
        this->Ball.GetHome()[axis] >> (Key::MaxDepth - this->SearchedDepth);
    }
    return isIn;
  }

  const StartDepths<Dim>& Starts;
  const FreeSpace<Dim>& Free;
  const Octree<Dim>& Nodes;
  Collector& Found;
  Count& Examined;
  BallInGrid<Dim> Ball;
  PointDescent<Dim, Real, Collector, Count> Below;
  bool HasSearched = false; ///< The ancestor of the home cell at SearchedDepth.
  int SearchedDepth = 0;
};

template <int Dim, typename Real, typename Collector, typename Count>
void SearchPoints(const PointTree<Dim, Real>& tree, const Position<Dim>& x, Collector& collector,
  Count& count, std::size_t wanted)
{
  PointWalk<Dim, Real, Collector, Count>(tree, x, collector, count).Search(wanted);
}
}

#endif
