// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperSummary_h
#define Testing_Benchmarks_PaperSummary_h

#include "PaperFormat.h"
#include "PaperResults.h"

#include <algorithm>
#include <numeric>

namespace paper_benchmark
{
/** What is measured of each set, over all sets. */
struct Summary
{
  double Lowest;
  double Mean;
  double Highest;
};

/** Of function(set) for each set, of which there is at least one. */
template <typename Function>
Summary Summarise(const std::vector<PaperResults>& sets, const Function& function)
{
  std::vector<double> values;
  values.reserve(sets.size());
  for (const PaperResults& set : sets)
  {
    values.push_back(function(set));
  }
  return { *std::min_element(values.begin(), values.end()),
    std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
    *std::max_element(values.begin(), values.end()) };
}

inline std::string FormatSummary(const Summary& summary)
{
  return Format(summary.Lowest) + " to " + Format(summary.Highest) + ", mean " +
    Format(summary.Mean);
}
}

#endif
