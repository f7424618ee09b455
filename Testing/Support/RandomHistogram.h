// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_RandomHistogram_h
#define Testing_Support_RandomHistogram_h

#include "DepthStatistics.h"

#include <random>

/** A histogram of so many depths as trees have them, or not: some depths empty, weights of any
 * size. */
inline hashedoctree::DepthHistogram MakeRandomHistogram(std::mt19937& random, std::size_t size)
{
  hashedoctree::DepthHistogram histogram(size);
  for (std::uint64_t& weight : histogram)
  {
    weight = random() % 3 == 0 ? 0 : random() % (1U << (random() % 20));
  }
  return histogram;
}

#endif
