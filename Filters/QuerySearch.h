// SPDX-License-Identifier: BSD-3-Clause
#ifndef QuerySearch_h
#define QuerySearch_h

#include "LeafNumbers.h"
#include "PointsOctree.h"
#include "RangeDepths.h"
#include "SearchComparison.h"

#include "vtkType.h"

#include <algorithm>
#include <numeric>
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
      this->FindNumbersElsewhere(octree, execution);
    }
  }

  Comparison& GetComparison() { return this->Searches; }
  const Comparison& GetComparison() const { return this->Searches; }

  /** For a position in the part, given its key at MaxDepth. */
  FoundQuery<Dim> Find(MortonKey<Dim> key) const
  {
    const FoundLeaf<Dim> leaf = FindLeaf(this->Tree, key,
      this->Searches.GetStartDepth(Comparison::Chosen), this->Numbers.GetReading());
    return { leaf.Exists ? this->GetNumber(leaf) : -1, leaf.Key,
      this->Searches.CountExaminedNodes(key) };
  }

private:
  vtkIdType GetNumber(const FoundLeaf<Dim>& leaf) const
  {
    const auto number = static_cast<vtkIdType>(this->Numbers.Get(this->Tree, leaf));
    return this->NumbersElsewhere.empty()
      ? number
      : number + this->NumbersElsewhere[static_cast<std::size_t>(leaf.Key.GetDepth())];
  }

  /** How many leaves there are, and have numbers, at each depth of the whole tree. */
  std::vector<vtkIdType> CountNumbered(const DepthCounts& counts, std::size_t depths) const
  {
    std::vector<vtkIdType> numbered(depths, 0);
    for (std::size_t depth = 0; depth < counts.Leaves.size(); ++depth)
    {
      const bool all = this->Numbers.GetReading() == EmptyOctants::Leaves;
      numbered[depth] =
        static_cast<vtkIdType>(counts.Leaves[depth] - (all ? 0 : counts.EmptyLeaves[depth]));
    }
    return numbered;
  }

  /** At each depth the leaves in the part, and the one that reaches into it from before, stand side
   * by side in both orders, so that one difference holds for all. */
  void FindNumbersElsewhere(const PointsOctree<Dim>& octree, const Execution& execution)
  {
    const std::size_t depths = octree.Counts.Leaves.size();
    CurveRange<Dim> before;
    before.Last = MortonKey<Dim>(octree.Range.First.GetValue() - 1);
    const auto all = this->CountNumbered(octree.Counts, depths);
    const auto here = this->CountNumbered(this->Tree.GetDepthCounts(), depths);
    const auto hereBefore = this->CountNumbered(CountDepths(this->Tree, before, execution), depths);
    const auto ofParts = octree.Processes.Gather(
      this->CountNumbered(CountDepths(this->Tree, octree.Range, execution), depths));
    vtkIdType difference = 0; // Of the leaves higher up.
    for (std::size_t depth = 0; depth < depths; ++depth)
    {
      vtkIdType allBefore = 0;
      for (std::size_t part = 0; part < octree.Processes.GetRank(); ++part)
      {
        allBefore += ofParts[part][depth];
      }
      this->NumbersElsewhere.push_back(difference + allBefore - hereBefore[depth]);
      difference += all[depth] - here[depth];
    }
  }

  const Octree<Dim>& Tree;
  LeafNumbers<Dim> Numbers;                ///< In this process's tree.
  std::vector<vtkIdType> NumbersElsewhere; ///< By depth: what they lack; empty of a whole tree.
  Comparison Searches;
};
}

#endif
