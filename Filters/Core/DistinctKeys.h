// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DistinctKeys_h
#define hashedoctree_DistinctKeys_h

#include "Execution.h"
#include "MortonKey.h"

#include <vector>

namespace hashedoctree
{
/** Each of some keys at MaxDepth once, along the Morton curve: what is left of points that count
 * once where they are in the same cell. O(n). Throws Interrupted. */
template <int Dim>
std::vector<MortonKey<Dim>> GetDistinctKeys(
  const std::vector<MortonKey<Dim>>& keys, const Execution& execution);
}

#endif
