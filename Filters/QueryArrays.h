// SPDX-License-Identifier: BSD-3-Clause
#ifndef QueryArrays_h
#define QueryArrays_h

#include "QuerySearch.h"

#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkTypeUInt64Array.h"

#include <utility>
#include <vector>

namespace hashedoctree
{
/** What is found for the points of a data set: the point arrays LeafId, LeafDepth, LeafKey, HitCost
 * (active), RootCost, MedianCost, MeanCost, LocalCost and DecisionTreeCost of
 * vtkHashedOctreeLocateFilter. Private to the module. */
template <int Dim>
class QueryArrays
{
public:
  /** Adds the arrays to the data set, with no values yet. */
  explicit QueryArrays(vtkDataSet* queries);

  /** Different queries may be set at the same time. */
  void Set(vtkIdType query, const FoundQuery<Dim>& found) const;

private:
  using Search = typename SearchComparison<Dim>::Search;

  vtkIdTypeArray* Ids;
  vtkIntArray* Depths;
  vtkTypeUInt64Array* Keys;
  std::vector<std::pair<Search, vtkIntArray*>> Costs;
};
}

#endif
