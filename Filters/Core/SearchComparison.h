// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_SearchComparison_h
#define hashedoctree_SearchComparison_h

#include "DepthDecisionTree.h"
#include "DirectSearch.h"
#include "StartDepths.h"

#include <array>
#include <cstdint>

namespace hashedoctree
{
/**
 * Searches that differ in where they start, side by side: what each is predicted to cost in a
 * frequency model (paper section 4), and what it costs for a position, counted.
 *
 * Const members are thread safe. The tree must outlive it.
 */
template <int Dim>
class SearchComparison
{
public:
  enum Search : std::size_t
  {
    Chosen,         ///< As the options say.
    Root,           ///< From the root: the classical search.
    Median,         ///< From the weighted median of the leaves' depths.
    Mean,           ///< From their weighted mean.
    Local,          ///< From the weighted median near the position (StartDepths.h).
    DecisionTree,   ///< From depth to depth by decisions (DecisionSearch.h).
    BestForQueries, ///< From the one depth that costs the least for the given query depths.
    NumberOfSearches
  };
  /** A number of nodes for each search. */
  using Costs = std::array<std::uint64_t, NumberOfSearches>;

  /** `options` say where the chosen search starts, and their frequency model weighs the leaves for
   * all others but the best one. The same for all builders of a tree, all of which have to call it.
   * O(nodes). */
  SearchComparison(const TreePart<Dim>& part, const StartDepthOptions& options);

  /** What BestForQueries is best for, which starts at the root until then: a weight for each depth,
   * from 0 to the tree's deepest, as MeasureQueryDepths() measures it. O(depths). */
  void SetQueryDepths(const DepthHistogram& queryDepths);

  /** The depth where a search starts; of the decision tree the depth that it looks at first. -1 of
   * Local, which has no single one (of Chosen, where that is Local, the median of the tree). */
  int GetStartDepth(Search search) const;

  /** Mean number of nodes that a search examines, when leaves are searched for as the frequency
   * model says. 0 where that has no weight. */
  double GetPredictedMean(Search search) const { return this->PredictedMeans[search]; }

  /** The leaf of a position in the part, given its key at MaxDepth, and how many nodes each search
   * for it examines. Every search is made and counted; nothing comes from the cost model. */
  FoundLeaf<Dim> Find(MortonKey<Dim> key, EmptyOctants reading, Costs& costs) const;

private:
  TreePart<Dim> Part;
  FrequencyModel Frequency;
  std::array<StartDepths<Dim>, NumberOfSearches> Starts; ///< That of DecisionTree is not used.
  DepthDecisionTree Decisions;
  std::array<double, NumberOfSearches> PredictedMeans;
};
}

#endif
