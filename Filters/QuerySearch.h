// SPDX-License-Identifier: BSD-3-Clause
#ifndef QuerySearch_h
#define QuerySearch_h

#include "LeafNumberShifts.h"
#include "LeafNumbers.h"
#include "PointsOctree.h"
#include "RangeDepths.h"
#include "SearchComparison.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/** What the searches for one query find, and what they cost. The default is of a query that cannot
 * be searched for. */
template <int Dim>
struct FoundQuery
{
  vtkIdType LeafId = -1;
  MortonKey<Dim> LeafKey{ 0 }; ///< Of the leaf, or of the empty cell in its place.
  typename SearchComparison<Dim>::Costs Costs{};

  int GetDepth() const
  {
    return this->LeafKey == MortonKey<Dim>(0) ? -1 : this->LeafKey.GetDepth();
  }
};

/**
 * The searches for queries in the part of a tree that a process has, as they are in the whole tree.
 * Const members are thread safe. Private to the module.
 */
template <int Dim>
class QuerySearch
{
public:
  using Comparison = SearchComparison<Dim>;

  /** Of several processes all have to call it. O(nodes). Throws std::length_error where the leaves
   * cannot be numbered, and Interrupted. */
  QuerySearch(const PointsOctree<Dim>& octree, const StartDepthOptions& options,
    EmptyOctants reading, const Execution& execution)
    : Tree(octree.Tree)
    , Numbers(octree.Tree, reading)
    , Searches(octree.GetPart(), options)
  {
    if (octree.Processes.AreSeveral())
    {
      this->FindShifts(octree, execution);
    }
  }

  Comparison& GetComparison() { return this->Searches; }

  /** For a position in the part, given its key at MaxDepth. */
  FoundQuery<Dim> Find(MortonKey<Dim> key) const
  {
    FoundQuery<Dim> found;
    const FoundLeaf<Dim> leaf = this->Searches.Find(key, this->Numbers.GetReading(), found.Costs);
    found.LeafId = leaf.Exists ? this->GetNumber(leaf) : -1;
    found.LeafKey = leaf.Key;
    return found;
  }

private:
  vtkIdType GetNumber(const FoundLeaf<Dim>& leaf) const
  {
    const auto number = static_cast<vtkIdType>(this->Numbers.Get(this->Tree, leaf));
    return this->Shifts.empty()
      ? number
      : number + this->Shifts[static_cast<std::size_t>(leaf.Key.GetDepth())];
  }

  void FindShifts(const PointsOctree<Dim>& octree, const Execution& execution)
  {
    const EmptyOctants reading = this->Numbers.GetReading();
    const std::size_t depths = octree.Counts.Leaves.size();
    DepthHistogram own =
      CountNumberedLeaves(CountDepths(this->Tree, octree.Range, execution), reading);
    own.resize(depths);
    const std::vector<std::uint64_t> ofParts = octree.Processes.Gather(own).Values;
    DepthHistogram before(depths, 0);
    for (std::size_t i = 0; i < octree.Processes.GetRank() * depths; ++i)
    {
      before[i % depths] += ofParts[i];
    }
    this->Shifts =
      FindLeafNumberShifts(this->Tree, octree.Range, octree.Counts, before, reading, execution);
  }

  const Octree<Dim>& Tree;
  LeafNumbers<Dim> Numbers;         ///< In this process's tree.
  std::vector<std::int64_t> Shifts; ///< Of LeafNumberShifts.h; empty for a process alone.
  Comparison Searches;
};
}

#endif
