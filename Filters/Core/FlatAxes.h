// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_FlatAxes_h
#define hashedoctree_FlatAxes_h

#include "Grid.h"

#include <algorithm>

namespace hashedoctree
{
/**
 * The axes along which points are flat: all of them lie in the first cell of MaxDepth there, as
 * those of an image, of a line, or of anything very thin. What a search needs to know of such an
 * axis is how far the position is from the points, not on which side. Lengths are in cells of
 * MaxDepth from the root's lower corner. Immutable; thread safe.
 */
template <int Dim>
class FlatAxes
{
public:
  /** None. */
  FlatAxes() = default;
  /** Of points that lie in a box, and of its grid. */
  FlatAxes(const Box<Dim>& box, const Grid<Dim>& grid)
  {
    constexpr double surelyInTheFirstCell = 0.5;
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Upper[axis] = (box.Upper[axis] - box.Lower[axis]) * grid.GetCellsPerLength();
      const bool isFlat = this->Upper[axis] >= 0.0 && this->Upper[axis] < surelyInTheFirstCell;
      this->Mask |= static_cast<unsigned>(isFlat) << axis;
    }
  }

  /** Bit i for axis i. */
  unsigned GetMask() const { return this->Mask; }

  /**
   * Turns a place above the points to the other side of them, as far below, where the axis
   * is flat, and one beside them to the first cell. A search does not notice, since it measures the
   * points themselves from where the position is, and of their cells all that it knows is that they
   * are the first ones. But the boxes of nodes, which are rounded upwards, are tight only from
   * below.
   */
  double Fold(double place, int axis) const
  {
    return (this->Mask >> axis & 1U) != 0 ? std::min({ place, this->Upper[axis] - place, 0.0 })
                                          : place;
  }

private:
  GridPlace<Dim> Upper{}; ///< Of the points.
  unsigned Mask = 0;
};
}

#endif
