// SPDX-License-Identifier: BSD-3-Clause
#include "SearchComparison.h"

#include "DecisionSearch.h"

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
auto SearchComparison<Dim>::CountExaminedNodes(MortonKey<Dim> key) const -> Costs
{
  Costs costs;
  for (std::size_t search = 0; search < NumberOfSearches; ++search)
  {
    NodeCount count;
    search == DecisionTree
      ? FindLeaf(this->Part.GetTree(), key, this->Decisions, count)
      : FindLeaf(this->Part.GetTree(), key, this->Starts[search].Get(key), count);
    costs[search] = count.Nodes;
  }
  return costs;
}

template class SearchComparison<1>;
template class SearchComparison<2>;
template class SearchComparison<3>;
template class SearchComparison<4>;
}
