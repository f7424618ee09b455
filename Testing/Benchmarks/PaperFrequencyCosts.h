// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperFrequencyCosts_h
#define Testing_Benchmarks_PaperFrequencyCosts_h

#include "PaperResults.h"

namespace paper_benchmark
{
/** Searches for every leaf from the root and from the median of each frequency model (the paper's
 * section 4 and Table 3), counts the nodes, and checks that they are as many as the model says. */
void CountFrequencyCosts(const hashedoctree::Octree<3>& tree, PaperResults& results);
}

#endif
