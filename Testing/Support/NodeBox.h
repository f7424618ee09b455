// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_NodeBox_h
#define Testing_Support_NodeBox_h

#include "MortonKey.h"

#include <array>
#include <cstdint>

/** The closed cell of a node in cells of MaxDepth, read from its key bit by bit. */
template <int Dim>
struct NodeBox
{
  std::array<std::int64_t, Dim> Lower{};
  std::array<std::int64_t, Dim> Upper{};
  int Depth = 0;

  explicit NodeBox(hashedoctree::MortonKey<Dim> key)
  {
    int axis = Dim;
    for (std::uint64_t rest = key.GetValue(); rest != 1; rest >>= 1)
    {
      --axis;
      this->Lower[axis] += static_cast<std::int64_t>(rest & 1U) << this->Depth;
      if (axis == 0)
      {
        axis = Dim;
        ++this->Depth;
      }
    }
    const int shift = hashedoctree::MortonKey<Dim>::MaxDepth - this->Depth;
    for (axis = 0; axis < Dim; ++axis)
    {
      this->Upper[axis] = (this->Lower[axis] + 1) << shift;
      this->Lower[axis] <<= shift;
    }
  }

  /** Whether the closed boxes have a point in common. */
  bool Touches(const NodeBox& other) const
  {
    bool touches = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      touches =
        touches && this->Lower[axis] <= other.Upper[axis] && other.Lower[axis] <= this->Upper[axis];
    }
    return touches;
  }

  bool Contains(const NodeBox& other) const
  {
    bool contains = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      contains = contains && this->Lower[axis] <= other.Lower[axis] &&
        other.Upper[axis] <= this->Upper[axis];
    }
    return contains;
  }
};

#endif
