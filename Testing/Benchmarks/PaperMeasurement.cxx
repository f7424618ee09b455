// SPDX-License-Identifier: BSD-3-Clause
#include "PaperMeasurement.h"

#include "DepthDecisionTree.h"
#include "DirectSearch.h"
#include "PaperAnswers.h"
#include "PaperBatch.h"
#include "PaperFrequencyCosts.h"
#include "PaperKeys.h"
#include "PaperNeighborStarts.h"
#include "PaperWorkloads.h"
#include "StartDepths.h"

#include <algorithm>
#include <functional>
#include <random>

namespace paper_benchmark
{
namespace
{
using hashedoctree::DepthHistogram;
using hashedoctree::Execution;
using hashedoctree::FrequencyModel;
using hashedoctree::Octree;
using hashedoctree::PointSpan;
using Selection = hashedoctree::PointSelection<3>;

/** Builds all structures again and again; the last of each stay. The others share the points that
 * are sorted before; sorting them anew takes its turn, too, and counts for each of them. */
void MeasureBuilds(const std::vector<float>& points, int repetitions, PaperTrees& trees,
  std::unique_ptr<SortedPoints<3>>& sorted, PaperResults& results)
{
  const PointSpan<3, float> span{ points.data(), points.size() / 3 };
  const auto buildOurs = [&]
  { trees.Ours = Octree<3>(span, Selection(span, {}, Execution()), {}, Execution()); };
  const auto sort = [&span]
  { return std::make_unique<SortedPoints<3>>(span, Selection(span, {}, Execution()), 1); };
  const auto build = [&sorted](auto& tree, const auto&... hash)
  {
    using Tree = std::remove_const_t<typename std::decay_t<decltype(tree)>::element_type>;
    tree.reset();
    return GetSeconds([&] { tree = std::make_unique<const Tree>(*sorted, hash...); });
  };
  buildOurs();
  const hashedoctree::MixingHash mixing(trees.Ours.GetNumberOfNodes() / 2);
  sorted = sort();
  const auto sortAnew = [&sort]
  {
    std::unique_ptr<SortedPoints<3>> anew;
    return GetSeconds([&] { anew = sort(); });
  };
  std::vector<std::vector<double>> seconds = MeasureInTurns(
    { [&] { return build(trees.Pointers); }, [&] { return build(trees.BrotherChild); },
      [&] { return build(trees.WithParents); }, [&] { return build(trees.Paper, GetPaperHash()); },
      [&] { return build(trees.PaperMixing, mixing); },
      [&]
      {
        trees.Ours = Octree<3>();
        return GetSeconds(buildOurs);
      },
      sortAnew },
    1, repetitions);
  for (std::size_t i = 0; i < NumberOfStructures; ++i)
  {
    std::vector<double>& times = seconds[i];
    if (i != OursBuilt)
    {
      const std::vector<double>& sorting = seconds.back();
      std::transform(times.begin(), times.end(), sorting.begin(), times.begin(), std::plus<>());
    }
    results.Builds[i] = GetSpread(times);
  }
  results.Bytes = { trees.Pointers->GetBytes(), trees.BrotherChild->GetBytes(),
    trees.WithParents->GetBytes(), trees.Paper->GetBytes(), trees.PaperMixing->GetBytes(),
    trees.Ours.GetTreeBytes() };
}

void DescribeTree(const Octree<3>& tree, PaperResults& results)
{
  const DepthHistogram& leaves = tree.GetDepthCounts().Leaves;
  results.Points = tree.GetNumberOfPoints();
  results.Nodes = tree.GetNumberOfNodes();
  results.Leaves = tree.GetNumberOfLeaves();
  results.DeepestDepth = tree.GetDeepestDepth();
  results.StartDepth = hashedoctree::GetMedianDepth(leaves);
  double sum = 0.0;
  double sum2 = 0.0;
  for (std::size_t depth = 0; depth < leaves.size(); ++depth)
  {
    const double share = static_cast<double>(leaves[depth]) / static_cast<double>(results.Leaves);
    sum += share * static_cast<double>(depth);
    sum2 += share * static_cast<double>(depth * depth);
  }
  results.DepthDeviation = std::sqrt(std::max(sum2 - sum * sum, 0.0));
}

void MeasureOptimisation(const PaperTrees& trees, int repetitions, PaperResults& results)
{
  using hashedoctree::GetMedianDepth;
  bool agree = true;
  const auto time = [&agree, &results, repetitions](const auto& getDepth, std::size_t times)
  {
    const auto run = [&]
    {
      for (std::size_t i = 0; i < times; ++i)
      {
        agree &= getDepth() == results.StartDepth;
      }
    };
    return TimeInTurns({ [&] { return GetSeconds(run); } }, times, repetitions).front();
  };
  const auto getDepthOfPaper = [&] { return GetMedianDepth(trees.Paper->CountLeaves()); };
  const auto getDepthOfOurs = [&]
  {
    return GetMedianDepth(
      hashedoctree::GetDepthHistogram(trees.Ours.GetDepthCounts(), FrequencyModel::Leaves, 3));
  };
  results.PaperOptimise = time(getDepthOfPaper, 1);
  results.OurOptimise = time(getDepthOfOurs, 1000); // To read the clock takes as long as one.
  ++results.CheckedAnswers;
  results.DifferentAnswers += agree ? 0 : 1;
}

ModelCosts GetModelCosts(const Octree<3>& tree)
{
  using hashedoctree::GetMeanCost;
  const DepthHistogram& leaves = tree.GetDepthCounts().Leaves;
  const hashedoctree::StartDepths<3> local(
    tree, { hashedoctree::StartDepthModel::Local, FrequencyModel::Leaves, 0 });
  return { GetMeanCost(leaves, 0), GetMeanCost(leaves, hashedoctree::GetMedianDepth(leaves)),
    GetMeanCost(leaves, hashedoctree::GetMeanDepth(leaves)),
    local.GetMeanCost(tree, FrequencyModel::Leaves),
    hashedoctree::DepthDecisionTree(leaves).GetMeanCost(), hashedoctree::GetEntropyBound(leaves) };
}

/** The leaves of points, each point equally likely. */
std::vector<Key> SampleLeaves(const Octree<3>& tree, const std::vector<float>& points)
{
  std::mt19937_64 random(2008);
  std::vector<Key> leaves;
  while (leaves.size() < NumberOfNeighborSearches)
  {
    const Key key = tree.GetGrid().GetKey(&points[3 * (random() % (points.size() / 3))]);
    leaves.push_back(FindLeaf(tree, key, tree.GetDeepestDepth()).Key);
  }
  return leaves;
}

void MeasureSearches(const PaperPeers& peers, const std::vector<float>& points, double radius,
  int repetitions, PaperResults& results)
{
  std::uint64_t sum = 0;
  for (std::size_t kind = 0; kind < NumberOfKinds; ++kind)
  {
    std::vector<std::function<double()>> runs;
    for (const auto& peer : peers)
    {
      runs.emplace_back(
        [&points, &sum, &asked = *peer, kind, radius]
        {
          return GetSeconds(
            [&]
            {
              sum += kind == Direct ? asked.FindLeaves(points)
                : kind == Adjacent  ? asked.FindAdjacent()
                                    : asked.FindInRadius(radius);
            });
        });
    }
    const std::size_t searches = kind == Direct ? results.Points : NumberOfNeighborSearches;
    const std::vector<Spread> times = TimeInTurns(runs, searches, repetitions);
    std::copy(times.begin(), times.end(), results.Times[kind].begin());
  }
}
}

PaperResults MeasureSet(const PaperSet& set, const std::vector<float>& points, int repetitions)
{
  PaperResults results;
  results.Set = set;
  std::unique_ptr<SortedPoints<3>> sorted;
  PaperTrees trees;
  MeasureBuilds(points, repetitions, trees, sorted, results);
  DescribeTree(trees.Ours, results);
  MeasureOptimisation(trees, repetitions, results);
  results.Costs = GetModelCosts(trees.Ours);
  CountFrequencyCosts(trees.Ours, results);

  const PaperPeers peers = MakePeers(trees, results.StartDepth);
  const std::vector<Key> leaves = SampleLeaves(trees.Ours, points);
  for (const auto& peer : peers)
  {
    peer->SetLeaves(leaves);
  }
  const double radius = trees.Ours.GetGrid().GetSide(results.StartDepth);
  CheckAnswers(peers, points, radius, results);
  MeasureSearches(peers, points, radius, repetitions, results);
  MeasureBatch(trees.Ours, points, repetitions, results);
  MeasureWorkloads(trees, points, repetitions, results);
  MeasureNeighborStarts(trees, leaves, radius, repetitions, results);
  MeasureKeys(trees, points, repetitions, results);
  return results;
}
}
