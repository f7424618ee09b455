// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperResults_h
#define Testing_Benchmarks_PaperResults_h

#include "PaperPeers.h"
#include "PaperSets.h"
#include "PaperTiming.h"

#include <array>

namespace paper_benchmark
{
/** The structures that are built, in the order of the report. */
enum PaperStructure : std::size_t
{
  PointersBuilt,
  BrotherChildBuilt,
  WithParentsBuilt,
  PaperBuilt,
  PaperMixingBuilt,
  OursBuilt,
  NumberOfStructures
};

/** The searches of the paper's Table 2. */
enum PaperSearchKind : std::size_t
{
  Direct,
  Adjacent,
  InRadius,
  NumberOfKinds
};

/** For each way of searching (rows of the paper's Table 3: points, leaves, grid) the time of a
 * search from the start depth of each frequency model (its columns, in the same order). */
using WorkloadTimes = std::array<std::array<Spread, 3>, 3>;

/** Mean numbers of nodes that a search examines when every leaf is searched for once. */
struct ModelCosts
{
  double Root;
  double Median;
  double Mean;
  double Local;
  double Decisions; ///< Of DepthDecisionTree.
  double Bound;     ///< What no search can go below.
};

/** All that is measured of one set. Times are in seconds, for one build or one search. */
struct PaperResults
{
  PaperSet Set;
  std::size_t Points = 0;
  std::size_t Nodes = 0;
  std::size_t Leaves = 0;
  int DeepestDepth = 0;
  int StartDepth = 0;          ///< The median depth of the leaves.
  double DepthDeviation = 0.0; ///< Standard deviation of the depth of the leaves.
  double RadiusOfSide = 0.0;   ///< Radius of the in-radius searches over the side of the root.
  std::array<std::size_t, NumberOfStructures> Bytes{};
  std::array<Spread, NumberOfStructures> Builds;
  Spread PaperOptimise; ///< Counting the leaves of each depth in the table, and their median.
  Spread OurOptimise;   ///< The median of the counts that the build has kept.
  std::array<std::size_t, NumberOfKinds> Searches{};
  std::array<std::array<Spread, NumberOfPeers>, NumberOfKinds> Times;
  std::array<std::size_t, 3> WorkloadSearches{};
  WorkloadTimes PaperWorkloads;
  WorkloadTimes OurWorkloads;
  ModelCosts Costs{};
  std::size_t CheckedAnswers = 0;
  std::size_t DifferentAnswers = 0;
};
}

#endif
