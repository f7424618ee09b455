// SPDX-License-Identifier: BSD-3-Clause
#include "FiniteBox.h"

#include "ForEachDimension.h"
#include "Lanes.h"

#include <cstring>

namespace hashedoctree
{
namespace
{
/** What is known of coordinates, each lane for itself. */
template <typename Real>
struct LaneExtent
{
  static constexpr std::size_t Width = 16 / sizeof(Real); ///< As every x86-64 has.
  using Vector = Lanes<Real, Width>;

  Vector Lower = Vector{} + std::numeric_limits<Real>::infinity();
  Vector Upper = Vector{} - std::numeric_limits<Real>::infinity();
  Vector Zero = {}; ///< Stays 0 while all are finite: then 0 times each is 0, else it is NaN.

  HASHEDOCTREE_INLINE void Add(const Real* coordinates)
  {
    Vector x;
    std::memcpy(&x, coordinates, sizeof(x));
    this->Lower = x < this->Lower ? x : this->Lower;
    this->Upper = x > this->Upper ? x : this->Upper;
    this->Zero += x * Real(0);
  }
};
}

template <int Dim, typename Real>
std::optional<Box<Dim>> FindFiniteBox(const Real* coordinates, std::size_t count)
{
  // Dim vectors hold the coordinates of Width points as they stand: each lane has always one axis.
  constexpr std::size_t width = LaneExtent<Real>::Width;
  LaneExtent<Real> extents[Dim];
  std::size_t done = 0;
  for (; done + width <= count; done += width)
  {
    for (std::size_t i = 0; i < Dim; ++i)
    {
      extents[i].Add(coordinates + Dim * done + width * i);
    }
  }
  Box<Dim> box;
  double zero = 0.0;
  const auto add = [&box](std::size_t axis, double lower, double upper)
  {
    box.Lower[axis] = std::min(box.Lower[axis], lower);
    box.Upper[axis] = std::max(box.Upper[axis], upper);
  };
  for (std::size_t i = 0; i < Dim * width; ++i)
  {
    const LaneExtent<Real>& extent = extents[i / width];
    add(i % Dim, extent.Lower[i % width], extent.Upper[i % width]);
    zero += static_cast<double>(extent.Zero[i % width]);
  }
  for (std::size_t i = Dim * done; i < Dim * count; ++i)
  {
    const auto x = static_cast<double>(coordinates[i]);
    add(i % Dim, x, x);
    zero += x * 0.0;
  }
  bool isFinite = zero == 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis)
  {
    isFinite = isFinite && box.Lower[axis] >= -Grid<Dim>::MaxCoordinate &&
      box.Upper[axis] <= Grid<Dim>::MaxCoordinate;
  }
  return isFinite ? std::optional<Box<Dim>>(box) : std::nullopt;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template std::optional<Box<Dim>> FindFiniteBox(const float*, std::size_t);                       \
  template std::optional<Box<Dim>> FindFiniteBox(const double*, std::size_t);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
