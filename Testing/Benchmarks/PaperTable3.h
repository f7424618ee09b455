// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperTable3_h
#define Testing_Benchmarks_PaperTable3_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** The paper's Table 3, direct searches by frequency model, as Markdown with the paper's numbers
 * beside ours; at least one set. */
void WriteTable3(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
