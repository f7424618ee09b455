// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeBall_h
#define hashedoctree_NodeBall_h

#include "Grid.h"
#include "NeighborCells.h"

#include <algorithm>
#include <cmath>

namespace hashedoctree
{
/** How a cell lies to a ball, both closed. */
enum class BallSide
{
  Outside,
  Across,
  Inside
};

/** How the children of a cell lie to a ball, one bit for each octant. */
struct BallSides
{
  std::uint32_t Meeting; ///< Across or inside.
  std::uint32_t Inside;
};

/**
 * A ball around the center of a node (paper section 3c), in the grid of a tree. Lengths are in half
 * cells of MaxDepth, in which the corners and centers of all nodes are integers, so that what
 * rounds is only this: the radius, which is radius / side of the root * 2^(MaxDepth + 1) in double;
 * its square; and the sum of the squared distances on each axis, which are integers, in the order
 * of the axes (exact in three and four dimensions).
 */
template <int Dim>
class NodeBall
{
public:
  using Key = MortonKey<Dim>;

  /** `radius` in world units, not negative; may be infinite. */
  NodeBall(const Grid<Dim>& grid, Key node, double radius)
    : Radius(std::ldexp(radius / grid.GetSide(), Key::MaxDepth + 1))
    , Radius2(this->Radius * this->Radius)
    , Depth(node.GetDepth())
  {
    const Cell<Dim> cell = node.GetCell();
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Center[axis] = (2 * std::int64_t(cell[axis]) + 1) << (Key::MaxDepth - this->Depth);
    }
  }

  /** Whether it reaches the border of the node. If not, it meets no other leaf. */
  bool ReachesBorder() const
  {
    return Square(std::int64_t(1) << (Key::MaxDepth - this->Depth)) <= this->Radius2;
  }

  BallSide GetSide(const Cell<Dim>& cell, int depth) const
  {
    double nearest2 = 0.0;
    double farthest2 = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t size = std::int64_t(2) << (Key::MaxDepth - depth);
      const std::int64_t below = this->Center[axis] - cell[axis] * size;
      const std::int64_t above = size - below;
      nearest2 += Square(std::max<std::int64_t>({ 0, -below, -above }));
      farthest2 += Square(std::max(below, above));
    }
    return nearest2 > this->Radius2 ? BallSide::Outside
      : farthest2 > this->Radius2   ? BallSide::Across
                                    : BallSide::Inside;
  }

  /** How the children of a cell lie to the ball. `depth` is that of the cell. */
  BallSides GetSidesOfChildren(const Cell<Dim>& cell, int depth) const
  {
    // On each axis there are two places only.
    std::array<std::array<double, 2>, Dim> nearest2;
    std::array<std::array<double, 2>, Dim> farthest2;
    const std::int64_t size = std::int64_t(1) << (Key::MaxDepth - depth);
    for (int axis = 0; axis < Dim; ++axis)
    {
      for (std::size_t half = 0; half < 2; ++half)
      {
        const std::int64_t below =
          this->Center[axis] - (2 * std::int64_t(cell[axis]) + std::int64_t(half)) * size;
        const std::int64_t above = size - below;
        nearest2[axis][half] = Square(std::max<std::int64_t>({ 0, -below, -above }));
        farthest2[axis][half] = Square(std::max(below, above));
      }
    }
    BallSides sides{ 0, 0 };
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      double near2 = 0.0;
      double far2 = 0.0;
      for (int axis = 0; axis < Dim; ++axis)
      {
        const unsigned half = octant >> (Dim - 1 - axis) & 1U;
        near2 += nearest2[axis][half];
        far2 += farthest2[axis][half];
      }
      sides.Meeting |= (near2 <= this->Radius2 ? 1U : 0U) << octant;
      sides.Inside |= (far2 <= this->Radius2 ? 1U : 0U) << octant;
    }
    return sides;
  }

  /** Cells, 2^Dim at most, that hold all of the ball that is in the root: of the deepest depth
   * whose cells are as wide. Above the node where the ball reaches its border. */
  NeighborCells<Dim> GetCover() const
  {
    constexpr std::int64_t size = std::int64_t(2) << Key::MaxDepth;
    // Cells at the next whole length are beyond the ball, also when squares are rounded.
    const std::int64_t reach =
      this->Radius < static_cast<double>(size) ? static_cast<std::int64_t>(this->Radius) + 1 : size;
    NeighborCells<Dim> cells;
    std::uint32_t width = 1;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t lower = std::max<std::int64_t>(this->Center[axis] - reach, 0);
      const std::int64_t upper = std::min(this->Center[axis] + reach, size - 1);
      cells.Lower[axis] = static_cast<std::uint32_t>(lower / 2);
      cells.Upper[axis] = static_cast<std::uint32_t>(upper / 2);
      width |= cells.Upper[axis] - cells.Lower[axis];
    }
    const int shift = HighestBit(width) + 1;
    for (int axis = 0; axis < Dim; ++axis)
    {
      cells.Lower[axis] >>= shift;
      cells.Upper[axis] >>= shift;
    }
    cells.Depth = Key::MaxDepth - shift;
    return cells;
  }

private:
  static double Square(std::int64_t length)
  {
    return static_cast<double>(length) * static_cast<double>(length);
  }

  double Radius;
  double Radius2;
  int Depth;
  std::array<std::int64_t, Dim> Center;
};
}

#endif
