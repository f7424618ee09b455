// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocatedQueries_h
#define LocatedQueries_h

#include "Buffer.h"
#include "DuplicatePoints.h"
#include "Parted.h"
#include "QueryArrays.h"
#include "QuerySearch.h"

#include "vtkDataSet.h"

#include <cstddef>
#include <vector>

namespace hashedoctree
{
/**
 * One block of queries on the way through a tree. Each is searched for in the part of the tree that
 * it is in: of several processes, all of which have to call the same members, that with the part
 * gets the query's key from that with the query, and sends back what is found. Queries that are
 * another piece's are searched for, too, but count there. Instantiated for 2 and 3 dimensions.
 * Private to the module.
 */
template <int Dim>
class LocatedQueries
{
public:
  using Costs = typename SearchComparison<Dim>::Costs;

  /** Takes the points of a data set, null where this process has none of the block. O(n). The
   * arguments must outlive this. Throws Interrupted. */
  LocatedQueries(vtkDataSet* queries, const PointsOctree<Dim>& octree, const Execution& execution);

  /** Those of this process that count. */
  std::size_t GetNumberOfCounted() const { return this->Counted; }
  /** Of those that count, the ones that are not searched for, since they are not finite. */
  std::size_t GetNumberOfSkipped() const { return this->Skipped; }

  /** How many queries that count, of all processes, lie in leaves of each depth, from 0 to the
   * tree's deepest. As MeasureQueryDepths(). */
  DepthHistogram MeasureDepths(const Execution& execution) const;

  /** Searches for all queries, and adds what is found (QueryArrays) to a data set that has the
   * points of the block. Returns the nodes that each search examines for the queries that count, of
   * all processes together. Throws Interrupted, with a data set that must be emptied. The same
   * whatever the threads. */
  Costs Search(
    const QuerySearch<Dim>& search, vtkDataSet* output, const Execution& execution) const;

private:
  using Keys = std::vector<MortonKey<Dim>>;

  void Count(const Execution& execution);
  Keys TakeFinite(const DuplicatePoints& leftOut, const Execution& execution) const;
  Costs SearchWithOthers(
    const QuerySearch<Dim>& search, vtkDataSet* output, const Execution& execution) const;
  void Take(std::size_t query, const FoundQuery<Dim>& found, const QueryArrays<Dim>& arrays,
    Costs& sums) const;

  const PointsOctree<Dim>& Tree;
  DuplicatePoints Others; ///< Another piece's.
  std::size_t Counted = 0;
  std::size_t Skipped = 0;
  /** The key of each query of this process, 0 where it is not finite. */
  Buffer<MortonKey<Dim>> Own;
  /** Those that are searched for here, by the process that has the queries; not of one alone. */
  Parted<MortonKey<Dim>> Taken;
};
}

#endif
