// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_LeafNumbers_h
#define hashedoctree_LeafNumbers_h

#include "DirectSearch.h"

#include <limits>
#include <stdexcept>

namespace hashedoctree
{
/**
 * Numbers for the leaves, from 0 on, ordered by depth, then by Morton key: the order in which
 * ListNodes() lists them. In the sparse reading only leaves that hold points have one. One
 * PointIndex for each internal node. Immutable; thread safe.
 */
template <int Dim>
class LeafNumbers
{
public:
  LeafNumbers() = default;

  /** O(internal nodes). Throws std::length_error where a PointIndex cannot number the leaves, which
   * only empty ones can make so many. */
  LeafNumbers(const Octree<Dim>& tree, EmptyOctants reading)
    : First(tree.GetNumberOfInternalNodes())
    , Reading(reading)
  {
    if (reading == EmptyOctants::Leaves &&
      tree.GetNumberOfLeaves() > std::numeric_limits<PointIndex>::max())
    {
      throw std::length_error(
        "The tree has more leaves than can be numbered; leave out the empty ones.");
    }
    PointIndex number = 0;
    for (std::size_t block = 0; block < this->First.GetSize(); ++block)
    {
      this->First[block] = number;
      number += CountOctants(this->GetLeaves(tree.GetOctants(block)));
    }
  }

  /** The number of a leaf that exists, as found by a search in the tree in the same reading.
   * O(1). */
  PointIndex Get(const Octree<Dim>& tree, const FoundLeaf<Dim>& leaf) const
  {
    if (!tree.IsRootInternal())
    {
      return 0;
    }
    const std::uint32_t before = (1U << leaf.Key.GetOctant()) - 1U;
    return this->First[leaf.ParentBlock] +
      CountOctants(this->GetLeaves(tree.GetOctants(leaf.ParentBlock)) & before);
  }

  EmptyOctants GetReading() const { return this->Reading; }
  std::size_t GetBytes() const { return this->First.GetBytes(); }

private:
  std::uint32_t GetLeaves(typename Octree<Dim>::Octants octants) const
  {
    constexpr std::uint32_t all = (1U << Octree<Dim>::NumberOfOctants) - 1U;
    return (this->Reading == EmptyOctants::Leaves ? all : octants.Occupied) &
      ~static_cast<std::uint32_t>(octants.Internal);
  }

  Buffer<PointIndex> First;
  EmptyOctants Reading = EmptyOctants::Missing;
};
}

#endif
