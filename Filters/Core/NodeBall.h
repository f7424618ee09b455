// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeBall_h
#define hashedoctree_NodeBall_h

#include "Grid.h"
#include "NeighborCells.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>

namespace hashedoctree
{
/**
 * A ball around the center of a node (paper section 3c), in the grid of a tree. Lengths are in half
 * cells of MaxDepth, in which the corners and centers of all nodes are integers, so that what
 * rounds is only this: the radius, which is radius / side of the root * 2^(MaxDepth + 1) in double;
 * its square; and the sum of the squared distances on each axis, which are integers. Its order does
 * not matter: in three and four dimensions it is exact, and in two it has but two terms.
 */
template <int Dim>
class NodeBall
{
public:
  using Key = MortonKey<Dim>;
  /** Two numbers in one register. */
  using Pair __attribute__((vector_size(2 * sizeof(double)))) = double;
  /** The lower corner of a cell, from the center of the ball, as the machine computes it: the axes
   * two by two, and 0 where an odd number of them leaves room. */
  using Corner = std::array<Pair, (Dim + 1) / 2>;

  /** `radius` in world units, not negative; may be infinite. */
  NodeBall(const Grid<Dim>& grid, Key node, double radius)
    : Radius(radius / grid.GetSide() * GetSize(0))
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
    const double halfSize = 0.5 * GetSize(this->Depth);
    return halfSize * halfSize <= this->Radius2;
  }

  /** Whether a cell, its faces included, meets the ball. */
  bool Meets(const Cell<Dim>& cell, int depth) const
  {
    const std::int64_t size = std::int64_t(2) << (Key::MaxDepth - depth);
    double nearest2 = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t lower = cell[axis] * size - this->Center[axis];
      const auto nearest = static_cast<double>(std::max<std::int64_t>({ 0, lower, -lower - size }));
      nearest2 += nearest * nearest;
    }
    return nearest2 <= this->Radius2;
  }

  /** Of the 2^Dim cells of this size around a corner, which is the upper one of the first: those
   * that meet the ball, one bit for each octant. `lower` is the first one's lower corner. */
  std::uint32_t GetMeetingOctants(const Corner& lower, double size) const
  {
    // On each axis there are two places only, which make a vector.
    const Pair places = { 0.0, size };
    std::array<Pair, Dim> nearest2;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const Pair below = lower[axis / 2][axis % 2] + places;
      const Pair above = -size - below;
      const Pair nearest = GetLarger(GetLarger(below, above), Pair{});
      nearest2[axis] = nearest * nearest;
    }
    // Sums over the last axes, for all places along them. (In whatever order: see above.)
    std::array<Pair, Key::NumberOfOctants / 2> sums;
    sums[0] = nearest2[Dim - 1];
    std::size_t count = 1;
    for (int axis = Dim - 2; axis >= 0; --axis, count *= 2)
    {
      const double first = nearest2[axis][0];
      const double second = nearest2[axis][1];
      for (std::size_t i = 0; i < count; ++i)
      {
        sums[count + i] = second + sums[i];
        sums[i] = first + sums[i];
      }
    }
    std::uint32_t meeting = 0;
    for (unsigned i = 0; i < count; ++i)
    {
      meeting |= GetBits(sums[i] <= this->Radius2) << (2 * i);
    }
    return meeting;
  }

  /** The lower corner of a cell. Exact. */
  Corner GetLower(const Cell<Dim>& cell, int depth) const
  {
    Corner lower{};
    for (int axis = 0; axis < Dim; ++axis)
    {
      lower[axis / 2][axis % 2] = static_cast<double>(
        (std::int64_t(cell[axis]) << (Key::MaxDepth + 1 - depth)) - this->Center[axis]);
    }
    return lower;
  }

  /** The same of one of the 2^Dim cells of this size of which the first has this lower corner. */
  static Corner GetLowerOfOctant(const Corner& lower, double size, unsigned octant)
  {
    const Pair sizes = { size, size };
    Corner corner;
    for (std::size_t i = 0; i < corner.size(); ++i)
    {
      // (A product, since a choice is made by a branch, which nobody could foresee.)
      corner[i] = lower[i] + sizes * Steps.OfOctant[octant][i];
    }
    return corner;
  }

  /** The side of the cells at a depth. */
  static double GetSize(int depth)
  {
    return static_cast<double>(std::int64_t(2) << (Key::MaxDepth - depth));
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
  /** For each octant 1 along the axes on which it is the upper one, else 0. */
  struct OctantSteps
  {
    std::array<Corner, Key::NumberOfOctants> OfOctant{};

    constexpr OctantSteps()
    {
      for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
      {
        std::array<double, 2 * std::tuple_size<Corner>::value> steps{};
        for (int axis = 0; axis < Dim; ++axis)
        {
          steps[axis] = octant >> (Dim - 1 - axis) & 1U;
        }
        for (std::size_t i = 0; i < steps.size(); i += 2)
        {
          this->OfOctant[octant][i / 2] = Pair{ steps[i], steps[i + 1] };
        }
      }
    }
  };
  static constexpr OctantSteps Steps{};

  using Truths __attribute__((vector_size(2 * sizeof(double)))) = std::int64_t;

  /** Of each pair of numbers the larger, none of which is NaN. (GCC compares, and chooses by
   * masks.) */
  static Pair GetLarger(Pair a, Pair b)
  {
#ifdef __SSE2__
    return _mm_max_pd(a, b);
#else
    return a > b ? a : b;
#endif
  }

  static std::uint32_t GetBits(Truths truths)
  {
#ifdef __SSE2__
    return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(truths)));
#else
    return (truths[0] != 0 ? 1U : 0U) | (truths[1] != 0 ? 2U : 0U);
#endif
  }

  double Radius;
  double Radius2;
  int Depth;
  std::array<std::int64_t, Dim> Center;
};
}

#endif
