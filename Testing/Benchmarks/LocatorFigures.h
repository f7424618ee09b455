// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorFigures_h
#define Testing_Benchmarks_LocatorFigures_h

#include "LocatorOptions.h"
#include "LocatorResults.h"

namespace locator_benchmark
{
/** Writes the single figures that sum the comparison up, as far as they were measured. */
void WriteFigures(std::ostream& out, const LocatorOptions& options, const LocatorResults& results);
}

#endif
