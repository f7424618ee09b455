// SPDX-License-Identifier: BSD-3-Clause
#include "DistinctKeys.h"

#include "ForEachDimension.h"
#include "KeyedPoints.h"
#include "MortonOrder.h"

namespace hashedoctree
{
template <int Dim>
std::vector<MortonKey<Dim>> GetDistinctKeys(
  const std::vector<MortonKey<Dim>>& keys, const Execution& execution)
{
  constexpr double numberingShare = 0.1; // Of the progress: where each step ends.
  constexpr double sortingShare = 0.8;
  constexpr std::size_t grain = 4096;   // Keys between looks whether to go on.
  constexpr std::size_t ofEachLeaf = 1; // Sorts by all of the key.
  Buffer<KeyedPoint<Dim>> sorted = NumberKeys(keys, execution.Part(0.0, numberingShare));
  SortAlongMortonCurve(
    sorted, ofEachLeaf, MortonKey<Dim>::MaxDepth, execution.Part(numberingShare, sortingShare));
  std::vector<MortonKey<Dim>> distinct;
  distinct.reserve(keys.size());
  execution.Part(sortingShare, 1.0)
    .OnOneThread()
    .ForEach(sorted.GetSize(), grain,
      [&](std::size_t i)
      {
        if (i == 0 || distinct.back() != sorted[i].GetKey())
        {
          distinct.push_back(sorted[i].GetKey());
        }
      });
  return distinct;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template std::vector<MortonKey<Dim>> GetDistinctKeys(                                            \
    const std::vector<MortonKey<Dim>>&, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
