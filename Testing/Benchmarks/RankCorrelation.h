// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_RankCorrelation_h
#define Testing_Benchmarks_RankCorrelation_h

#include <cmath>
#include <cstddef>
#include <vector>

/** The ranks of values, from 0 on; equal values share the mean of theirs. O(n^2). */
inline std::vector<double> GetRanks(const std::vector<double>& values)
{
  std::vector<double> ranks;
  for (const double value : values)
  {
    double rank = -0.5; // The value is equal to itself.
    for (const double other : values)
    {
      rank += other < value ? 1.0 : other == value ? 0.5 : 0.0;
    }
    ranks.push_back(rank);
  }
  return ranks;
}

/** Spearman's rank correlation of two lists of one length: from -1, one falls as the other grows,
 * to 1. 0 when all values of a list are equal, or when there are none. */
inline double GetRankCorrelation(const std::vector<double>& a, const std::vector<double>& b)
{
  const std::vector<double> ranksOfA = GetRanks(a);
  const std::vector<double> ranksOfB = GetRanks(b);
  const double mean = (static_cast<double>(a.size()) - 1.0) / 2.0;
  double product = 0.0;
  double squaresOfA = 0.0;
  double squaresOfB = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    product += (ranksOfA[i] - mean) * (ranksOfB[i] - mean);
    squaresOfA += (ranksOfA[i] - mean) * (ranksOfA[i] - mean);
    squaresOfB += (ranksOfB[i] - mean) * (ranksOfB[i] - mean);
  }
  const double squares = std::sqrt(squaresOfA * squaresOfB);
  return squares > 0.0 ? product / squares : 0.0;
}

#endif
