// SPDX-License-Identifier: BSD-3-Clause
#include "PaperFrequencyCosts.h"

#include "DirectSearch.h"
#include "ForEachNode.h"

#include <cmath>

namespace paper_benchmark
{
namespace
{
using hashedoctree::FrequencyModel;
using hashedoctree::Octree;

/** How often a leaf is searched for, up to a factor. */
double GetWeight(FrequencyModel model, const Octree<3>::Node& leaf)
{
  switch (model)
  {
    case FrequencyModel::Points:
      return static_cast<double>(leaf.GetNumberOfPoints());
    case FrequencyModel::Grid:
      return std::ldexp(1.0, -3 * leaf.NodeKey.GetDepth());
    default:
      return 1.0;
  }
}

/** Sums of nodes that searches examine, and how many searches these are. */
struct Sums
{
  double Weight = 0.0;
  double Root = 0.0;
  std::array<double, NumberOfModels> Medians{};
};

std::array<Sums, NumberOfModels> SearchForLeaves(
  const Octree<3>& tree, const std::array<FrequencyCosts, NumberOfModels>& startDepths)
{
  std::array<Sums, NumberOfModels> sums;
  ForEachLeaf(tree,
    [&](const Octree<3>::Node& leaf)
    {
      const Key key = leaf.NodeKey.GetFirstAtMaxDepth();
      const auto root = static_cast<double>(hashedoctree::CountExaminedNodes(tree, key, 0));
      std::array<double, NumberOfModels> medians{};
      for (std::size_t i = 0; i < NumberOfModels; ++i)
      {
        medians[i] = static_cast<double>(
          hashedoctree::CountExaminedNodes(tree, key, startDepths[i].StartDepth));
      }
      for (std::size_t model = 0; model < NumberOfModels; ++model)
      {
        const double weight = GetWeight(FrequencyModels[model], leaf);
        sums[model].Weight += weight;
        sums[model].Root += weight * root;
        for (std::size_t i = 0; i < NumberOfModels; ++i)
        {
          sums[model].Medians[i] += weight * medians[i];
        }
      }
    });
  return sums;
}
}

void CountFrequencyCosts(const Octree<3>& tree, PaperResults& results)
{
  std::array<hashedoctree::DepthHistogram, NumberOfModels> histograms;
  for (std::size_t model = 0; model < NumberOfModels; ++model)
  {
    histograms[model] =
      hashedoctree::GetDepthHistogram(tree.GetDepthCounts(), FrequencyModels[model], 3);
    results.Frequencies[model].StartDepth = hashedoctree::GetMedianDepth(histograms[model]);
  }
  const auto sums = SearchForLeaves(tree, results.Frequencies);
  const auto check = [&results](double counted, double modelled)
  {
    ++results.CheckedAnswers;
    results.DifferentAnswers += std::abs(counted - modelled) <= 1e-9 * modelled ? 0 : 1;
  };
  for (std::size_t model = 0; model < NumberOfModels; ++model)
  {
    FrequencyCosts& costs = results.Frequencies[model];
    const auto& histogram = histograms[model];
    costs.Deepest = hashedoctree::GetMeanCost(histogram, tree.GetDeepestDepth());
    costs.Root = sums[model].Root / sums[model].Weight;
    check(costs.Root, hashedoctree::GetMeanCost(histogram, 0));
    for (std::size_t i = 0; i < NumberOfModels; ++i)
    {
      costs.Medians[i] = sums[model].Medians[i] / sums[model].Weight;
      check(
        costs.Medians[i], hashedoctree::GetMeanCost(histogram, results.Frequencies[i].StartDepth));
    }
  }
}
}
