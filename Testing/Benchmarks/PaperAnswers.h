// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperAnswers_h
#define Testing_Benchmarks_PaperAnswers_h

#include "PaperResults.h"

namespace paper_benchmark
{
/** Answers of each peer that are compared with ours: the leaves of so many points at most, */
constexpr std::size_t CheckedLeaves = 1000;
/** and the leaves around so many. */
constexpr std::size_t CheckedNeighborhoods = 200;

/** Compares answers of all peers, ours among them, with ours from the median, and adds their number
 * and that of those which differ to the results, which have the number of points already. `points`
 * has three coordinates for each; the peers have their leaves. */
void CheckAnswers(
  const PaperPeers& peers, const std::vector<float>& points, double radius, PaperResults& results);
}

#endif
