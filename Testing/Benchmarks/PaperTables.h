// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperTables_h
#define Testing_Benchmarks_PaperTables_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** The paper's tables as Markdown, with what the paper says beside it; at least one set. */
void WriteTable1(std::ostream& out, const std::vector<PaperResults>& sets);
void WriteTable2(std::ostream& out, const std::vector<PaperResults>& sets);
void WriteTable3(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
