// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_ChildBoxes_h
#define hashedoctree_ChildBoxes_h

#include "MortonKey.h"

#include <cstdint>

namespace hashedoctree
{
/**
 * The tight boxes of the children of one block, in 256 steps along each side of the block's cell
 * and rounded outwards. `Lower` and `Upper` name the first and the last step that a child's points
 * touch. The boxes of children without points have no meaning.
 */
template <int Dim>
struct ChildBoxes
{
  static constexpr int Steps = 256;

  std::uint8_t Lower[Dim][MortonKey<Dim>::NumberOfOctants];
  std::uint8_t Upper[Dim][MortonKey<Dim>::NumberOfOctants];
};
}

#endif
