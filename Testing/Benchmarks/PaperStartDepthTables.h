// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperStartDepthTables_h
#define Testing_Benchmarks_PaperStartDepthTables_h

#include "PaperResults.h"

#include <iosfwd>

namespace paper_benchmark
{
/** How many nodes searches examine from different start depths, as Markdown; at least one set. */
void WriteModels(std::ostream& out, const std::vector<PaperResults>& sets);
/** The paper's Table 3 in nodes, which do not depend on the machine. */
void WriteFrequencies(std::ostream& out, const std::vector<PaperResults>& sets);
/** Searches for neighbours (end of the paper's section 4; README, rows 41, 42). */
void WriteNeighborStarts(std::ostream& out, const std::vector<PaperResults>& sets);
void WriteRejectedOption(std::ostream& out, const std::vector<PaperResults>& sets);
/** The sets by how much their depths vary, with the gain of the start depth (README, row 56, E15).
 */
void WriteGainsByDeviation(std::ostream& out, const std::vector<PaperResults>& sets);
}

#endif
