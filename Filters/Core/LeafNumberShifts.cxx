// SPDX-License-Identifier: BSD-3-Clause
#include "LeafNumberShifts.h"

#include "ForEachDimension.h"
#include "RangeDepths.h"

namespace hashedoctree
{
DepthHistogram CountNumberedLeaves(const DepthCounts& counts, EmptyOctants reading)
{
  DepthHistogram numbered = counts.Leaves;
  for (std::size_t depth = 0; depth < numbered.size() && reading == EmptyOctants::Missing; ++depth)
  {
    numbered[depth] -= counts.EmptyLeaves[depth];
  }
  return numbered;
}

template <int Dim>
std::vector<std::int64_t> FindLeafNumberShifts(const Octree<Dim>& tree,
  const CurveRange<Dim>& range, const DepthCounts& counts, const DepthHistogram& before,
  EmptyOctants reading, const Execution& execution)
{
  CurveRange<Dim> rangeBefore;
  rangeBefore.Last = MortonKey<Dim>(range.First.GetValue() - 1);
  const DepthHistogram all = CountNumberedLeaves(counts, reading);
  DepthHistogram here = CountNumberedLeaves(tree.GetDepthCounts(), reading);
  DepthHistogram hereBefore =
    CountNumberedLeaves(CountDepths(tree, rangeBefore, execution), reading);
  here.resize(all.size());
  hereBefore.resize(all.size());

  std::vector<std::int64_t> shifts(all.size(), 0);
  std::uint64_t difference = 0; // Of the leaves higher up, modulo 2^64.
  for (std::size_t depth = 0; depth < all.size(); ++depth)
  {
    shifts[depth] = static_cast<std::int64_t>(difference + before[depth] - hereBefore[depth]);
    difference += all[depth] - here[depth];
  }
  return shifts;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template std::vector<std::int64_t> FindLeafNumberShifts(const Octree<Dim>&,                      \
    const CurveRange<Dim>&, const DepthCounts&, const DepthHistogram&, EmptyOctants,               \
    const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
