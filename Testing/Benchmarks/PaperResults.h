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

/** The frequency models, in the order of the paper's Table 3. */
constexpr std::size_t NumberOfModels = 3;
constexpr std::array<hashedoctree::FrequencyModel, NumberOfModels> FrequencyModels{
  hashedoctree::FrequencyModel::Points, hashedoctree::FrequencyModel::Leaves,
  hashedoctree::FrequencyModel::Grid
};

/** For each way of searching (rows of the paper's Table 3: points, leaves, grid) the time of a
 * search from the start depth of each frequency model (its columns, in the same order). */
using WorkloadTimes = std::array<std::array<Spread, NumberOfModels>, NumberOfModels>;

/** Mean numbers of nodes that direct searches examine when leaves are searched for as often as a
 * frequency model says. */
struct FrequencyCosts
{
  int StartDepth = 0; ///< The weighted median depth of the model.
  double Root = 0.0;
  double Deepest = 0.0;                         ///< Bottom-up, from the deepest depth.
  std::array<double, NumberOfModels> Medians{}; ///< From the start depth of each model.
};

/** How a hash spreads keys over a table: of buckets, or of nodes in chains. */
struct HashProbes
{
  double Load = 0.0; ///< Keys over slots.
  /** Shares of the keys for which 1, 2, 3 to 4, 5 to 8, 9 to 16, and more are looked at. */
  std::array<double, 6> Shares{};
  double Mean = 0.0;        ///< Looked at for a key.
  std::size_t Greatest = 0; ///< The most of them.
};
struct KeyCosts
{
  Spread Dilation;
  Spread Pdep;        ///< Zero where the machine cannot.
  HashProbes Chains;  ///< In the paper's own table, which has all nodes.
  HashProbes LowBits; ///< In ours by the paper's hash,
  HashProbes Mixing;  ///< and by our own.
};

/** Mean number of nodes and time of an adjacent search. */
struct AdjacentOption
{
  double Nodes = 0.0;
  Spread Time;
};

/** Mean numbers of nodes that searches for the neighbours of a leaf examine. */
struct NeighborCosts
{
  double Root;
  double Median;        ///< From the median of all leaves, as the paper does (README, row 42).
  double Best;          ///< From the one depth that is best for all leaves.
  int BestDepth;        ///< That depth, the smallest of equals.
  double Own;           ///< From the depth that is best for each leaf (README, row 41).
  double Climbing;      ///< From the deepest depth: from parent to parent (README, row 25).
  double TopDown = 0.0; ///< Of the classical search from the root, in the paper's layout.
};
struct NeighborStarts
{
  NeighborCosts Adjacent{};
  NeighborCosts InRadius{};
  NeighborCosts PaperAdjacent{}; ///< The same in the paper's layout, by its own searches.
  NeighborCosts PaperInRadius{};
  std::size_t StoredBytes = 0; ///< Of NodeStartDepths, which has Own of the adjacent search.
  double StoredSeconds = 0.0;  ///< What making them took, once.
  Spread MedianTime;           ///< Of an adjacent search from the median,
  Spread OwnTime;              ///< and from the leaf's own depth, which is looked up.
  AdjacentOption Rejected; ///< The option that the paper rejects (README, row 22), from the median.
  AdjacentOption Taken;    ///< The other one, for the same leaves.
};

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
  std::array<std::size_t, NumberOfStructures> Bytes{};
  std::array<Spread, NumberOfStructures> Builds;
  Spread PaperOptimise; ///< Counting the leaves of each depth in the table, and their median.
  Spread OurOptimise;   ///< The median of the counts that the build has kept.
  std::array<std::array<Spread, NumberOfPeers>, NumberOfKinds> Times;
  Spread SingleSearches; ///< Direct searches for all points, one at a time,
  Spread BatchSearches;  ///< and at once.
  WorkloadTimes PaperWorkloads;
  WorkloadTimes OurWorkloads;
  ModelCosts Costs{};
  std::array<FrequencyCosts, NumberOfModels> Frequencies;
  NeighborStarts Neighbors;
  KeyCosts Keys;
  std::size_t CheckedAnswers = 0;
  std::size_t DifferentAnswers = 0;
};
}

#endif
