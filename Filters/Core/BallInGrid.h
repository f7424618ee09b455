// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_BallInGrid_h
#define hashedoctree_BallInGrid_h

#include "FlatAxes.h"
#include "Grid.h"

#include <algorithm>
#include <cmath>

namespace hashedoctree
{
/**
 * A ball in the grid of a tree: which cells it reaches. Lengths are in cells of MaxDepth where
 * nothing else is said. The ball may lie anywhere; outside the root the cells nearest to it count.
 * All points of the tree whose computed distance is within the radius lie in the cells between the
 * corners: the room left for rounding is more than all of it can add up to.
 */
template <int Dim>
class BallInGrid
{
public:
  using Key = MortonKey<Dim>;

  /** More than a sum of squares may lose because the squares are too small for a double. Itself not
   * that small, nor in cells of most boxes: numbers that are, some machines multiply in the time
   * that it takes to find the points of a leaf, and others take them for zero when asked to. */
  static constexpr double Underflow = 1e-300;

  /** Whether squared lengths are neither too small nor too large when they are multiplied by a
   * squared ratio of units. */
  static bool IsExact(double ratio2) { return ratio2 < MostExact && 1.0 / MostExact < ratio2; }

  /** Of points that are flat along some axes, the center is folded there. */
  BallInGrid(
    const Grid<Dim>& grid, const Position<Dim>& center, const FlatAxes<Dim>& flat = FlatAxes<Dim>())
    : CellsPerLength(grid.GetCellsPerLength())
    , Flat(flat.GetMask())
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->SetPlace(axis, (center[axis] - grid.GetLower()[axis]) * this->CellsPerLength);
    }
    if (this->Flat != 0)
    {
      this->Fold(flat);
    }
  }

  /** The center, from the lower corner of the root. */
  const GridPlace<Dim>& GetPlace() const { return this->Place; }
  /** The cell that holds the center, or is nearest to it. */
  const Cell<Dim>& GetHome() const { return this->Home; }

  /** Gives the ball its radius, squared and in world units; may be infinite. */
  void SetRadius2(double radius2) { this->SetReach(this->GetReach(radius2)); }

  /** What SetRadius2() does, in two steps: the radius with room for rounding, */
  double GetReach(double radius2) const
  {
    const double radius = std::sqrt(radius2 + Underflow) * this->CellsPerLength;
    return radius + Rounding + RelativeRounding * (radius + this->Farthest);
  }
  /** and the cells between which the ball lies. */
  void SetReach(double reach)
  {
    std::uint32_t difference = 0;
    std::uint32_t width = 0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Lower[axis] = GetLowerCell(this->Place[axis] - reach);
      this->Upper[axis] = GetUpperCell(this->Place[axis] + reach);
      difference |= this->Lower[axis] ^ this->Upper[axis];
      width |= this->Upper[axis] - this->Lower[axis];
    }
    this->Depth = Key::MaxDepth - CountBits(difference);
    this->CoverDepth = Key::MaxDepth - CountBits(width);
  }

  /** How far the center is from the nearest face of the cell of a depth around it, or nearest to
   * it, leaving out faces across axes along which the points are flat: there is nothing behind
   * them. Negative outside. */
  double GetRoom(int depth) const
  {
    const int shift = Key::MaxDepth - depth;
    const auto side = static_cast<double>(std::uint64_t(1) << shift);
    double room = side;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const auto lower = static_cast<double>(this->Home[axis] >> shift << shift);
      const double toLower = this->Place[axis] - lower;
      if ((this->Flat >> axis & 1U) == 0)
      {
        room = std::min(room, std::min(toLower, side - toLower));
      }
    }
    return room;
  }

  /** Whether a ball with this radius surely lies in the cell of a depth around the center, but for
   * what is beyond it along flat axes. Faster than to give the ball the radius, and no more often
   * wrong than rounding asks for, but for balls that reach out of the root. */
  bool FitsInCell(int depth, double radius2) const
  {
    const auto side = static_cast<double>(std::uint64_t(1) << (Key::MaxDepth - depth));
    const double margin =
      this->GetRoom(depth) - (2.0 * Rounding + RelativeRounding * (side + this->Farthest));
    const double scale = this->CellsPerLength * this->CellsPerLength;
    return margin > 0.0 && IsExact(scale) &&
      (radius2 + Underflow) * scale < margin * margin * (1.0 - RelativeRounding);
  }

  /** No point is nearer to the center than this, as far as flat axes tell; 0 without any. */
  double GetLeastDistance() const
  {
    double least = 0.0;
    for (int axis = 0; this->Flat != 0 && axis < Dim; ++axis)
    {
      least = (this->Flat >> axis & 1U) != 0 ? std::max(least, -this->Place[axis]) : least;
    }
    return least;
  }

  /** Depth of the smallest cell that holds the ball. */
  int GetDepth() const { return this->Depth; }
  /** The deepest depth whose cells are as wide as the ball, so that 2^Dim of them cover it. */
  int GetCoverDepth() const { return this->CoverDepth; }
  /** The cells of MaxDepth at the ball's corners. */
  const Cell<Dim>& GetLower() const { return this->Lower; }
  const Cell<Dim>& GetUpper() const { return this->Upper; }

private:
  void SetPlace(int axis, double place)
  {
    this->Place[axis] = place;
    this->Home[axis] = GetLowerCell(place);
    this->Farthest = std::max(this->Farthest, std::abs(place));
  }

  /** (Not inline, so that other searches are as fast as without it.) */
  [[gnu::noinline]] void Fold(const FlatAxes<Dim>& flat)
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->SetPlace(axis, flat.Fold(this->Place[axis], axis));
    }
  }

  // More than rounding does to a place in the root, and to one further away beside its distance.
  static constexpr double Rounding = 1e-9;
  static constexpr double RelativeRounding = 1e-12;
  static constexpr double MostExact = 1e300;

  // The cell at a place, or nearest to it; where the place is no number, the first, or the last.
  static std::uint32_t GetLowerCell(double place)
  {
    place = place > 0.0 ? place : 0.0;
    return static_cast<std::uint32_t>(
      place < Key::CellsPerSide - 1.0 ? place : Key::CellsPerSide - 1.0);
  }
  static std::uint32_t GetUpperCell(double place)
  {
    place = place < Key::CellsPerSide - 1.0 ? place : Key::CellsPerSide - 1.0;
    return static_cast<std::uint32_t>(place > 0.0 ? place : 0.0);
  }

  /** How many bits it takes to write x. */
  static int CountBits(std::uint32_t x) { return x == 0 ? 0 : HighestBit(x) + 1; }

  double CellsPerLength;
  unsigned Flat; ///< The mask of FlatAxes.
  GridPlace<Dim> Place;
  Cell<Dim> Home;
  double Farthest = 0.0;
  Cell<Dim> Lower{};
  Cell<Dim> Upper{};
  int Depth = 0;
  int CoverDepth = 0;
};
}

#endif
