// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperStartDepthTables_h
#define Testing_Benchmarks_PaperStartDepthTables_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** How many nodes searches examine from different start depths, as Markdown; at least one set. */
void WriteModels(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
