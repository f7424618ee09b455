// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PlaceInBlock_h
#define hashedoctree_PlaceInBlock_h

#include "BallInGrid.h"
#include "BoxKernels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace hashedoctree
{
/**
 * Where a position lies as seen from a block, and how far the tight boxes of the block's children
 * are from it. Lengths are in steps of these boxes, 256 to the side of the block's cell. Distances
 * err on the near side. Private to PointDescent.h.
 */
template <int Dim>
class PlaceInBlock
{
public:
  /** Of a position given in cells of MaxDepth from the root's lower corner, for the block at a
   * depth that a cell of MaxDepth lies in; `cellsPerLength` is of the grid. */
  PlaceInBlock(
    const GridPlace<Dim>& place, const Cell<Dim>& inside, int depth, double cellsPerLength)
  {
    const int shift = MortonKey<Dim>::MaxDepth - depth;
    const double stepsPerCell = NumberOfSteps / static_cast<double>(std::uint64_t(1) << shift);
    for (int axis = 0; axis < Dim; ++axis)
    {
      const auto lower = static_cast<double>(inside[axis] >> shift << shift);
      this->Steps[axis] = (place[axis] - lower) * stepsPerCell;
    }
    const double stepsPerLength = stepsPerCell * cellsPerLength;
    this->PerLength2 = stepsPerLength * stepsPerLength;
  }

  /** As seen from a child of the block. */
  PlaceInBlock GetInChild(unsigned octant) const
  {
    PlaceInBlock child;
    for (int axis = 0; axis < Dim; ++axis)
    {
      // (A product, since a choice is made by a branch, which nobody could foresee.)
      const auto upper = static_cast<double>(octant >> (Dim - 1 - axis) & 1U);
      child.Steps[axis] = 2.0 * this->Steps[axis] - NumberOfSteps * upper;
    }
    child.PerLength2 = 4.0 * this->PerLength2;
    return child;
  }

  /** Whether floats will do to measure with: further away the boxes are all one to a float. */
  bool IsNear() const
  {
    double farthest = 0.0;
    for (const double steps : this->Steps)
    {
      farthest = std::max(farthest, std::abs(steps));
    }
    return farthest <= Far;
  }
  /** The same of a child, by the squared distance to its box from here. */
  static bool IsNearToChild(float dist2) { return dist2 <= static_cast<float>(Far * Far / 4.0); }

  /** Squared distance in steps to a squared one in world units. Where squares are too small or too
   * large to be exact, infinite. */
  double ToSteps2(double dist2) const
  {
    return this->IsExact() ? dist2 * this->PerLength2 : std::numeric_limits<double>::infinity();
  }
  bool IsExact() const { return BallInGrid<Dim>::IsExact(this->PerLength2); }

  /** How much further than a reach a measured distance may be, as a factor, if the true one is
   * within. */
  template <typename T>
  static constexpr double Room = 1.0 + 3.0 * BoxKernels<Dim>::template BoxError<T>;

  ///@{
  /** Squared distances to the boxes of all children; returns the mask of those within the squared
   * reach. In float only from near. */
  unsigned Measure(
    const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes, double reach2, float* dist2) const
  {
    return kernels.MeasureBoxes(
      boxes, this->Steps.data(), static_cast<float>(reach2 * Room<float>), dist2);
  }
  unsigned Measure(const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes, double reach2,
    double* dist2) const
  {
    return kernels.MeasureBoxesFromAfar(boxes, this->Steps.data(), reach2 * Room<double>, dist2);
  }
  ///@}

  /** A squared distance in world units within which one of some children surely has its points.
   * Only from near. */
  double GetPromise2(
    const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes, unsigned octants) const
  {
    if (!this->IsExact())
    {
      return std::numeric_limits<double>::infinity();
    }
    const float dist2 = kernels.MeasureFarthestCorner(boxes, this->Steps.data(), octants);
    return static_cast<double>(dist2) * Room<float> / this->PerLength2;
  }

  /** The mask of the children whose boxes surely lie within the squared reach as a whole. In float
   * only from near. */
  template <typename T>
  unsigned GetWhole(
    const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes, double reach2) const
  {
    constexpr double shrink = 1.0 / Room<T>;
    const auto limit = static_cast<T>(reach2 * shrink);
    if constexpr (std::is_same_v<T, float>)
    {
      return kernels.SelectWholeBoxes(boxes, this->Steps.data(), limit);
    }
    else
    {
      return kernels.SelectWholeBoxesFromAfar(boxes, this->Steps.data(), limit);
    }
  }

private:
  PlaceInBlock() = default;

  static constexpr double NumberOfSteps = ChildBoxes<Dim>::Steps;
  static constexpr double Far = 64.0 * NumberOfSteps;
  static_assert(Far + 2.0 * NumberOfSteps <= BoxKernels<Dim>::FarthestPlace,
    "the kernels must take the places of children that are near");

  std::array<double, Dim> Steps; ///< From the lower corner of the block's cell.
  double PerLength2;             ///< Squared steps in a squared world unit.
};
}

#endif
