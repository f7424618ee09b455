// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Lanes_h
#define hashedoctree_Lanes_h

#include <cstddef>

// Always inlined, so that each caller compiles it for its own machine.
#define HASHEDOCTREE_INLINE __attribute__((always_inline)) inline

// Compiled for machines with AVX2, the fused products and the bit instructions that came with it,
// and not to be called on others; elsewhere for the plain machine.
#if defined(__x86_64__)
#define HASHEDOCTREE_WITH_AVX2 __attribute__((target("avx2,fma,bmi,bmi2")))
#else
#define HASHEDOCTREE_WITH_AVX2
#endif

namespace hashedoctree
{
/** So many of a kind, in vector registers where the machine has them. */
template <typename T, std::size_t Number>
using Lanes __attribute__((vector_size(Number * sizeof(T)))) = T;

/** What the one of two functions of the same name is compiled for: every machine. */
struct PlainMachine
{
};
/** And the other: a machine with AVX2. Only where __x86_64__ is defined. */
struct Avx2Machine
{
};

/** Whether the machine has AVX2, and what came with it. */
inline bool HasAvx2()
{
#if defined(__x86_64__)
  static const bool hasAvx2 = __builtin_cpu_supports("avx2") != 0 &&
    __builtin_cpu_supports("fma") != 0 && __builtin_cpu_supports("bmi") != 0 &&
    __builtin_cpu_supports("bmi2") != 0;
  return hasAvx2;
#else
  return false;
#endif
}
}

#endif
