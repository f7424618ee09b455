// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeIndex_h
#define hashedoctree_NodeIndex_h

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace hashedoctree
{
/** Internal nodes are numbered by 32 bits, whatever points are numbered by: so many octree nodes
 * take more than 200 gigabytes. */
constexpr std::size_t MaxNumberOfInternalNodes = std::numeric_limits<std::uint32_t>::max();

/** Throws std::length_error, with what to tell the user, for more nodes than can be numbered. */
inline void RequireNodeIndices(std::size_t internalNodes)
{
  if (internalNodes > MaxNumberOfInternalNodes)
  {
    throw std::length_error("The tree would have more nodes than 32 bits can number; allow more "
                            "points per leaf or less depth.");
  }
}
}

#endif
