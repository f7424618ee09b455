// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperSets_h
#define Testing_Benchmarks_PaperSets_h

#include <cstddef>
#include <string>
#include <vector>

namespace paper_benchmark
{
/** A point set of Data/make_point_sets.py, and what the paper's Table 1 says of the set that it
 * stands for. */
struct PaperSet
{
  std::string Name;
  std::string PaperName;
  double PaperThousandNodes;
  int PaperDeepestDepth;
  int PaperStartDepth;
};

/** In the order of the paper's Table 1. */
const std::vector<PaperSet>& GetPaperSets();

/** The points of a set, three coordinates each; none when the folder does not have it. Throws
 * std::runtime_error when the file is broken. */
std::vector<float> ReadPoints(const std::string& folder, const PaperSet& set);
}

#endif
