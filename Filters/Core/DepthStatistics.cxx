// SPDX-License-Identifier: BSD-3-Clause
#include "DepthStatistics.h"

#include <cstdlib>
#include <numeric>

namespace hashedoctree
{
namespace
{
/** The nodes that searches from a depth examine, as often as the weights say. */
WeightSum GetCost(const DepthHistogram& histogram, int startDepth)
{
  WeightSum cost = 0;
  for (std::size_t depth = 0; depth < histogram.size(); ++depth)
  {
    const int nodes = 1 + std::abs(static_cast<int>(depth) - startDepth);
    cost += WeightSum(histogram[depth]) * static_cast<unsigned>(nodes);
  }
  return cost;
}
}

std::uint64_t GetTotal(const DepthHistogram& histogram)
{
  return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t(0));
}

DepthHistogram GetDepthHistogram(const DepthCounts& counts, FrequencyModel frequency, int dimension)
{
  if (frequency == FrequencyModel::Points)
  {
    return counts.Points;
  }
  DepthHistogram histogram = counts.Leaves;
  if (frequency == FrequencyModel::Grid)
  {
    const int deepest = static_cast<int>(histogram.size()) - 1;
    for (int depth = 0; depth <= deepest; ++depth)
    {
      histogram[depth] <<= dimension * (deepest - depth);
    }
  }
  return histogram;
}

double GetMeanCost(const DepthHistogram& histogram, int startDepth)
{
  const std::uint64_t total = GetTotal(histogram);
  return total > 0
    ? static_cast<double>(GetCost(histogram, startDepth)) / static_cast<double>(total)
    : 0.0;
}

int GetMedianDepth(const DepthHistogram& histogram)
{
  const std::uint64_t total = GetTotal(histogram);
  std::uint64_t upTo = 0;
  for (std::size_t depth = 0; depth < histogram.size() && total > 0; ++depth)
  {
    upTo += histogram[depth];
    if (upTo >= total - upTo)
    {
      return static_cast<int>(depth);
    }
  }
  return 0;
}

int GetMeanDepth(const DepthHistogram& histogram)
{
  WeightSum sum = 0;
  WeightSum total = 0;
  for (std::size_t depth = 0; depth < histogram.size(); ++depth)
  {
    sum += WeightSum(histogram[depth]) * depth;
    total += histogram[depth];
  }
  return total > 0 ? static_cast<int>((2 * sum + total) / (2 * total)) : 0;
}

int GetStartDepth(const DepthCounts& counts, const StartDepthOptions& options, int dimension)
{
  const DepthHistogram histogram = GetDepthHistogram(counts, options.Frequency, dimension);
  switch (options.Model)
  {
    case StartDepthModel::Mean:
      return GetMeanDepth(histogram);
    case StartDepthModel::Root:
      return 0;
    case StartDepthModel::Fixed:
      return options.Fixed;
    default:
      return GetMedianDepth(histogram);
  }
}

int GetBestStartDepth(const DepthHistogram& histogram)
{
  int cheapest = 0;
  for (int depth = 1; depth < static_cast<int>(histogram.size()); ++depth)
  {
    if (GetCost(histogram, depth) < GetCost(histogram, cheapest))
    {
      cheapest = depth;
    }
  }
  return cheapest;
}
}
