// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Grid_h
#define hashedoctree_Grid_h

#include "Interleaving.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "HashedOctree must tell infinities and NaN from numbers; compile it without -ffast-math"
#endif

namespace hashedoctree
{
/** A position in world coordinates. */
template <int Dim>
using Position = std::array<double, Dim>;

/** A place in a grid: in its cells of MaxDepth, from the lower corner of the root. */
template <int Dim>
using GridPlace = std::array<double, Dim>;

/** Whether all coordinates are numbers, and not infinite. */
template <std::size_t Dim>
bool IsFinite(const std::array<double, Dim>& x)
{
  bool finite = true;
  for (const double coordinate : x)
  {
    finite &= std::isfinite(coordinate);
  }
  return finite;
}

/** A box in world coordinates, faces included. The default holds nothing. */
template <int Dim>
struct Box
{
  Position<Dim> Lower;
  Position<Dim> Upper;

  Box()
  {
    this->Lower.fill(std::numeric_limits<double>::infinity());
    this->Upper.fill(-std::numeric_limits<double>::infinity());
  }
  Box(const Position<Dim>& lower, const Position<Dim>& upper)
    : Lower(lower)
    , Upper(upper)
  {
  }

  void Add(const Box& other)
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Lower[axis] = std::min(this->Lower[axis], other.Lower[axis]);
      this->Upper[axis] = std::max(this->Upper[axis], other.Upper[axis]);
    }
  }
};

/**
 * World coordinates to the integer cells of MaxDepth, and back. This is the only place
 * that rounds points to cells, with GridCells.h, which does the same to many at once: trees are
 * built of integer keys, so a point and its leaf can never disagree. Searches that measure lengths
 * (BallInGrid, PointBoxWalk, NodeBall) say how they round.
 *
 * The root cube has the lower corner of the box and its largest extent as side, or side 1 where
 * the box is a single point. Cells are half open, but for those on the upper faces of the cube,
 * which hold the points on these faces (paper E1: there x = 1 would fall into a cell beyond).
 */
template <int Dim>
class Grid
{
public:
  using Key = MortonKey<Dim>;

  /** Coordinates beyond this, and those that are not finite, cannot be placed in a grid: the
   * extent of a box must itself be a finite number. */
  static constexpr double MaxCoordinate = std::numeric_limits<double>::max() / 4;

  Grid()
    : Grid(Box<Dim>(Position<Dim>{}, Position<Dim>{}))
  {
  }
  explicit Grid(const Box<Dim>& box)
    : Lower(box.Lower)
    , Side(0.0)
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Side = std::max(this->Side, box.Upper[axis] - box.Lower[axis]);
    }
    if (this->Side == 0.0)
    {
      this->Side = 1.0;
    }
    this->CellsPerLength = 1.0 / std::ldexp(this->Side, -Key::MaxDepth);
  }

  const Position<Dim>& GetLower() const { return this->Lower; }
  /** Side of the root cube, in world units. */
  double GetSide() const { return this->Side; }
  /** Side of the cells at a depth, in world units. */
  double GetSide(int depth) const { return std::ldexp(this->Side, -depth); }
  /** Cells of MaxDepth along a world unit. */
  double GetCellsPerLength() const { return this->CellsPerLength; }

  /** Cell coordinate at MaxDepth: floor((x - lower) / side * 2^MaxDepth), brought into the cube.
   * Positions outside the cube get the cell nearest to them on this axis, NaN gets 0. */
  std::uint32_t GetCellCoordinate(double x, int axis) const
  {
    double t = (x - this->Lower[axis]) / this->Side * Key::CellsPerSide;
    t = t > 0.0 ? t : 0.0;
    t = t < Key::CellsPerSide - 1.0 ? t : Key::CellsPerSide - 1.0;
    return static_cast<std::uint32_t>(t);
  }

  /** Cell at MaxDepth that holds the position x[0], x[1], ... */
  template <typename Coordinates>
  Cell<Dim> GetCell(const Coordinates& x) const
  {
    Cell<Dim> cell;
    for (int axis = 0; axis < Dim; ++axis)
    {
      cell[axis] = this->GetCellCoordinate(static_cast<double>(x[axis]), axis);
    }
    return cell;
  }

  /** Key at MaxDepth of the position. */
  template <typename Coordinates>
  Key GetKey(const Coordinates& x) const
  {
    return InterleaveCell<Dim>(this->GetCell(x), Key::MaxDepth);
  }

  /** World position of the lower corner of a cell of MaxDepth, given by its coordinates in
   * [0, 2^MaxDepth]. Nodes of any depth that share a corner get the same position. */
  double GetCorner(std::uint32_t coordinate, int axis) const
  {
    return this->Lower[axis] + this->Side * (static_cast<double>(coordinate) / Key::CellsPerSide);
  }

private:
  Position<Dim> Lower;
  double Side;
  double CellsPerLength;
};
}

#endif
