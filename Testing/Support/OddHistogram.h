// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_OddHistogram_h
#define Testing_Support_OddHistogram_h

#include "DepthStatistics.h"

#include <random>

/** A histogram of 1 to 22 depths with weight at each, an odd number in all, so that no depth splits
 * it into halves and one start depth is the cheapest. */
inline hashedoctree::DepthHistogram MakeOddHistogram(std::mt19937& random)
{
  hashedoctree::DepthHistogram histogram(1 + random() % 22);
  std::uint64_t total = 0;
  for (std::uint64_t& weight : histogram)
  {
    weight = 1 + random() % (1U << (random() % 20));
    total += weight;
  }
  histogram.back() += 1 - total % 2;
  return histogram;
}

#endif
