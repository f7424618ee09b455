// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_Median_h
#define Testing_Benchmarks_Median_h

#include <algorithm>
#include <limits>
#include <vector>

/** The value in the middle, or the mean of the two that are; not a number where there is none. */
inline double GetMedian(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const std::size_t last = values.size() - 1;
  return (values[last / 2] + values[last - last / 2]) / 2.0;
}

#endif
