// SPDX-License-Identifier: BSD-3-Clause
#include "Interleaving.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define HASHEDOCTREE_WITH_PDEP __attribute__((target("bmi2")))
#else
#define HASHEDOCTREE_WITH_PDEP
#endif

namespace hashedoctree
{
#if defined(__x86_64__)
bool HasPdep()
{
  __builtin_cpu_init(); // This may be before main().
  return __builtin_cpu_supports("bmi2") != 0;
}

const bool PdepIsFastest = HasPdep() && !__builtin_cpu_is("znver1") &&
  !__builtin_cpu_is("znver2") && !__builtin_cpu_is("bdver4");

template <int Dim>
HASHEDOCTREE_WITH_PDEP MortonKey<Dim> DepositCell(const Cell<Dim>& cell, int depth)
{
  constexpr std::uint64_t lowestAxis = Dilation<Dim>::Mask(1);
  std::uint64_t value = std::uint64_t(1) << (Dim * depth);
  for (int axis = 0; axis < Dim; ++axis)
  {
    value |= _pdep_u64(cell[axis], lowestAxis << (Dim - 1 - axis));
  }
  return MortonKey<Dim>(value);
}
#else
bool HasPdep()
{
  return false;
}

const bool PdepIsFastest = false;

template <int Dim>
MortonKey<Dim> DepositCell(const Cell<Dim>& cell, int depth)
{
  return MortonKey<Dim>::FromCell(cell, depth);
}
#endif

// GCC takes the attribute of an explicit instantiation, not that of the template.
template HASHEDOCTREE_WITH_PDEP MortonKey<1> DepositCell<1>(const Cell<1>&, int);
template HASHEDOCTREE_WITH_PDEP MortonKey<2> DepositCell<2>(const Cell<2>&, int);
template HASHEDOCTREE_WITH_PDEP MortonKey<3> DepositCell<3>(const Cell<3>&, int);
template HASHEDOCTREE_WITH_PDEP MortonKey<4> DepositCell<4>(const Cell<4>&, int);
}
