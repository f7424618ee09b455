// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperReport_h
#define Testing_Benchmarks_PaperReport_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** Writes all that was measured as Markdown, with what the paper says beside it. At least one
 * set must have been measured. */
void WriteReport(const std::vector<PaperResults>& sets, int repetitions, std::ostream& markdown);
}

#endif
