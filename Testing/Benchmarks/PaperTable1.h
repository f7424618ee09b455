// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperTable1_h
#define Testing_Benchmarks_PaperTable1_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** The paper's Table 1, sizes, memory and builds of trees, as Markdown with the paper's numbers
 * beside ours; at least one set. */
void WriteTable1(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
