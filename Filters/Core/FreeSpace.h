// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_FreeSpace_h
#define hashedoctree_FreeSpace_h

#include "BallInGrid.h"
#include "Buffer.h"
#include "ChildBoxes.h"
#include "Octree.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hashedoctree
{
/**
 * Where a tree has no points: for each cell of a coarse grid, how many cells away the nearest one
 * that may hold points lies. A ball far from all points is known to hold none by one look, however
 * deep the tree is there.
 *
 * Immutable; thread safe.
 */
template <int Dim>
class FreeSpace
{
public:
  /** Depth of the coarse cells: at most 2^15 of them, one byte each, and no more than points. A row
   * of them is one word of 2^6 bits. */
  static constexpr int MaxCoarseDepth = std::min(15 / Dim, 6);

  /** Nowhere. */
  FreeSpace() = default;
  /** Of a tree whose root is internal, with the boxes of its blocks' children. O(coarse cells). */
  FreeSpace(const Octree<Dim>& tree, const Buffer<ChildBoxes<Dim>>& boxes);

  /** Whether no point of the tree can be in a ball that has this reach (BallInGrid::GetReach()). It
   * may have none even if not. */
  bool Holds(const BallInGrid<Dim>& ball, double reach) const
  {
    const auto side = static_cast<double>(std::uint64_t(1) << (Key::MaxDepth - this->Depth));
    // From outside: the nearest place in the root is no further from any point.
    const double room = std::max(ball.GetRoom(this->Depth), 0.0);
    const double toPoints = room + side * (static_cast<double>(this->GetCellsToPoints(ball)) - 1.0);
    return reach < std::max(toPoints, ball.GetLeastDistance());
  }
  /** The same of the coarse cell that its center lies in, or is nearest to. */
  bool HoldsHomeOf(const BallInGrid<Dim>& ball) const { return this->GetCellsToPoints(ball) != 0; }

  std::size_t GetBytes() const { return this->CellsToPoints.size(); }

private:
  using Key = MortonKey<Dim>;
  /** Whether each cell is in some set. A row of cells along the last axis is a word, whose bit 0 is
   * its first cell; rows are in order of the other axes, the first one changing slowest. */
  using CellSet = std::vector<std::uint64_t>;

  std::uint32_t GetCellsToPoints(const BallInGrid<Dim>& ball) const
  {
    std::size_t cell = 0;
    for (const std::uint32_t home : ball.GetHome())
    {
      cell = cell << this->Depth | home >> (Key::MaxDepth - this->Depth);
    }
    return this->CellsToPoints[cell];
  }
  CellSet GetOccupied(const Octree<Dim>& tree, const Buffer<ChildBoxes<Dim>>& boxes) const;
  std::size_t GetRow(const Cell<Dim>& cell) const;
  void AddChildren(const Cell<Dim>& node, unsigned octants, CellSet& cells) const;
  void AddCells(const Cell<Dim>& lower, const Cell<Dim>& upper, CellSet& cells) const;
  void Grow(CellSet& cells) const;

  int Depth = 0;
  std::vector<std::uint8_t> CellsToPoints = { 0 }; ///< In the order of the axes, too.
};
}

#endif
