// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_LeafNumbers_h
#define hashedoctree_LeafNumbers_h

#include "Octree.h"

namespace hashedoctree
{
/**
 * Numbers for the leaves that hold points, from 0 on, ordered by depth, then by Morton key: the
 * order in which ListNodes() lists them. One PointIndex for each internal node. Immutable; thread
 * safe.
 */
template <int Dim>
class LeafNumbers
{
public:
  LeafNumbers() = default;

  /** O(internal nodes). */
  explicit LeafNumbers(const Octree<Dim>& tree)
    : First(tree.GetNumberOfInternalNodes())
  {
    PointIndex number = 0;
    for (std::size_t block = 0; block < this->First.GetSize(); ++block)
    {
      this->First[block] = number;
      number += CountOctants(GetLeaves(tree.GetBlock(block)));
    }
  }

  /** The number of a leaf that holds points, given the block that describes it. */
  PointIndex Get(
    const typename Octree<Dim>::Block& block, std::size_t blockNumber, unsigned octant) const
  {
    return this->First[blockNumber] + CountOctants(GetLeaves(block) & ((1U << octant) - 1U));
  }

  std::size_t GetBytes() const { return this->First.GetBytes(); }

private:
  static std::uint32_t GetLeaves(const typename Octree<Dim>::Block& block)
  {
    return block.Occupied & ~static_cast<std::uint32_t>(block.Internal);
  }

  Buffer<PointIndex> First;
};
}

#endif
