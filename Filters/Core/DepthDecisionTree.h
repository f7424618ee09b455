// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DepthDecisionTree_h
#define hashedoctree_DepthDecisionTree_h

#include "DepthStatistics.h"

#include <vector>

namespace hashedoctree
{
/**
 * Which depths a search looks at, one after the other, so that it examines the fewest nodes on
 * average. The paper chooses only the first depth (section 4); from there Algorithm 1 goes child by
 * child. But a look at the node of a position at any depth tells that it does not exist, so that
 * the leaf is higher, that it is the leaf, or that it is internal, so that the leaf is deeper. So a
 * search is a binary search tree over the depths, the weights of the depths are its frequencies,
 * and the cheapest one is Knuth's optimal binary search tree. Going child by child from a start
 * depth is one of these trees, so that no start depth costs less on average, the median neither.
 *
 * Of equally cheap depths to look at first the one nearest to the middle of the range is taken, of
 * two such the smaller. Without weights it is a binary search. A histogram without depths is taken
 * for one of the root alone.
 *
 * Immutable; thread safe.
 */
class DepthDecisionTree
{
public:
  /** The optimal tree of a histogram. O(depths^3). */
  explicit DepthDecisionTree(const DepthHistogram& histogram);

  /** The depth to look at first. */
  int GetRootDepth() const { return this->Root; }

  /** The depth to look at when there is no node at `depth`, in [1, deepest of the histogram]. */
  int GetHigher(int depth) const { return this->Depths[static_cast<std::size_t>(depth)].Higher; }

  /** The depth to look at when the node at `depth`, 0 or more, is internal. From the deepest of the
   * histogram on it is the next one: leaves below the histogram are found child by child. */
  int GetDeeper(int depth) const
  {
    return this->Has(depth) ? this->Depths[static_cast<std::size_t>(depth)].Deeper : depth + 1;
  }

  /** How many nodes the search for a leaf at `depth`, 0 or more, examines; at least 1. */
  int GetCost(int depth) const
  {
    return this->Has(depth)
      ? this->Depths[static_cast<std::size_t>(depth)].Cost
      : this->Depths.back().Cost + depth - static_cast<int>(this->Depths.size()) + 1;
  }

  /** Mean number of nodes that a search examines. 0 for a histogram of no weight. */
  double GetMeanCost() const { return this->MeanCost; }

private:
  struct Decision
  {
    int Higher;
    int Deeper;
    int Cost;
  };
  class CheapestTrees;
  void Place(const CheapestTrees& trees, int first, int last, int cost);
  bool Has(int depth) const { return static_cast<std::size_t>(depth) < this->Depths.size(); }

  int Root;
  std::vector<Decision> Depths;
  double MeanCost;
};

/**
 * What no search through looks at single depths can go below: the entropy of the histogram in base
 * 3. The outcomes of the looks (higher, leaf, deeper) write the depth of the leaf in three letters,
 * and no such word begins another, since only the last letter is "leaf"; by Shannon's theorem the
 * mean length of such words is at least that entropy. 0 for a histogram of no weight.
 */
double GetEntropyBound(const DepthHistogram& histogram);
}

#endif
