// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NeighborCells_h
#define hashedoctree_NeighborCells_h

#include "DirectSearch.h"
#include "Lanes.h"

#include <algorithm>

namespace hashedoctree
{
/** At most 2^Dim cells of one depth around one place: one or two along each axis. */
template <int Dim>
struct NeighborCells
{
  Cell<Dim> Lower; ///< The first along each axis.
  Cell<Dim> Upper; ///< The last: the same, or the next one.
  int Depth;

  /** The axes along which there are two, placed as in an octant. */
  unsigned GetAxesApart() const
  {
    unsigned apart = 0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      apart |= (this->Lower[axis] != this->Upper[axis] ? 1U : 0U) << (Dim - 1 - axis);
    }
    return apart;
  }

  /** One of the cells, which is the upper one along the axes of `Corner`, placed as in an octant.
   */
  struct CornerKey
  {
    unsigned Corner;
    MortonKey<Dim> Key;
  };
  using CornerKeys = std::array<CornerKey, std::size_t(1) << Dim>;

  /** Each cell once, in the order of their corners; returns how many there are. */
  std::size_t GetKeys(CornerKeys& keys) const
  {
    const std::uint64_t lower = InterleaveCell<Dim>(this->Lower, this->Depth).GetValue();
    const std::uint64_t upper = InterleaveCell<Dim>(this->Upper, this->Depth).GetValue();
    const unsigned apart = this->GetAxesApart();
    std::size_t count = 0;
    unsigned corner = 0;
    do
    {
      // All bits of the axes along which the corner is the upper one.
      const std::uint64_t bits = Dilation<Dim>::Mask(1) * corner;
      keys[count++] = { corner, MortonKey<Dim>(lower ^ ((lower ^ upper) & bits)) };
      corner = (corner - apart) & apart; // The next subset of these axes.
    } while (corner != 0);
    return count;
  }
};

/**
 * Reaches the cells directly through the table, in the order of their corners. For each that is an
 * internal node it calls onBlock(corner, key, entry). The others lie in leaves, of the same depth
 * or higher: these are found by direct searches from min(startDepth, depth of the cells) (case 3 of
 * paper Algorithm 2, with the depth of E5) and given to onLeaf(leaf), each once however many of the
 * cells it holds, and empty cells of a sparse tree not at all.
 *
 * For each of these leaves, and of the empty cells in their place, it counts one node and those
 * that the direct search examines; what lies below internal nodes is for onBlock to count.
 * Allocates nothing. Thread safe.
 */
template <int Dim, typename Count, typename OnBlock, typename OnLeaf>
HASHEDOCTREE_INLINE void ReachCells(const Octree<Dim>& tree, const NeighborCells<Dim>& cells,
  int startDepth, Count& count, EmptyOctants reading, const OnBlock& onBlock, const OnLeaf& onLeaf)
{
  using Key = MortonKey<Dim>;
  typename NeighborCells<Dim>::CornerKeys keys;
  const std::size_t numberOfCells = cells.GetKeys(keys);
  for (std::size_t i = 0; i < numberOfCells; ++i)
  {
    tree.GetTable().Prefetch(keys[i].Key.GetValue());
  }
  for (std::size_t i = 0; i < numberOfCells; ++i)
  {
    const Key key = keys[i].Key;
    if (key == Key())
    {
      continue; // In a leaf that was found before.
    }
    if (const typename Octree<Dim>::Entry* entry = tree.GetTable().Find(key.GetValue()))
    {
      onBlock(keys[i].Corner, key, *entry);
      continue;
    }
    count.Enter(key);
    count.AddNode();
    const FoundLeaf<Dim> leaf =
      FindLeaf(tree, key.GetFirstAtMaxDepth(), std::min(startDepth, cells.Depth), count, reading);
    const int shift = Dim * (cells.Depth - leaf.Key.GetDepth());
    for (std::size_t other = i + 1; other < numberOfCells; ++other)
    {
      Key& later = keys[other].Key;
      later = later.GetValue() >> shift == leaf.Key.GetValue() ? Key() : later;
    }
    if (leaf.Exists)
    {
      onLeaf(leaf);
    }
  }
}
}

#endif
