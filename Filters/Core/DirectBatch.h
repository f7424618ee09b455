// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DirectBatch_h
#define hashedoctree_DirectBatch_h

#include "DirectSearch.h"
#include "PointKeys.h"

#include <array>

namespace hashedoctree
{
/**
 * Direct searches for the positions `first` to `last` - 1 of a span (PointSpan, PlaneSpan,
 * KeySpan), one after the other, for each of which it calls onLeaf(i, leaf) with what FindLeaf()
 * finds. Where a search begins in the table follows from its position alone. So the machine is
 * asked for the beginnings of a group of searches before the first of them waits for its own: the
 * more of the tree is outside of the caches the more that saves.
 *
 * Positions are placed as by Grid::GetKey(), also those that are outside the root or not finite.
 * Other arguments, and the cost, as of FindLeaf(). Allocates nothing. Thread safe.
 */
template <int Dim, typename Points, typename OnLeaf>
void FindLeaves(const Octree<Dim>& tree, const Points& positions, std::size_t first,
  std::size_t last, int startDepth, const OnLeaf& onLeaf,
  EmptyOctants reading = EmptyOctants::Leaves)
{
  // Flat: a call for each search would take a fifth of the time where there are few nodes.
  const auto findAll = [&](const auto& prefetch) __attribute__((flatten))
  {
    constexpr std::size_t groupSize = 16; // Loads that a machine has on their way at a time.
    std::array<MortonKey<Dim>, groupSize> keys;
    NoCount examined;
    for (; first < last; first += groupSize)
    {
      const std::size_t count = std::min(groupSize, last - first);
      GetKeys<Dim>(tree.GetGrid(), positions, first, count, keys.data());
      for (std::size_t i = 0; i < count; ++i)
      {
        prefetch(keys[i], std::max(startDepth - 1, 0));
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        onLeaf(
          first + i, FindLeafPrefetching(tree, keys[i], startDepth, examined, reading, prefetch));
      }
    }
  };
  // Chosen once, instead of in each search.
  const auto& table = tree.GetTable();
  using Table = std::decay_t<decltype(table)>;
  table.IsCached() ? findAll(PrefetchNone()) : findAll(PrefetchNodes<Table>{ table });
}
}

#endif
