// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_BoxKernels_h
#define hashedoctree_BoxKernels_h

#include "ChildBoxes.h"

namespace hashedoctree
{
/**
 * What searches for points do to the boxes of a block's children: inner loops as PointKernels are,
 * and chosen as they are. Both kinds err as told here, and may differ by it.
 */
template <int Dim>
struct BoxKernels
{
  ///@{
  /** Squared distances from a place to the boxes of all children, both in steps of the block: never
   * more than the true ones, but for a factor of (1 + BoxError). In float the place is at most
   * FarthestPlace steps from the corner of the block on each axis; in double it is anywhere.
   * Returns the mask of the distances that are not greater than `limit`, which is all of them where
   * the limit is no number. */
  unsigned (*MeasureBoxes)(
    const ChildBoxes<Dim>& boxes, const double* steps, float limit, float* dist2);
  unsigned (*MeasureBoxesFromAfar)(
    const ChildBoxes<Dim>& boxes, const double* steps, double limit, double* dist2);
  ///@}

  ///@{
  /** Which children's boxes lie within a squared distance of a place as a whole: the mask of those
   * whose farthest corner is nearer than `limit`. Places as those of MeasureBoxes(); corners are
   * never taken for nearer than they are, but for a factor of (1 + BoxError). */
  unsigned (*SelectWholeBoxes)(const ChildBoxes<Dim>& boxes, const double* steps, float limit);
  unsigned (*SelectWholeBoxesFromAfar)(
    const ChildBoxes<Dim>& boxes, const double* steps, double limit);
  ///@}

  /** The least squared distance from a place to the farthest corner of a box, of the boxes of some
   * children: no box has its points further away. Infinite where there are none. The place is as
   * near as MeasureBoxes() asks for; never less than the true one, but for a factor of
   * (1 + BoxError). */
  float (*MeasureFarthestCorner)(
    const ChildBoxes<Dim>& boxes, const double* steps, unsigned octants);

  static constexpr double FarthestPlace = 128.0 * ChildBoxes<Dim>::Steps;
  template <typename T>
  static constexpr double BoxError = sizeof(T) == sizeof(float) ? 4e-6 : 4e-15;
};

/** The fastest kernels that the machine can run. */
template <int Dim>
const BoxKernels<Dim>& GetBoxKernels();

/** Those that run on every machine, to compare the others with. */
template <int Dim>
const BoxKernels<Dim>& GetPlainBoxKernels();
}

#endif
