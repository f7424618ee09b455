// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NeighborDirection_h
#define hashedoctree_NeighborDirection_h

#include "Octree.h"

#include <array>

namespace hashedoctree
{
/**
 * The lookup table of the adjacent search (paper section 3b, Fig. 5b): for each direction to a
 * neighbour, the children of that neighbour that touch the node it is a neighbour of. At index
 * axes << Dim | upper, see NeighborDirection; nothing where there is no such direction.
 */
template <int Dim>
constexpr std::array<OctantMask<Dim>, std::size_t(1) << (2 * Dim)> MakeTouchingOctants()
{
  constexpr unsigned numberOfOctants = 1U << Dim;
  std::array<OctantMask<Dim>, std::size_t(1) << (2 * Dim)> table{};
  for (unsigned axes = 0; axes < numberOfOctants; ++axes)
  {
    for (unsigned upper = 0; upper < numberOfOctants; ++upper)
    {
      for (unsigned octant = 0; octant < numberOfOctants; ++octant)
      {
        // A neighbour above touches with its lower half, one below with its upper half.
        if ((upper & ~axes) == 0 && (octant & axes) == (axes & ~upper))
        {
          table[axes << Dim | upper] |= static_cast<OctantMask<Dim>>(1U << octant);
        }
      }
    }
  }
  return table;
}

/**
 * A direction from a node to one of the 3^Dim - 1 cells of its own size around it: along some of
 * the axes one step, up or down. An axis has the bit that it has in an octant, the first one the
 * high bit. Without axes it leads to the node itself.
 */
template <int Dim>
struct NeighborDirection
{
  unsigned Axes;  ///< Along which it steps: one across a face, Dim across a corner.
  unsigned Upper; ///< Those of the axes along which it steps up.

  /** The children of the neighbour that touch the node, 2^(Dim - number of axes) of them: in 3D
   * four across a face, two across an edge, one across a corner. All of them without axes. */
  constexpr OctantMask<Dim> GetTouchingOctants() const
  {
    return Table[this->Axes << Dim | this->Upper];
  }

private:
  static constexpr auto Table = MakeTouchingOctants<Dim>();
};
}

#endif
