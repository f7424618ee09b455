// SPDX-License-Identifier: BSD-3-Clause
#include "QueryDepths.h"

#include "DirectBatch.h"
#include "ForEachDimension.h"

#include <algorithm>
#include <array>
#include <functional>

namespace hashedoctree
{
namespace
{
constexpr std::size_t QueriesAtATime = 4096; // That a thread does.
}

template <int Dim, typename Points>
Buffer<MortonKey<Dim>> GetQueryKeys(
  const Grid<Dim>& grid, Points queries, const Execution& execution)
{
  Buffer<MortonKey<Dim>> keys(queries.Count);
  execution.ForChunks(queries.Count, QueriesAtATime,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t begin = first; begin < last; begin += MostKeysAtOnce)
      {
        const std::size_t count = std::min(last - begin, MostKeysAtOnce);
        GetKeys<Dim>(grid, queries, begin, count, &keys[begin]);
        for (std::size_t i = begin; i < begin + count; ++i)
        {
          keys[i] = IsFinite(GetPosition<Dim>(queries, i)) ? keys[i] : MortonKey<Dim>(0);
        }
      }
    });
  return keys;
}

template <int Dim>
DepthHistogram MeasureQueryDepths(
  const Octree<Dim>& tree, KeySpan<Dim> keys, const Execution& execution)
{
  using PerDepth = std::array<std::uint64_t, MortonKey<Dim>::MaxDepth + 1>;
  const int startDepth = GetMedianDepth(tree.GetDepthCounts().Leaves);
  const auto chunks = execution.MapChunks(keys.Count, QueriesAtATime,
    [&](std::size_t first, std::size_t last)
    {
      PerDepth counts{};
      FindLeaves(tree, keys, first, last, startDepth,
        [&counts, keys](std::size_t i, const FoundLeaf<Dim>& leaf)
        {
          const bool isCounted = keys.Keys[i] != MortonKey<Dim>(0);
          counts[static_cast<std::size_t>(leaf.Key.GetDepth())] += isCounted ? 1 : 0;
        });
      return counts;
    });

  DepthHistogram histogram(tree.GetDepthCounts().Leaves.size(), 0);
  for (const PerDepth& counts : chunks)
  {
    std::transform(
      histogram.begin(), histogram.end(), counts.begin(), histogram.begin(), std::plus<>());
  }
  return histogram;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template Buffer<MortonKey<Dim>> GetQueryKeys(                                                    \
    const Grid<Dim>&, PointSpan<Dim, float>, const Execution&);                                    \
  template Buffer<MortonKey<Dim>> GetQueryKeys(                                                    \
    const Grid<Dim>&, PointSpan<Dim, double>, const Execution&);                                   \
  template DepthHistogram MeasureQueryDepths(const Octree<Dim>&, KeySpan<Dim>, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
template Buffer<MortonKey<2>> GetQueryKeys(const Grid<2>&, PlaneSpan<float>, const Execution&);
template Buffer<MortonKey<2>> GetQueryKeys(const Grid<2>&, PlaneSpan<double>, const Execution&);
}
