// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorReport_h
#define Testing_Benchmarks_LocatorReport_h

#include "LocatorOptions.h"
#include "LocatorResults.h"

namespace locator_benchmark
{
/** Writes what was measured as Markdown: a table of times of ours and ratios of the others, a
 * summary of the ratios, figures, and the answers that differ. */
void WriteReport(
  const LocatorOptions& options, const LocatorResults& results, std::ostream& markdown);
}

#endif
