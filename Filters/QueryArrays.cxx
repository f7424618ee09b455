// SPDX-License-Identifier: BSD-3-Clause
#include "QueryArrays.h"

#include "ResizeArray.h"

#include "vtkNew.h"
#include "vtkPointData.h"

namespace hashedoctree
{
namespace
{
/** Adds an array to the data set, which then owns it; one of the same name goes, with its role
 * among the attributes. */
template <typename Array>
Array* AddPointArray(vtkDataSet* dataSet, const char* name)
{
  const auto array = MakeArray<Array>(name, static_cast<std::size_t>(dataSet->GetNumberOfPoints()));
  dataSet->GetPointData()->RemoveArray(name);
  dataSet->GetPointData()->AddArray(array);
  return array;
}
}

template <int Dim>
QueryArrays<Dim>::QueryArrays(vtkDataSet* queries)
  : Ids(AddPointArray<vtkIdTypeArray>(queries, "LeafId"))
  , Depths(AddPointArray<vtkIntArray>(queries, "LeafDepth"))
  , Keys(AddPointArray<vtkTypeUInt64Array>(queries, "LeafKey"))
{
  using Comparison = SearchComparison<Dim>;
  for (const auto& [search, name] : { std::pair(Comparison::Chosen, "HitCost"),
         std::pair(Comparison::Root, "RootCost"), std::pair(Comparison::Median, "MedianCost"),
         std::pair(Comparison::Mean, "MeanCost"), std::pair(Comparison::Local, "LocalCost"),
         std::pair(Comparison::DecisionTree, "DecisionTreeCost") })
  {
    this->Costs.emplace_back(search, AddPointArray<vtkIntArray>(queries, name));
  }
  queries->GetPointData()->SetActiveScalars("HitCost");
}

template <int Dim>
void QueryArrays<Dim>::Set(vtkIdType query, const FoundQuery<Dim>& found) const
{
  this->Ids->SetValue(query, found.LeafId);
  this->Depths->SetValue(query, found.GetDepth());
  this->Keys->SetValue(query, found.LeafKey.GetValue());
  for (const auto& [search, array] : this->Costs)
  {
    array->SetValue(query, static_cast<int>(found.Costs[search]));
  }
}

template class QueryArrays<2>;
template class QueryArrays<3>;
}
