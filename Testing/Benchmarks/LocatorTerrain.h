// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorTerrain_h
#define Testing_Benchmarks_LocatorTerrain_h

#include <cstddef>
#include <string>
#include <vector>

namespace locator_benchmark
{
/** `count` points on the measured terrain of a file that Data/make_terrain.py wrote: a jittered
 * grid, row after row as measured, heights interpolated. Throws std::runtime_error when the file
 * cannot be read or is no such terrain. */
std::vector<float> ResampleTerrain(const std::string& path, std::size_t count, unsigned seed);
}

#endif
