// SPDX-License-Identifier: BSD-3-Clause
#include "Interleaving.h"

#include "ForEachDimension.h"

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

namespace
{
template <int Dim>
HASHEDOCTREE_WITH_PDEP inline MortonKey<Dim> Deposit(const Cell<Dim>& cell, int depth)
{
  constexpr std::uint64_t lowestAxis = Dilation<Dim>::Mask(1);
  std::uint64_t value = std::uint64_t(1) << (Dim * depth);
  for (int axis = 0; axis < Dim; ++axis)
  {
    value |= _pdep_u64(cell[axis], lowestAxis << (Dim - 1 - axis));
  }
  return MortonKey<Dim>(value);
}
}
#else
bool HasPdep()
{
  return false;
}

const bool PdepIsFastest = false;

namespace
{
template <int Dim>
MortonKey<Dim> Deposit(const Cell<Dim>& cell, int depth)
{
  return MortonKey<Dim>::FromCell(cell, depth);
}
}
#endif

template <int Dim>
HASHEDOCTREE_WITH_PDEP MortonKey<Dim> DepositCell(const Cell<Dim>& cell, int depth)
{
  return Deposit<Dim>(cell, depth);
}

template <int Dim>
HASHEDOCTREE_WITH_PDEP void DepositCells(
  const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    keys[i] = Deposit<Dim>(cells[i], MortonKey<Dim>::MaxDepth);
  }
}

// GCC takes the attribute of an explicit instantiation, not that of the template.
#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template HASHEDOCTREE_WITH_PDEP MortonKey<Dim> DepositCell<Dim>(const Cell<Dim>&, int);          \
  template HASHEDOCTREE_WITH_PDEP void DepositCells<Dim>(                                          \
    const Cell<Dim>*, std::size_t, MortonKey<Dim>*);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
