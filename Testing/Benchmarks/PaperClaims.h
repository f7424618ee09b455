// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperClaims_h
#define Testing_Benchmarks_PaperClaims_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** The claims of the paper's text (README, row 56) beside what was measured, as Markdown; at least
 * one set. */
void WriteClaims(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
