// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeBall_h
#define hashedoctree_NodeBall_h

#include "Grid.h"
#include "Lanes.h"
#include "NeighborCells.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cstdint>

namespace hashedoctree
{
/**
 * A ball around the center of a node (paper section 2), in the grid of a tree. Lengths are in half
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
  using Pair = Lanes<double, 2>;
  /** The lower corner of a cell, from the center of the ball, as the machine computes it: 0 where
   * there are fewer than four axes. (Functions do not return it, since how depends on the machine.)
   */
  using Corner = Lanes<double, 4>;
  static_assert(Dim <= 4, "a corner has four coordinates");

  /** `radius` in world units, not negative; may be infinite. */
  NodeBall(const Grid<Dim>& grid, Key node, double radius)
    : Radius(radius / grid.GetSide() * GetSide(0))
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
    const double halfSide = 0.5 * GetSide(this->Depth);
    return halfSide * halfSide <= this->Radius2;
  }

  /** Whether a cell, its faces included, meets the ball. */
  bool Meets(const Cell<Dim>& cell, int depth) const
  {
    const std::int64_t side = std::int64_t(2) << (Key::MaxDepth - depth);
    double nearest2 = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t lower = cell[axis] * side - this->Center[axis];
      const auto nearest = static_cast<double>(std::max<std::int64_t>({ 0, lower, -lower - side }));
      nearest2 += nearest * nearest;
    }
    return nearest2 <= this->Radius2;
  }

  /** Of the 2^Dim cells of this side around a corner, which is the upper one of the first: those
   * that meet the ball, one bit for each octant. `lower` is the first one's lower corner. */
  std::uint32_t GetMeetingOctants(PlainMachine, const Corner& lower, double side) const
  {
    // On each axis there are two places only, which make a vector.
    const Pair places = { 0.0, side };
    std::array<Pair, Dim> nearest2;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const Pair below = lower[axis] + places;
      const Pair above = -side - below;
      const Pair nearest = GetLarger(GetLarger(below, above), Pair{});
      nearest2[axis] = nearest * nearest;
    }
    Pair sums[Key::NumberOfOctants / 2];
    sums[0] = nearest2[Dim - 1];
    std::size_t count = 1;
    for (int axis = Dim - 2; axis >= 0; --axis)
    {
      AddAxis(nearest2[axis][0], nearest2[axis][1], sums, count);
    }
    std::uint32_t meeting = 0;
    for (unsigned i = 0; i < Key::NumberOfOctants / 2; ++i)
    {
      meeting |= GetBits(sums[i] <= this->Radius2) << (2 * i);
    }
    return meeting;
  }

#if defined(__x86_64__)
  /** The same by AVX2. */
  HASHEDOCTREE_WITH_AVX2 std::uint32_t GetMeetingOctants(
    Avx2Machine, const Corner& lower, double side) const
  {
    const __m256d minusFirstUpper = _mm256_set1_pd(-side) - lower;
    const __m256d first = GetNearest2(lower, minusFirstUpper);
    const __m256d second = GetNearest2(lower + side, minusFirstUpper - side);
    // Sums over the last two axes make a vector.
    constexpr int last = Dim - 1;
    __m256d sums[std::max(Key::NumberOfOctants / 4U, 1U)];
    sums[0] = Spread<last, 0b01000100>(first, second);
    if constexpr (Dim > 1)
    {
      sums[0] += Spread<last - 1, 0b01010000>(first, second);
    }
    std::size_t count = 1;
    for (int axis = Dim - 3; axis >= 0; --axis)
    {
      AddAxis(first[axis], second[axis], sums, count);
    }
    const __m256d radius2 = _mm256_set1_pd(this->Radius2);
    unsigned meeting = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const int bits = _mm256_movemask_pd(_mm256_cmp_pd(sums[i], radius2, _CMP_LE_OQ));
      meeting |= static_cast<unsigned>(bits) << (4 * i);
    }
    return meeting & ((1U << Key::NumberOfOctants) - 1U);
  }
