// SPDX-License-Identifier: BSD-3-Clause
#include "QueryArrays.h"

#include "ResizeArray.h"

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
/** Adds an array to the data set, which then owns it; one of the same name goes, with its role
 * among the attributes. */
template <typename Array>
Array* AddPointArray(vtkDataSet* dataSet, const char* name)
{
  vtkNew<Array> array;
  array->SetName(name);
  ResizeArray(array.Get(), static_cast<std::size_t>(dataSet->GetNumberOfPoints()));
  dataSet->GetPointData()->RemoveArray(name);
  dataSet->GetPointData()->AddArray(array);
  return array;
}

/** `sums` and `costs` have a number for each search. */
template <typename Costs>
void Add(Costs& sums, const Costs& costs)
{
  std::transform(sums.begin(), sums.end(), costs.begin(), sums.begin(), std::plus<>());
}

/** The search for one query, and where its results go. */
template <int Dim>
class QuerySearch
{
public:
  using Comparison = SearchComparison<Dim>;
  using Costs = typename Comparison::Costs;

  QuerySearch(vtkDataSet* queries, const Octree<Dim>& tree, const LeafNumbers<Dim>& numbers,
    const Comparison& searches)
    : Tree(tree)
    , Numbers(numbers)
    , Searches(searches)
    , Ids(AddPointArray<vtkIdTypeArray>(queries, "LeafId"))
    , Depths(AddPointArray<vtkIntArray>(queries, "LeafDepth"))
    , Keys(AddPointArray<vtkTypeUInt64Array>(queries, "LeafKey"))
  {
    for (const auto& [search, name] : { std::pair(Comparison::Chosen, "HitCost"),
           std::pair(Comparison::Root, "RootCost"), std::pair(Comparison::Median, "MedianCost"),
           std::pair(Comparison::Mean, "MeanCost"), std::pair(Comparison::Local, "LocalCost"),
           std::pair(Comparison::DecisionTree, "DecisionTreeCost") })
    {
      this->CostArrays.emplace_back(search, AddPointArray<vtkIntArray>(queries, name));
    }
    queries->GetPointData()->SetActiveScalars("HitCost");
  }

  /** Fills the arrays for a query at x, and returns what its searches cost. */
  Costs Search(vtkIdType query, const Position<Dim>& x) const
  {
    if (!IsFinite(x))
    {
      return this->Set(query, -1, -1, MortonKey<Dim>(0), Costs{});
    }
    const MortonKey<Dim> key = this->Tree.GetGrid().GetKey(x.data());
    const FoundLeaf<Dim> leaf = FindLeaf(this->Tree, key,
      this->Searches.GetStartDepth(Comparison::Chosen), this->Numbers.GetReading());
    const vtkIdType id =
      leaf.Exists ? static_cast<vtkIdType>(this->Numbers.Get(this->Tree, leaf)) : -1;
    return this->Set(
      query, id, leaf.Key.GetDepth(), leaf.Key, this->Searches.CountExaminedNodes(key));
  }

private:
  Costs Set(
    vtkIdType query, vtkIdType leafId, int depth, MortonKey<Dim> key, const Costs& costs) const
  {
    this->Ids->SetValue(query, leafId);
    this->Depths->SetValue(query, depth);
    this->Keys->SetValue(query, key.GetValue());
    for (const auto& [search, array] : this->CostArrays)
    {
      array->SetValue(query, static_cast<int>(costs[search]));
    }
    return costs;
  }

  const Octree<Dim>& Tree;
  const LeafNumbers<Dim>& Numbers;
  const Comparison& Searches;
  vtkIdTypeArray* Ids;
  vtkIntArray* Depths;
  vtkTypeUInt64Array* Keys;
  std::vector<std::pair<typename Comparison::Search, vtkIntArray*>> CostArrays;
};
}

template <int Dim>
typename SearchComparison<Dim>::Costs AddQueryArrays(vtkDataSet* queries,
  const PointsAdaptor& points, const PointsOctree<Dim>& octree, const LeafNumbers<Dim>& numbers,
  const SearchComparison<Dim>& searches, const Execution& execution)
{
  using Costs = typename SearchComparison<Dim>::Costs;
  constexpr std::size_t chunkSize = 1024; // Queries that a thread does at a time.
  const QuerySearch<Dim> search(queries, octree.Tree, numbers, searches);
  Costs all{};
  points.Visit(
    [&](auto inSpace)
    {
      const auto span = Project(inSpace, octree.Frame);
      const auto chunks = execution.MapChunks(span.Count, chunkSize,
        [&](std::size_t first, std::size_t last)
        {
          Costs costs{};
          for (std::size_t i = first; i < last; ++i)
          {
            Add(costs, search.Search(static_cast<vtkIdType>(i), GetPosition<Dim>(span, i)));
          }
          return costs;
        });
      for (const Costs& costs : chunks)
      {
        Add(all, costs);
      }
    });
  return all;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template SearchComparison<Dim>::Costs AddQueryArrays(vtkDataSet*, const PointsAdaptor&,          \
    const PointsOctree<Dim>&, const LeafNumbers<Dim>&, const SearchComparison<Dim>&,               \
    const Execution&);
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
#undef HASHEDOCTREE_INSTANTIATE
}
