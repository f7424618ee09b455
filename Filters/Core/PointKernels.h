// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointKernels_h
#define hashedoctree_PointKernels_h

#include "PointIndex.h"

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/**
 * What searches do to the points of a leaf: their inner loops, compiled for the plain machine and
 * for AVX2. Which of them runs is found once at run time, so that a build needs no -march. Both
 * give the same results to the last bit: neither fuses multiplications and additions.
 */
template <int Dim, typename Real>
struct PointKernels
{
  static constexpr std::size_t MostPoints = 64; ///< That are measured at a time.
  static constexpr std::size_t Padding = 7;     ///< Coordinates that must exist beyond the last.

  ///@{
  /** Squared distances from x to `count` points, at least one, whose coordinates on one axis stand
   * side by side, and those on the next axis `stride` further: the sum of squared differences in
   * double, axis by axis in order. `dist2` has room for MostPoints; behind the last stands infinity
   * until their number is a multiple of 4. MeasurePoints() returns the least of them,
   * MeasurePointsWithin() which are not greater than a limit: bit i for the one to point i. */
  double (*MeasurePoints)(
    const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2);
  std::uint64_t (*MeasurePointsWithin)(const Real* coordinates, std::size_t stride,
    std::size_t count, const double* x, double limit, double* dist2);
  ///@}

  /** The same mask, of distances that one of them has written, at least one. */
  std::uint64_t (*Select)(const double* dist2, std::size_t count, double limit);

  /** Copies those of `count` ids, at least one, whose bits are set, in order; returns how many. No
   * more bits are set than there are ids; `to` has room for MostPoints. */
  std::size_t (*CopySelected)(
    const PointIndex* ids, std::size_t count, std::uint64_t selected, PointIndex* to);
};

/** The fastest kernels that the machine can run. */
template <int Dim, typename Real>
const PointKernels<Dim, Real>& GetPointKernels();

/** Those that run on every machine, to compare the others with. */
template <int Dim, typename Real>
const PointKernels<Dim, Real>& GetPlainPointKernels();
}

#endif
