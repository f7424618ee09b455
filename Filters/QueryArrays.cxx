// SPDX-License-Identifier: BSD-3-Clause
#include "QueryArrays.h"

#include "LeafNumbers.h"

#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeUInt64Array.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace hashedoctree
{
namespace
{
using Comparison = SearchComparison<3>;

/** Adds an array to the data set, which then owns it. */
template <typename Array>
Array* AddPointArray(vtkDataSet* dataSet, const char* name)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(dataSet->GetNumberOfPoints());
  dataSet->GetPointData()->AddArray(array);
  return array;
}

void Add(Comparison::Costs& sums, const Comparison::Costs& costs)
{
  std::transform(sums.begin(), sums.end(), costs.begin(), sums.begin(), std::plus<>());
}

/** The search for one query, and where its results go. */
class QuerySearch
{
public:
  QuerySearch(
    vtkDataSet* queries, const Octree<3>& tree, EmptyOctants reading, const Comparison& searches)
    : Tree(tree)
    , Reading(reading)
    , Searches(searches)
    , Numbers(tree, reading)
    , Ids(AddPointArray<vtkIdTypeArray>(queries, "LeafId"))
    , Depths(AddPointArray<vtkIntArray>(queries, "LeafDepth"))
    , Keys(AddPointArray<vtkTypeUInt64Array>(queries, "LeafKey"))
  {
    for (const auto& [search, name] : { std::pair(Comparison::Chosen, "HitCost"),
           std::pair(Comparison::Root, "RootCost"), std::pair(Comparison::Median, "MedianCost"),
           std::pair(Comparison::Mean, "MeanCost"), std::pair(Comparison::Local, "LocalCost"),
           std::pair(Comparison::DecisionTree, "DecisionTreeCost") })
    {
      this->Costs.emplace_back(search, AddPointArray<vtkIntArray>(queries, name));
    }
    queries->GetPointData()->SetActiveScalars("HitCost");
  }

  /** Fills the arrays for a query at x, and returns what its searches cost. */
  Comparison::Costs Search(vtkIdType query, const Position<3>& x) const
  {
    if (!IsFinite(x))
    {
      return this->Set(query, -1, -1, MortonKey<3>(0), Comparison::Costs{});
    }
    const MortonKey<3> key = this->Tree.GetGrid().GetKey(x.data());
    const FoundLeaf<3> leaf =
      FindLeaf(this->Tree, key, this->Searches.GetStartDepth(Comparison::Chosen), this->Reading);
    const vtkIdType id =
      leaf.Exists ? static_cast<vtkIdType>(this->Numbers.Get(this->Tree, leaf)) : -1;
    return this->Set(
      query, id, leaf.Key.GetDepth(), leaf.Key, this->Searches.CountExaminedNodes(key));
  }

private:
  Comparison::Costs Set(vtkIdType query, vtkIdType leafId, int depth, MortonKey<3> key,
    const Comparison::Costs& costs) const
  {
    this->Ids->SetValue(query, leafId);
    this->Depths->SetValue(query, depth);
    this->Keys->SetValue(query, key.GetValue());
    for (const auto& [search, array] : this->Costs)
    {
      array->SetValue(query, static_cast<int>(costs[search]));
    }
    return costs;
  }

  const Octree<3>& Tree;
  EmptyOctants Reading;
  const Comparison& Searches;
  LeafNumbers<3> Numbers;
  vtkIdTypeArray* Ids;
  vtkIntArray* Depths;
  vtkTypeUInt64Array* Keys;
  std::vector<std::pair<Comparison::Search, vtkIntArray*>> Costs;
};
}

SearchComparison<3>::Costs AddQueryArrays(vtkDataSet* queries, const PointsAdaptor& points,
  const Octree<3>& tree, EmptyOctants reading, const SearchComparison<3>& searches,
  const Execution& execution)
{
  constexpr std::size_t chunkSize = 1024; // Queries that a thread does at a time.
  const QuerySearch search(queries, tree, reading, searches);
  Comparison::Costs all{};
  points.Visit(
    [&](auto span)
    {
      std::vector<Comparison::Costs> chunks((span.Count + chunkSize - 1) / chunkSize);
      execution.For(chunks.size(), 1,
        [&](std::size_t firstChunk, std::size_t lastChunk)
        {
          for (std::size_t i = firstChunk * chunkSize;
               i < std::min(span.Count, lastChunk * chunkSize); ++i)
          {
            Position<3> x;
            std::copy(span[i], span[i] + 3, x.begin());
            Add(chunks[i / chunkSize], search.Search(static_cast<vtkIdType>(i), x));
          }
        });
      for (const Comparison::Costs& costs : chunks)
      {
        Add(all, costs);
      }
    });
  return all;
}
}
