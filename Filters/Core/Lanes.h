// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Lanes_h
#define hashedoctree_Lanes_h

#include <cstddef>

// Always inlined, so that each caller compiles it for its own machine.
#define HASHEDOCTREE_INLINE __attribute__((always_inline)) inline

namespace hashedoctree
{
/** So many of a kind, in vector registers where the machine has them. Private to sources that are
 * compiled for several machines. */
template <typename T, std::size_t Number>
using Lanes __attribute__((vector_size(Number * sizeof(T)))) = T;
}

#endif
