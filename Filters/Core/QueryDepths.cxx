// SPDX-License-Identifier: BSD-3-Clause
#include "QueryDepths.h"

#include "DirectBatch.h"
#include "PlaneSpan.h"

namespace hashedoctree
{
template <int Dim, typename Points>
DepthHistogram MeasureQueryDepths(
  const Octree<Dim>& tree, Points queries, const Execution& execution)
{
  constexpr std::size_t chunkSize = 4096; // Positions that a thread does at a time.
  using PerDepth = std::array<std::uint64_t, MortonKey<Dim>::MaxDepth + 1>;
  const int startDepth = GetMedianDepth(tree.GetDepthCounts().Leaves);
  const auto chunks = execution.MapChunks(queries.Count, chunkSize,
    [&](std::size_t first, std::size_t last)
    {
      PerDepth counts{};
      FindLeaves(
        tree, queries, first, last, [startDepth](MortonKey<Dim>) { return startDepth; },
        [&counts, &queries](std::size_t i, const FoundLeaf<Dim>& leaf)
        {
          const bool counted = IsFinite(GetPosition<Dim>(queries, i));
          counts[static_cast<std::size_t>(leaf.Key.GetDepth())] += counted ? 1 : 0;
        });
      return counts;
    });

  DepthHistogram histogram(tree.GetDepthCounts().Leaves.size(), 0);
  for (const PerDepth& counts : chunks)
  {
    for (std::size_t depth = 0; depth < histogram.size(); ++depth)
    {
      histogram[depth] += counts[depth];
    }
  }
  return histogram;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template DepthHistogram MeasureQueryDepths(                                                      \
    const Octree<Dim>&, PointSpan<Dim, float>, const Execution&);                                  \
  template DepthHistogram MeasureQueryDepths(                                                      \
    const Octree<Dim>&, PointSpan<Dim, double>, const Execution&);
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
template DepthHistogram MeasureQueryDepths(const Octree<2>&, PlaneSpan<float>, const Execution&);
template DepthHistogram MeasureQueryDepths(const Octree<2>&, PlaneSpan<double>, const Execution&);
}
