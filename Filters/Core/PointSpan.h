// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointSpan_h
#define hashedoctree_PointSpan_h

#include "Grid.h"

#include <algorithm>
#include <cstddef>

namespace hashedoctree
{
/** A view of `Count` points, Dim coordinates each, one point after the other. */
template <int Dim, typename Real>
struct PointSpan
{
  const Real* Coordinates = nullptr;
  std::size_t Count = 0;

  const Real* operator[](std::size_t i) const { return this->Coordinates + Dim * i; }
};

/** Point i of a span, in double precision. */
template <int Dim, typename Points>
Position<Dim> GetPosition(const Points& points, std::size_t i)
{
  const auto x = points[i];
  Position<Dim> position;
  std::copy_n(&x[0], Dim, position.begin());
  return position;
}
}

#endif