#endif

  /** The lower corner of a cell. Exact. */
  HASHEDOCTREE_INLINE void GetLower(const Cell<Dim>& cell, int depth, Corner& lower) const
  {
    lower = Corner{};
    for (int axis = 0; axis < Dim; ++axis)
    {
      lower[axis] = static_cast<double>(
        (std::int64_t(cell[axis]) << (Key::MaxDepth + 1 - depth)) - this->Center[axis]);
    }
  }

  /** The same of one of the 2^Dim cells of this side of which the first has this lower corner. */
  HASHEDOCTREE_INLINE static void GetLowerOfOctant(
    const Corner& lower, double side, unsigned octant, Corner& lowerOfOctant)
  {
    // (A product, since a choice is made by a branch, which nobody could foresee.)
    lowerOfOctant = lower + side * Steps.OfOctant[octant];
  }

  /** The side of the cells at a depth. */
  static double GetSide(int depth)
  {
    return static_cast<double>(std::int64_t(2) << (Key::MaxDepth - depth));
  }

  /** Cells, 2^Dim at most, that hold all of the ball (up to the next whole length) that is in the
   * root: of the deepest depth whose cells are as wide. Above the node where the ball reaches its
   * border. */
  NeighborCells<Dim> GetCover() const
  {
    constexpr std::int64_t side = std::int64_t(2) << Key::MaxDepth;
    // Cells at the next whole length are beyond the ball, also when squares are rounded.
    const std::int64_t reach =
      this->Radius < static_cast<double>(side) ? static_cast<std::int64_t>(this->Radius) + 1 : side;
    NeighborCells<Dim> cells;
    std::uint32_t width = 1;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t lower = std::max<std::int64_t>(this->Center[axis] - reach, 0);
      const std::int64_t upper = std::min(this->Center[axis] + reach, side - 1);
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
        std::array<double, 4> steps{};
        for (int axis = 0; axis < Dim; ++axis)
        {
          steps[axis] = octant >> (Dim - 1 - axis) & 1U;
        }
        this->OfOctant[octant] = Corner{ steps[0], steps[1], steps[2], steps[3] };
      }
    }
  };
  static constexpr OctantSteps Steps{};

  /** Sums over the last axes, for all places along them, become sums over one more axis, which has
   * two places. (In whatever order: see above.) */
  template <typename Sum>
  HASHEDOCTREE_INLINE static void AddAxis(
    double first, double second, Sum* sums, std::size_t& count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      sums[count + i] = second + sums[i];
      sums[i] = first + sums[i];
    }
    count *= 2;
  }

  using Truths = Lanes<std::int64_t, 2>;

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

#if defined(__x86_64__)
  /** On each axis the squared distance to the nearest place of a cell, whose lower corner and the
   * upper one with the other sign are given. */
  HASHEDOCTREE_WITH_AVX2 static __m256d GetNearest2(__m256d lower, __m256d minusUpper)
  {
    const __m256d nearest = _mm256_max_pd(_mm256_max_pd(lower, minusUpper), _mm256_setzero_pd());
    return _mm256_mul_pd(nearest, nearest);
  }

  /** What belongs to an axis at its first and its second place, 0 and 1, in this order: two bits
   * for each lane, the first one's the lowest. */
  template <int Axis, int Order>
  HASHEDOCTREE_WITH_AVX2 static __m256d Spread(__m256d first, __m256d second)
  {
    const __m256d places =
      Axis % 2 == 0 ? _mm256_unpacklo_pd(first, second) : _mm256_unpackhi_pd(first, second);
    return _mm256_permute4x64_pd(places, Order + (Axis < 2 ? 0 : 0b10101010));
  }
#endif

  double Radius;
  double Radius2;
  int Depth;
  std::array<std::int64_t, Dim> Center;
};
}

#endif
