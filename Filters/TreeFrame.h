// SPDX-License-Identifier: BSD-3-Clause
#ifndef TreeFrame_h
#define TreeFrame_h

#include "PlaneSpan.h"
#include "PointSpan.h"

#include <numeric>

namespace hashedoctree
{
/**
 * How a tree lies in space: which coordinate of space each of its axes is and, of a quadtree, the
 * plane across the remaining one that its cells lie in. Private to the module.
 */
template <int Dim>
class TreeFrame
{
public:
  /** The axes of the tree are the first ones of space, and the plane is at 0. */
  TreeFrame() { std::iota(this->Axes.begin(), this->Axes.end(), 0); }
  /** `axes` ascend; `inPlane` is any position in the plane. */
  TreeFrame(const std::array<int, Dim>& axes, const Position<3>& inPlane)
    : Axes(axes)
    , InPlane(inPlane)
  {
  }

  const std::array<int, Dim>& GetAxes() const { return this->Axes; }

  /** The position in the tree of one in space. */
  Position<Dim> Project(const double* x) const
  {
    Position<Dim> position;
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      position[axis] = x[this->Axes[axis]];
    }
    return position;
  }

  /** Writes the position in space of a corner; see Grid::GetCorner(). */
  void GetCorner(const Grid<Dim>& grid, const Cell<Dim>& corner, double* x) const
  {
    std::copy(this->InPlane.begin(), this->InPlane.end(), x);
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      x[this->Axes[axis]] = grid.GetCorner(corner[axis], static_cast<int>(axis));
    }
  }

private:
  std::array<int, Dim> Axes;
  Position<3> InPlane{};
};

/** All positions with finite coordinates. */
inline Box<3> GetFiniteSpace()
{
  constexpr double most = std::numeric_limits<double>::max();
  return { { -most, -most, -most }, { most, most, most } };
}

// The points as a tree in a frame takes them, without copying; `box` holds those that take part.

template <typename Real>
PointSpan<3, Real> Project(
  PointSpan<3, Real> points, const TreeFrame<3>&, const Box<3>& = GetFiniteSpace())
{
  return points;
}

template <typename Real>
PlaneSpan<Real> Project(
  PointSpan<3, Real> points, const TreeFrame<2>& frame, const Box<3>& box = GetFiniteSpace())
{
  const std::array<int, 2>& axes = frame.GetAxes();
  const auto across = static_cast<std::size_t>(3 - axes[0] - axes[1]);
  return { points.Coordinates, points.Count, axes, box.Lower[across], box.Upper[across] };
}
}

#endif
