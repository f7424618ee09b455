// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperNeighborStarts_h
#define Testing_Benchmarks_PaperNeighborStarts_h

#include "PaperPeers.h"
#include "PaperResults.h"

namespace paper_benchmark
{
/** Leaves, of those given, whose neighbours are searched for from every start depth. */
constexpr std::size_t MaxScannedLeaves = 2000;

/** Leaves around which the adjacent search is done by the option that the paper rejects, which can
 * take millions of nodes for one. */
constexpr std::size_t MaxRejectedLeaves = 200;

/** Counts what neighbour searches examine from different start depths (end of the paper's section
 * 4; README, rows 41, 42), in the paper's layout and in ours, and checks that NodeStartDepths has
 * the best for each leaf. `radius` is in world units. */
void MeasureNeighborStarts(const PaperTrees& trees, const std::vector<Key>& leaves, double radius,
  int repetitions, PaperResults& results);
}

#endif
