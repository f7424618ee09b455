// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_TreeOptions_h
#define Testing_Fuzz_TreeOptions_h

#include "FuzzBytes.h"
#include "Octree.h"

#include <iterator>

/** What an octree is made with, apart from its points. */
template <int Dim>
typename hashedoctree::Octree<Dim>::Options ReadTreeOptions(FuzzBytes& bytes)
{
  constexpr std::size_t maxima[] = { 1, 2, 3, 4, 8, 16, 40, 100 };
  constexpr unsigned depths = hashedoctree::MortonKey<Dim>::MaxDepth + 1;
  const std::size_t maxPointsPerLeaf = maxima[bytes.ReadByte() % std::size(maxima)];
  const unsigned depth = bytes.ReadByte(); // Mostly the default.
  return { maxPointsPerLeaf, static_cast<int>(depth < 128 ? depths - 1 : depth % depths) };
}

#endif
