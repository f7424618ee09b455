// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperMeasurement_h
#define Testing_Benchmarks_PaperMeasurement_h

#include "PaperResults.h"

namespace paper_benchmark
{
/** Leaves around which neighbours are searched for: those of points drawn from all. */
constexpr std::size_t NumberOfNeighborSearches = 10000;
/** Leaves that are searched for in the leaves' row of Table 3, at most: every k-th of all. */
constexpr std::size_t MaxLeafSearches = std::size_t(1) << 21;
/** The regular grid of Table 3 has 2^7 cells along each axis (E12). */
constexpr int GridDepth = 7;

/** Measures everything for one set of points, three coordinates each; one thread. */
PaperResults MeasureSet(const PaperSet& set, const std::vector<float>& points, int repetitions);
}

#endif
