// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperKeys_h
#define Testing_Benchmarks_PaperKeys_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** Measures what the keys of the points cost, by integer dilation and by the machine's bit deposit
 * (the paper's section 2; README, row 13), and how the paper's hash and ours spread the keys of the
 * tree's internal nodes (README, row 16, E20). Both ways must give the same keys. */
void MeasureKeys(const hashedoctree::Octree<3>& tree, const std::vector<float>& points,
  int repetitions, PaperResults& results);

/** From how many keys are found by looking at i + 1 buckets, at index i; at least one key. */
HashProbes SummariseProbes(double load, const std::vector<std::size_t>& lengths);

/** Both as Markdown; at least one set. */
void WriteKeys(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
