// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_FiniteBox_h
#define hashedoctree_FiniteBox_h

#include "Grid.h"

#include <cstddef>
#include <optional>

namespace hashedoctree
{
/**
 * The box around `count` points, at least one, whose coordinates stand one point after the other;
 * none if a coordinate is not a number, infinite, or beyond Grid::MaxCoordinate. O(count), in
 * vectors. Thread safe. Instantiated for float and double.
 */
template <int Dim, typename Real>
std::optional<Box<Dim>> FindFiniteBox(const Real* coordinates, std::size_t count);
}

#endif
