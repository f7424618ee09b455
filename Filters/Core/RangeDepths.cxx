// SPDX-License-Identifier: BSD-3-Clause
#include "RangeDepths.h"

#include "DepthTally.h"
#include "ForEachDimension.h"

namespace hashedoctree
{
template <int Dim>
DepthCounts CountDepths(
  const Octree<Dim>& tree, const CurveRange<Dim>& range, const Execution& execution)
{
  constexpr std::size_t chunkSize = 2048; // Blocks that a thread does at a time.
  using Node = typename Octree<Dim>::Node;
  const auto add = [&range](const Node& node, DepthTally<Dim>& tally)
  {
    if (!node.Internal && range.Has(node.NodeKey))
    {
      tally.AddLeaf(node.NodeKey.GetDepth(), node.GetNumberOfPoints());
    }
  };
  const auto tallies = execution.MapChunks(tree.GetNumberOfInternalNodes(), chunkSize,
    [&](std::size_t first, std::size_t last)
    {
      DepthTally<Dim> tally;
      tree.ForEachChild(first, last, [&](const Node& child) { add(child, tally); });
      return tally;
    });
  DepthTally<Dim> all;
  add(tree.GetRoot(), all);
  for (const DepthTally<Dim>& tally : tallies)
  {
    all.Add(tally);
  }
  return all.GetCounts();
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template DepthCounts CountDepths(const Octree<Dim>&, const CurveRange<Dim>&, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
