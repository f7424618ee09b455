// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DepthStatistics_h
#define hashedoctree_DepthStatistics_h

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/** How often a leaf is searched for (paper section 4): once (Leaves), once for each of its points
 * (Points; no function of the depth, only the points of each depth are needed, E13), or in
 * proportion to its volume (Grid). */
enum class FrequencyModel
{
  Leaves,
  Points,
  Grid
};

/** Where direct searches start: at the weighted median of the leaves' depths, at their weighted
 * mean, at the root, at a given depth (paper section 4), or at the median of the leaves near the
 * position (StartDepths.h), which the paper does not have. */
enum class StartDepthModel
{
  Median,
  Mean,
  Root,
  Fixed,
  Local
};

/** How a start depth is chosen. */
struct StartDepthOptions
{
  StartDepthModel Model = StartDepthModel::Median;
  FrequencyModel Frequency = FrequencyModel::Leaves;
  int Fixed = 0; ///< In [0, MortonKey::MaxDepth]; of the Fixed model only.
};

/** A weight for each depth, from 0 to the deepest: the paper's p_l * f_l, as exact integers. */
using DepthHistogram = std::vector<std::uint64_t>;

/** Weights multiplied by numbers of nodes, and their sums: exact, as weights may have 64 bits. */
__extension__ using WeightSum = unsigned __int128;

/** What a tree has at each depth, from 0 to the deepest; the three histograms have one length. */
struct DepthCounts
{
  DepthHistogram Leaves;      ///< All leaves, empty ones too.
  DepthHistogram EmptyLeaves; ///< Leaves without points.
  DepthHistogram Points;      ///< Points in the leaves.

  /** A root that is an empty leaf. */
  static DepthCounts OfEmptyTree() { return DepthCounts{ { 1 }, { 1 }, { 0 } }; }

  int GetDeepestDepth() const { return static_cast<int>(this->Leaves.size()) - 1; }
};

// All that follows is thread safe, and takes O(depths) unless it says otherwise.

/**
 * The histogram of a frequency model. Grid weighs a leaf by the cells of the deepest depth that it
 * covers, 2^(dimension * (deepest - depth)), so that the weights of a complete tree add up to
 * 2^(dimension * deepest), below 2^64 in every dimension.
 */
DepthHistogram GetDepthHistogram(
  const DepthCounts& counts, FrequencyModel frequency, int dimension);

/** The weight of all depths together. */
std::uint64_t GetTotal(const DepthHistogram& histogram);

/**
 * Mean number of nodes that a direct search examines when it starts at `startDepth`: a leaf at
 * depth l costs 1 + |l - startDepth| (paper section 4, with the weights normalised, E7). Any start
 * depth from 0 on, also below the deepest leaf. 0 for a histogram of no weight.
 */
double GetMeanCost(const DepthHistogram& histogram, int startDepth);

/**
 * The weighted median of the depths, which costs the least (paper section 4): the smallest depth
 * up to which lies at least half of the weight. Where exactly half lies up to it, the next depth
 * with weight, and all between, cost the same (E23). 0 for a histogram of no weight.
 */
int GetMedianDepth(const DepthHistogram& histogram);

/** The weighted mean of the depths to the nearest integer, halves upwards: the paper's cheaper
 * estimate of the median. 0 for a histogram of no weight. */
int GetMeanDepth(const DepthHistogram& histogram);

/** The one start depth that a model has for a whole tree, by the options' frequency model; of the
 * Local model the median. */
int GetStartDepth(const DepthCounts& counts, const StartDepthOptions& options, int dimension);

/** A start depth with the least mean cost, found by trying all; the smallest of equals.
 * O(depths^2). */
int GetBestStartDepth(const DepthHistogram& histogram);
}

#endif
