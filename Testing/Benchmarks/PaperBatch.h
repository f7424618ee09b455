// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperBatch_h
#define Testing_Benchmarks_PaperBatch_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** Measures direct searches for all points of a set from the median depth, one at a time and at
 * once (DirectBatch.h), which must find the same leaves. */
void MeasureBatch(const hashedoctree::Octree<3>& tree, const std::vector<float>& points,
  int repetitions, PaperResults& results);

/** That as Markdown; at least one set. */
void WriteBatch(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
