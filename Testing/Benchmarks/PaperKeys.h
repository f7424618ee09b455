// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperKeys_h
#define Testing_Benchmarks_PaperKeys_h

#include "PaperPeers.h"
#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** Measures what the keys of the points cost, by integer dilation and by the machine's bit deposit
 * (the paper's section 2; README, row 13), how the paper's hash spreads all nodes over the paper's
 * table, and how it and ours spread the internal nodes over our table (README, row 16, E20). Both
 * ways must give the same keys. */
void MeasureKeys(const PaperTrees& trees, const std::vector<float>& points, int repetitions,
  PaperResults& results);

/** From how many keys are found by looking at i + 1 buckets, or nodes, at index i; at least one
 * key. */
HashProbes SummariseProbes(double load, const std::vector<std::size_t>& lengths);

/** All of it as Markdown; at least one set. */
void WriteKeys(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
