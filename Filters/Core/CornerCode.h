// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_CornerCode_h
#define hashedoctree_CornerCode_h

#include "MortonKey.h"

#include <cstdint>

namespace hashedoctree
{
/** Corners on one axis of the grid of MaxDepth. */
template <int Dim>
constexpr std::uint64_t CornerCodeBase = (std::uint64_t(1) << MortonKey<Dim>::MaxDepth) + 1;

/** A corner of the grid of MaxDepth, each coordinate in [0, 2^MaxDepth], as one number: its
 * coordinates are the digits, and 1 is added, so that no code is 0. */
template <int Dim>
std::uint64_t EncodeCorner(const Cell<Dim>& corner)
{
  std::uint64_t code = 0;
  for (const std::uint32_t coordinate : corner)
  {
    code = code * CornerCodeBase<Dim> + coordinate;
  }
  return code + 1;
}

/** The corner that a code names. */
template <int Dim>
Cell<Dim> DecodeCorner(std::uint64_t code)
{
  Cell<Dim> corner;
  --code;
  for (int axis = Dim - 1; axis >= 0; --axis)
  {
    corner[axis] = static_cast<std::uint32_t>(code % CornerCodeBase<Dim>);
    code /= CornerCodeBase<Dim>;
  }
  return corner;
}
}

#endif
