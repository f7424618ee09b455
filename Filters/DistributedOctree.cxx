// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedOctree.h"

#include "CurveDivision.h"
#include "DistinctKeys.h"
#include "RangeDepths.h"

#include <map>
#include <utility>

namespace hashedoctree
{
namespace
{
/** Shares of the progress: where each step ends. The rest is for counting. */
constexpr double DealingShare = 0.2;
constexpr double MergingShare = 0.3;
constexpr double TreeShare = 0.9;

template <int Dim>
CurveDivision<Dim> DivideCurve(
  const ProcessGroup& processes, const std::vector<MortonKey<Dim>>& keys, int maxDepth)
{
  const std::uint64_t all = processes.Sum(keys.size());
  const std::size_t number = processes.GetNumberOfProcesses();
  RequirePointIndices(all);
  const auto sample = CurveDivision<Dim>::Sample(keys, all, number);
  return CurveDivision<Dim>(processes.Gather(sample).Values, number, maxDepth);
}

/** The keys of this process's part, given those of its points. */
template <int Dim>
std::vector<MortonKey<Dim>> SendToParts(const ProcessGroup& processes,
  const CurveDivision<Dim>& division, std::vector<MortonKey<Dim>> keys)
{
  const Parted<MortonKey<Dim>> dealt = division.Deal(keys);
  std::vector<MortonKey<Dim>>().swap(keys); // They are many.
  return processes.Exchange(dealt).Values;
}

/** Adds to the keys of this process's part those on both sides of it. */
template <int Dim>
void AddOverlap(
  const ProcessGroup& processes, std::vector<MortonKey<Dim>>& keys, std::size_t overlap)
{
  std::vector<std::uint64_t> points(processes.GetNumberOfProcesses(), 0);
  points[processes.GetRank()] = keys.size();
  processes.Sum(points);
  const auto around =
    processes.Exchange(CurveDivision<Dim>::GetOverlaps(processes.GetRank(), keys, points, overlap));
  keys.insert(keys.end(), around.Values.begin(), around.Values.end());
}

/** Adds up what each process has counted, down to the deepest leaf of all. */
DepthHistogram Sum(const ProcessGroup& processes, DepthHistogram histogram, std::size_t depths)
{
  histogram.resize(depths);
  processes.Sum(histogram);
  return histogram;
}

DepthCounts SumCounts(const ProcessGroup& processes, const DepthCounts& counts)
{
  const auto ofAll = static_cast<std::size_t>(processes.Max(counts.Leaves.size()));
  return { Sum(processes, counts.Leaves, ofAll), Sum(processes, counts.EmptyLeaves, ofAll),
    Sum(processes, counts.Points, ofAll) };
}

/** The points of all processes in the nodes that are in several parts. */
template <int Dim>
std::map<std::uint64_t, PointIndex> CountPointsAcross(const ProcessGroup& processes,
  const CurveDivision<Dim>& division, const std::vector<MortonKey<Dim>>& ownKeys)
{
  std::vector<std::uint64_t> counts = division.CountInNodesAcross(processes.GetRank(), ownKeys);
  processes.Sum(counts);
  std::map<std::uint64_t, PointIndex> points;
  std::size_t i = 0;
  for (const MortonKey<Dim> node : division.GetNodesAcross())
  {
    points[node.GetValue()] = static_cast<PointIndex>(counts[i++]);
  }
  return points;
}
}

template <int Dim>
PointsOctree<Dim> BuildDistributedOctree(const ProcessGroup& processes, const Grid<Dim>& grid,
  std::vector<MortonKey<Dim>> keys, bool merge, const typename Octree<Dim>::Options& options,
  const Execution& execution)
{
  PointsOctree<Dim> octree;
  octree.Processes = processes;
  octree.Division = DivideCurve(processes, keys, options.MaxDepth);
  const CurveDivision<Dim>& division = octree.Division;
  octree.Range = division.GetRange(processes.GetRank());
  keys = SendToParts(processes, division, std::move(keys));
  if (merge) // Equal ones are in one part.
  {
    keys = GetDistinctKeys(keys, execution.Part(DealingShare, MergingShare));
  }
  octree.PointsAcross = CountPointsAcross(processes, division, keys);
  AddOverlap(processes, keys, CurveDivision<Dim>::GetOverlapSize(options.MaxPointsPerLeaf));
  octree.Tree = Octree<Dim>(grid, keys, options, execution.Part(MergingShare, TreeShare));
  octree.Counts =
    SumCounts(processes, CountDepths(octree.Tree, octree.Range, execution.Part(TreeShare, 1.0)));
  octree.TreeBytes = processes.Sum(octree.Tree.GetTreeBytes());
  return octree;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template PointsOctree<Dim> BuildDistributedOctree(const ProcessGroup&, const Grid<Dim>&,         \
    std::vector<MortonKey<Dim>>, bool, const Octree<Dim>::Options&, const Execution&);
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
#undef HASHEDOCTREE_INSTANTIATE
}
