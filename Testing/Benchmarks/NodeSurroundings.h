// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_NodeSurroundings_h
#define Testing_Benchmarks_NodeSurroundings_h

#include "NodeBall.h"

/** Depth of the smallest cell that holds two cells of a depth. */
template <std::size_t Dim>
int GetCommonDepth(
  const std::array<std::uint32_t, Dim>& a, const std::array<std::uint32_t, Dim>& b, int depth)
{
  std::uint32_t difference = 0;
  for (std::size_t axis = 0; axis < Dim; ++axis)
  {
    difference |= a[axis] ^ b[axis];
  }
  return difference == 0 ? depth : depth - 1 - hashedoctree::HighestBit(difference);
}

/** What touches a node by a face, an edge or a corner. */
template <int Dim>
class NodeSurroundings
{
public:
  using Key = hashedoctree::MortonKey<Dim>;

  NodeSurroundings(const hashedoctree::Cell<Dim>& cell, int depth)
  {
    const int shift = Key::MaxDepth - depth;
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Lower[axis] = cell[axis] << shift;
      this->Upper[axis] = (cell[axis] + 1U) << shift;
    }
  }

  bool Meets(const hashedoctree::Cell<Dim>& cell, int depth) const
  {
    const int shift = Key::MaxDepth - depth;
    bool meets = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      meets &= cell[axis] << shift <= this->Upper[axis];
      meets &= (cell[axis] + 1U) << shift >= this->Lower[axis];
    }
    return meets;
  }

  /** Depth of the smallest cell that holds all of it that is in the root. */
  int GetHoldingDepth() const
  {
    hashedoctree::Cell<Dim> first;
    hashedoctree::Cell<Dim> last;
    for (int axis = 0; axis < Dim; ++axis)
    {
      first[axis] = std::max(this->Lower[axis], 1U) - 1U;
      last[axis] = std::min(this->Upper[axis], (1U << Key::MaxDepth) - 1U);
    }
    return GetCommonDepth(first, last, Key::MaxDepth);
  }

private:
  hashedoctree::Cell<Dim> Lower; ///< In cells of MaxDepth.
  hashedoctree::Cell<Dim> Upper;
};

/** What meets a ball around the center of a node, as NodeBall.h says. */
template <int Dim>
class BallSurroundings
{
public:
  BallSurroundings(
    const hashedoctree::Grid<Dim>& grid, hashedoctree::MortonKey<Dim> node, double radius)
    : Ball(grid, node, radius)
  {
  }

  bool Meets(const hashedoctree::Cell<Dim>& cell, int depth) const
  {
    return this->Ball.Meets(cell, depth);
  }

  /** Depth of the smallest cell that holds all of it that is in the root. */
  int GetHoldingDepth() const
  {
    const auto cover = this->Ball.GetCover();
    return GetCommonDepth(cover.Lower, cover.Upper, cover.Depth);
  }

private:
  hashedoctree::NodeBall<Dim> Ball;
};

#endif
