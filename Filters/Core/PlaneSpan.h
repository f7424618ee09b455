// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PlaneSpan_h
#define hashedoctree_PlaneSpan_h

#include <array>
#include <cstddef>
#include <limits>

namespace hashedoctree
{
/**
 * A view of `Count` points, three coordinates each, as points of a plane: two of their coordinates,
 * read where they are. The third one is only asked whether it lies in [Lower, Upper]; where it does
 * not, and where it is NaN, so are both coordinates in the plane.
 *
 * Takes the place of a PointSpan<2, Real> where points are read once, one after the other.
 */
template <typename Real>
struct PlaneSpan
{
  const Real* Coordinates = nullptr;
  std::size_t Count = 0;
  std::array<int, 2> Axes{ 0, 1 }; ///< Of space, in [0, 2], the coordinates in the plane.
  double Lower = -std::numeric_limits<double>::max();
  double Upper = std::numeric_limits<double>::max();

  std::array<Real, 2> operator[](std::size_t i) const
  {
    constexpr Real notANumber = std::numeric_limits<Real>::quiet_NaN();
    const Real* x = this->Coordinates + 3 * i;
    const auto across = static_cast<double>(x[3 - this->Axes[0] - this->Axes[1]]);
    return across >= this->Lower && across <= this->Upper
      ? std::array<Real, 2>{ x[this->Axes[0]], x[this->Axes[1]] }
      : std::array<Real, 2>{ notANumber, notANumber };
  }
};
}

#endif
