// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperGain_h
#define Testing_Benchmarks_PaperGain_h

#include <numeric>
#include <vector>

namespace paper_benchmark
{
/** How many times as long searches take as those with which they are compared, over several sets,
 * in both readings (paper E15). */
struct Gain
{
  double MeanOfRatios; ///< As the paper has it: each set counts alike.
  double RatioOfMeans; ///< Sets whose searches take long count more.
};

/** The mean of at least one value. */
inline double GetMean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/** As the averages of the paper's Table 1 are weighted by nodes. At least one value; as many
 * weights, which are positive. */
inline double GetWeightedMean(const std::vector<double>& values, const std::vector<double>& weights)
{
  return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) /
    std::accumulate(weights.begin(), weights.end(), 0.0);
}

/** Of the times of at least one set, over as many of the same sets. */
inline Gain GetGain(const std::vector<double>& times, const std::vector<double>& over)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    ratios.push_back(times[i] / over[i]);
  }
  return { GetMean(ratios), GetMean(times) / GetMean(over) };
}
}

#endif
