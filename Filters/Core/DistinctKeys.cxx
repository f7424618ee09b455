// SPDX-License-Identifier: BSD-3-Clause
#include "DistinctKeys.h"

#include "KeyedPoints.h"
#include "MortonOrder.h"

namespace hashedoctree
{
template <int Dim>
std::vector<MortonKey<Dim>> GetDistinctKeys(
  const std::vector<MortonKey<Dim>>& keys, const Execution& execution)
{
  constexpr std::size_t ofEachLeaf = 1; // Sorts by all of the key.
  Buffer<KeyedPoint<Dim>> sorted = NumberKeys(keys);
  SortAlongMortonCurve(sorted, ofEachLeaf, MortonKey<Dim>::MaxDepth, execution);
  std::vector<MortonKey<Dim>> distinct;
  for (std::size_t i = 0; i < sorted.GetSize(); ++i)
  {
    if (distinct.empty() || distinct.back() != sorted[i].GetKey())
    {
      distinct.push_back(sorted[i].GetKey());
    }
  }
  return distinct;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template std::vector<MortonKey<Dim>> GetDistinctKeys(                                            \
    const std::vector<MortonKey<Dim>>&, const Execution&);
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
