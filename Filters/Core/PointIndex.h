// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointIndex_h
#define hashedoctree_PointIndex_h

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace hashedoctree
{
/** The id of a point, or its place in Morton order. 32 bits, which are half the memory and enough
 * for what one machine mostly holds; 64 in a build with HASHEDOCTREE_64BIT_IDS. */
#ifdef HASHEDOCTREE_64BIT_IDS
using PointIndex = std::uint64_t;
#else
using PointIndex = std::uint32_t;
#endif

/** More points than this cannot be numbered: the greatest index stands for none, also where a range
 * of points ends. */
constexpr std::size_t MaxNumberOfPoints = std::numeric_limits<PointIndex>::max() - 1;

/** Throws std::length_error, with what to tell the user, for more points than can be numbered. */
inline void RequirePointIndices(std::size_t numberOfPoints)
{
  if (numberOfPoints > MaxNumberOfPoints)
  {
    throw std::length_error("There are more points than 32 bits can number; split the data set, or "
                            "build with HASHEDOCTREE_64BIT_IDS.");
  }
}
}

#endif
