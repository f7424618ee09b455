// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperWorkloads_h
#define Testing_Benchmarks_PaperWorkloads_h

#include "PaperResults.h"

namespace paper_benchmark
{
/** Measures the paper's Table 3: every point, every leaf and every cell of a regular grid searched
 * for, from the start depths of the three frequency models, which the results have already.
 * Searches begin with keys. */
void MeasureWorkloads(const PaperTrees& trees, const std::vector<float>& points, int repetitions,
  PaperResults& results);
}

#endif
