// SPDX-License-Identifier: BSD-3-Clause
#include "SearchComparison.h"

#include "DecisionSearch.h"
#include "ForEachDimension.h"

namespace hashedoctree
{
template <int Dim>
SearchComparison<Dim>::SearchComparison(const TreePart<Dim>& part, const StartDepthOptions& options)
  : Part(part)
  , Frequency(options.Frequency)
  , Decisions(GetDepthHistogram(part.GetDepthCounts(), options.Frequency, Dim))
{
  const auto start = [&part, &options](StartDepthModel model) {
    return StartDepths<Dim>(part, { model, options.Frequency, 0 });
  };
  this->Starts[Chosen] = StartDepths<Dim>(part, options);
  this->Starts[Median] = start(StartDepthModel::Median);
  this->Starts[Mean] = start(StartDepthModel::Mean);
  this->Starts[Local] = start(StartDepthModel::Local);
  for (std::size_t search = 0; search < NumberOfSearches; ++search)
  {
    this->PredictedMeans[search] = search == DecisionTree
      ? this->Decisions.GetMeanCost()
      : this->Starts[search].GetMeanCost(part, options.Frequency);
  }
}

template <int Dim>
void SearchComparison<Dim>::SetQueryDepths(const DepthHistogram& queryDepths)
{
  StartDepths<Dim>& best = this->Starts[BestForQueries];
  best = StartDepths<Dim>(
    this->Part, { StartDepthModel::Fixed, this->Frequency, GetMedianDepth(queryDepths) });
  this->PredictedMeans[BestForQueries] = best.GetMeanCost(this->Part, this->Frequency);
}

template <int Dim>
int SearchComparison<Dim>::GetStartDepth(Search search) const
{
  return search == Local     ? -1
    : search == DecisionTree ? this->Decisions.GetRootDepth()
                             : this->Starts[search].GetOfTree();
}

template <int Dim>
FoundLeaf<Dim> SearchComparison<Dim>::Find(
  MortonKey<Dim> key, EmptyOctants reading, Costs& costs) const
{
  const Octree<Dim>& tree = this->Part.GetTree();
  FoundLeaf<Dim> leaf; // The same for all.
  for (std::size_t search = 0; search < NumberOfSearches; ++search)
  {
    NodeCount count;
    leaf = search == DecisionTree
      ? FindLeaf(tree, key, this->Decisions, count, reading)
      : FindLeaf(tree, key, this->Starts[search].Get(key), count, reading);
    costs[search] = count.Nodes;
  }
  return leaf;
}

#define HASHEDOCTREE_INSTANTIATE(Dim) template class SearchComparison<Dim>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
