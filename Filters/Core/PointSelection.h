// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointSelection_h
#define hashedoctree_PointSelection_h

#include "Execution.h"
#include "Grid.h"
#include "PointSpan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace hashedoctree
{
/**
 * Which points of a data set take part in a tree, and the box around them.
 *
 * Left out are points with a coordinate that is not finite (or is beyond Grid::MaxCoordinate), and,
 * where a box is given, the points outside it; points on its faces are inside. Both kinds are
 * counted. The points are taken in chunks of ChunkSize, so that threads can later write the kept
 * ones one after the other.
 */
template <int Dim>
class PointSelection
{
public:
  static constexpr std::size_t ChunkSize = 8192;

  /**
   * Selects from all points; O(n). Instantiated for PointSpans of float and double. Throws
   * std::length_error above MaxNumberOfPoints, std::invalid_argument for a box that is not finite,
   * lies beyond Grid::MaxCoordinate, or whose upper corner lies below its lower one, and
   * Interrupted.
   */
  template <typename Points>
  PointSelection(Points points, const std::optional<Box<Dim>>& given, const Execution& execution);

  /** The same points as `selection`, with the given ones of their coordinates. What the others must
   * be to be kept, the points that Keeps() is asked of must tell: see PlaneSpan, whose interval is
   * to be that of the box of `selection`. */
  template <int Space>
  PointSelection(const PointSelection<Space>& selection, const std::array<int, Dim>& axes)
    : HasBox(selection.HasBox)
    , Skipped(selection.Skipped)
    , Outside(selection.Outside)
    , FirstOfChunk(selection.FirstOfChunk)
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Bounds.Lower[axis] = selection.Bounds.Lower[axes[axis]];
      this->Bounds.Upper[axis] = selection.Bounds.Upper[axes[axis]];
    }
  }

  /** The given box, or the box around the kept points; Box's default when there are none. */
  const Box<Dim>& GetBox() const { return this->Bounds; }
  std::size_t GetNumberOfPoints() const { return this->FirstOfChunk.back(); }
  /** Points left out because a coordinate is not finite or is beyond Grid::MaxCoordinate. */
  std::size_t GetNumberOfSkippedPoints() const { return this->Skipped; }
  /** Other points left out because they are outside the given box. */
  std::size_t GetNumberOfOutsidePoints() const { return this->Outside; }
  /** How many points are kept before those of this chunk. */
  std::size_t GetFirstOfChunk(std::size_t chunk) const { return this->FirstOfChunk[chunk]; }

  /** Whether a point, the value of a span, is none of those that are skipped. Pure. */
  template <typename Coordinates>
  static bool CanBePlaced(const Coordinates& x)
  {
    bool canBe = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      // False for NaN, too.
      canBe &= std::abs(static_cast<double>(x[axis])) <= Grid<Dim>::MaxCoordinate;
    }
    return canBe;
  }
  /** Whether all points take part. */
  bool KeepsAll() const { return this->Skipped == 0 && this->Outside == 0; }
  /** Whether a point, the value of a span, takes part. Pure. */
  template <typename Coordinates>
  bool Keeps(const Coordinates& x) const
  {
    return CanBePlaced(x) && (!this->HasBox || this->IsInBox(x));
  }

private:
  template <int Space>
  friend class PointSelection;

  struct Census;
  template <typename Points>
  Census Count(Points points, std::size_t first, std::size_t last) const;

  template <typename Coordinates>
  bool IsInBox(const Coordinates& x) const
  {
    bool inside = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      inside &= x[axis] >= this->Bounds.Lower[axis] && x[axis] <= this->Bounds.Upper[axis];
    }
    return inside;
  }

  Box<Dim> Bounds;
  bool HasBox = false;
  std::size_t Skipped = 0;
  std::size_t Outside = 0;
  std::vector<std::size_t> FirstOfChunk;
};
}

#endif
