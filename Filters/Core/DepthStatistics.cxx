// SPDX-License-Identifier: BSD-3-Clause
#include "DepthStatistics.h"

#include <cstdlib>
#include <numeric>

namespace hashedoctree
{
std::uint64_t GetTotal(const DepthHistogram& histogram)
{
  return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t(0));
}

DepthHistogram GetDepthHistogram(const DepthCounts& counts, FrequencyModel model, int dimension)
{
  if (model == FrequencyModel::Points)
  {
    return counts.Points;
  }
  DepthHistogram histogram = counts.Leaves;
  if (model == FrequencyModel::Grid)
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
  // Counts of leaves and points stay below 2^53, so that their sums are exact; the sums of the
  // grid model are not, and need not be.
  double cost = 0.0;
  double total = 0.0;
  for (std::size_t depth = 0; depth < histogram.size(); ++depth)
  {
    const double weight = static_cast<double>(histogram[depth]);
    cost += weight * (1 + std::abs(static_cast<int>(depth) - startDepth));
    total += weight;
  }
  return total > 0.0 ? cost / total : 0.0;
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
  __extension__ using Whole = unsigned __int128; // Weights may have 64 bits.
  Whole sum = 0;
  Whole total = 0;
  for (std::size_t depth = 0; depth < histogram.size(); ++depth)
  {
    sum += Whole(histogram[depth]) * depth;
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

int GetCheapestStartDepth(const DepthHistogram& histogram)
{
  int cheapest = 0;
  for (int depth = 1; depth < static_cast<int>(histogram.size()); ++depth)
  {
    if (GetMeanCost(histogram, depth) < GetMeanCost(histogram, cheapest))
    {
      cheapest = depth;
    }
  }
  return cheapest;
}
}
