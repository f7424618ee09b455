// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DistanceKernels_h
#define hashedoctree_DistanceKernels_h

#include "MortonKey.h"
#include "PointIndex.h"

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/**
 * The tight boxes of the children of one block, in 256 steps along each side of the block's cell
 * and rounded outwards. `Lower` and `Upper` name the first and the last step that a child's points
 * touch. The boxes of children without points have no meaning.
 */
template <int Dim>
struct ChildBoxes
{
  static constexpr int Steps = 256;

  std::uint8_t Lower[Dim][MortonKey<Dim>::NumberOfOctants];
  std::uint8_t Upper[Dim][MortonKey<Dim>::NumberOfOctants];
};

/**
 * The inner loops of all searches for points, compiled for the plain machine and for AVX2;
 * which one runs is found once at run time, so that a build needs no -march. Both give the same
 * results to the last bit: neither fuses multiplications and additions.
 */
template <int Dim, typename Real>
struct DistanceKernels
{
  static constexpr std::size_t MostPoints = 64; ///< That are measured at a time.
  static constexpr std::size_t Padding = 7;     ///< Coordinates that must exist beyond the last.

  ///@{
  /** Squared distances from x to `count` points, at least one, whose coordinates on one axis stand
   * side by side, and those on the next axis `stride` further: the sum of squared differences in
   * double, axis by axis in order. `dist2` has room for MostPoints; behind the last stands infinity
   * until their number is a multiple of 4. ToPoints() returns the least of them, ToPointsWithin()
   * which are not greater than a limit: bit i for the one to point i. */
  double (*ToPoints)(
    const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2);
  std::uint64_t (*ToPointsWithin)(const Real* coordinates, std::size_t stride, std::size_t count,
    const double* x, double limit, double* dist2);
  ///@}

  /** The same mask, of distances that one of them has written, at least one. */
  std::uint64_t (*Select)(const double* dist2, std::size_t count, double limit);

  /** Copies those of `count` ids, at least one, whose bits are set, in order; returns how many. No
   * more bits are set than there are ids; `to` has room for MostPoints. */
  std::size_t (*CopySelected)(
    const PointIndex* ids, std::size_t count, std::uint64_t selected, PointIndex* to);

  ///@{
  /** Squared distances from a place to the boxes of all children, both in steps of the block: never
   * more than the true ones, but for a factor of (1 + BoxError). In float the place is at most
   * FarthestPlace steps from the corner of the block on each axis; in double it is anywhere.
   * Returns the mask of the distances that are not greater than `limit`, which is all of them where
   * the limit is no number. */
  unsigned (*ToBoxes)(const ChildBoxes<Dim>& boxes, const double* steps, float limit, float* dist2);
  unsigned (*ToBoxesFromAfar)(
    const ChildBoxes<Dim>& boxes, const double* steps, double limit, double* dist2);
  ///@}

  ///@{
  /** Which children's boxes lie within a squared distance of a place as a whole: the mask of those
   * whose farthest corner is nearer than `limit`. Places as those of ToBoxes(); corners are never
   * taken for nearer than they are, but for a factor of (1 + BoxError). */
  unsigned (*ToWholeBoxes)(const ChildBoxes<Dim>& boxes, const double* steps, float limit);
  unsigned (*ToWholeBoxesFromAfar)(const ChildBoxes<Dim>& boxes, const double* steps, double limit);
  ///@}

  /** The least squared distance from a place to the farthest corner of a box, of the boxes of some
   * children: no box has its points further away. Infinite where there are none. The place is as
   * near as ToBoxes() asks for; never less than the true one, but for a factor of (1 + BoxError).
   */
  float (*ToFarthestCorner)(const ChildBoxes<Dim>& boxes, const double* steps, unsigned octants);

  static constexpr double FarthestPlace = 128.0 * ChildBoxes<Dim>::Steps;
  template <typename T>
  static constexpr double BoxError = sizeof(T) == sizeof(float) ? 4e-6 : 4e-15;
};

/** The fastest kernels that the machine can run. */
template <int Dim, typename Real>
const DistanceKernels<Dim, Real>& GetDistanceKernels();

/** Those that run on every machine, to compare the others with. */
template <int Dim, typename Real>
const DistanceKernels<Dim, Real>& GetPlainDistanceKernels();
}

#endif
