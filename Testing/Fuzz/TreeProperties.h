// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_TreeProperties_h
#define Testing_Fuzz_TreeProperties_h

#include "DepthStatistics.h"
#include "FuzzBytes.h"

#include <iterator>

/** What a tree is made with, apart from its points. */
struct TreeProperties
{
  std::size_t MaxPointsPerLeaf;
  int MaxDepth;
  hashedoctree::StartDepthOptions StartDepths;

  explicit TreeProperties(FuzzBytes& bytes)
  {
    constexpr std::size_t buckets[] = { 1, 2, 3, 4, 8, 16, 40, 100 };
    constexpr unsigned depths = hashedoctree::MortonKey<3>::MaxDepth + 1;
    this->MaxPointsPerLeaf = buckets[bytes.ReadByte() % std::size(buckets)];
    const unsigned depth = bytes.ReadByte(); // Mostly the default.
    this->MaxDepth = static_cast<int>(depth < 128 ? depths - 1 : depth % depths);
    const unsigned start = bytes.ReadByte();
    this->StartDepths = { static_cast<hashedoctree::StartDepthModel>(start % 5),
      static_cast<hashedoctree::FrequencyModel>(start / 5 % 3),
      static_cast<int>(start / 5 % depths) };
  }
};

#endif
