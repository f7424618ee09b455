// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperSets_h
#define Testing_Benchmarks_PaperSets_h

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace paper_benchmark
{
/** The structures of the paper's tables, in the order of their columns. Table 1 has the first
 * three, since the last is the third with another start depth. */
enum PaperColumn : std::size_t
{
  PointersColumn,
  BrotherChildColumn,
  HashedColumn,
  StartDepthColumn,
  NumberOfColumns
};
using PaperTable1Columns = std::array<double, StartDepthColumn>;
/** One row for each of direct, adjacent and in-radius search. */
using PaperTable2Columns = std::array<std::array<double, NumberOfColumns>, 3>;

/** What the paper's Tables 1 and 2 say of a point set. */
struct PaperNumbers
{
  std::string Name;
  double ThousandPoints = 0.0;
  double ThousandNodes = 0.0;
  double ThousandLeaves = 0.0;
  int DeepestDepth = 0;
  int StartDepth = 0;
  PaperTable1Columns Megabytes{};
  PaperTable1Columns BuildMilliseconds{};
  double OptimiseMilliseconds = 0.0;
  PaperTable2Columns Microseconds{};
};

/** A point set of Data/make_point_sets.py, and the set of the paper that it stands for. */
struct PaperSet
{
  std::string Name;
  std::size_t Points = 0;
  PaperNumbers Paper;
};

/** In the order of the paper's Table 1. */
const std::vector<PaperSet>& GetPaperSets();

/** The last rows of the paper's tables, as they are printed: of Table 1 the means weighted by
 * nodes, of Table 2 the means and the gains. The paper's own rows do not give all of them (E16). */
struct PaperAverages
{
  PaperTable1Columns Megabytes;
  PaperTable1Columns BuildMilliseconds;
  double OptimiseMilliseconds;
  PaperTable2Columns Microseconds;
  PaperTable2Columns Gains;
};
const PaperAverages& GetPaperAverages();

/** The points of a set, three coordinates each. Throws std::runtime_error when the folder does not
 * have it, or not with so many points. */
std::vector<float> ReadPoints(const std::string& folder, const PaperSet& set);
}

#endif
