// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperSummary_h
#define Testing_Benchmarks_PaperSummary_h

#include "PaperFormat.h"
#include "PaperGain.h"
#include "PaperResults.h"

#include <algorithm>

namespace paper_benchmark
{
/** What is measured of each set, over all sets. */
struct Summary
{
  double Lowest;
  double Mean;
  double Highest;
};

/** function(set) for each set. */
template <typename Function>
std::vector<double> GetOfEach(const std::vector<PaperResults>& sets, const Function& function)
{
  std::vector<double> values;
  values.reserve(sets.size());
  std::transform(sets.begin(), sets.end(), std::back_inserter(values), function);
  return values;
}

/** Of function(set) for each set, of which there is at least one. */
template <typename Function>
Summary Summarise(const std::vector<PaperResults>& sets, const Function& function)
{
  const std::vector<double> values = GetOfEach(sets, function);
  return { *std::min_element(values.begin(), values.end()), GetMean(values),
    *std::max_element(values.begin(), values.end()) };
}

inline std::string FormatSummary(
  const Summary& summary, std::string (*format)(double number) = Format)
{
  return format(summary.Lowest) + " to " + format(summary.Highest) + ", mean " +
    format(summary.Mean);
}

/** What direct searches cost from the root over what they cost from the start depth: in nodes, for
 * every leaf; and in time, for every point. */
inline double GetGainInNodes(const PaperResults& set)
{
  return set.Costs.Root / set.Costs.Median;
}
inline double GetGainInTime(const PaperResults& set, std::size_t root, std::size_t optimised)
{
  return set.Times[Direct][root].Median / set.Times[Direct][optimised].Median;
}
}

#endif
