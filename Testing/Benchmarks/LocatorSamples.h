// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorSamples_h
#define Testing_Benchmarks_LocatorSamples_h

#include "LocatorData.h"

namespace locator_benchmark
{
/** Names of the data sets that there are. */
const std::vector<std::string>& GetSampleNames();

/** The data set of a name, always the same `count` points. Throws std::runtime_error when the
 * terrain, and only that, cannot be read. */
LocatorData MakeSample(const std::string& name, std::size_t count, const std::string& terrainPath);
}

#endif
