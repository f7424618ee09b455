// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperTable2_h
#define Testing_Benchmarks_PaperTable2_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** The paper's Table 2, the times of searches and the gains, as Markdown with the paper's numbers
 * beside ours; at least one set. */
void WriteTable2(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
