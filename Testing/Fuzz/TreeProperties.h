// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_TreeProperties_h
#define Testing_Fuzz_TreeProperties_h

#include "DepthStatistics.h"
#include "TreeOptions.h"

/** What a tree for point searches is made with, apart from its points. */
struct TreeProperties
{
  hashedoctree::Octree<3>::Options Options;
  hashedoctree::StartDepthOptions StartDepths;

  explicit TreeProperties(FuzzBytes& bytes)
    : Options(ReadTreeOptions<3>(bytes))
  {
    constexpr unsigned depths = hashedoctree::MortonKey<3>::MaxDepth + 1;
    const unsigned start = bytes.ReadByte();
    this->StartDepths = { static_cast<hashedoctree::StartDepthModel>(start % 5),
      static_cast<hashedoctree::FrequencyModel>(start / 5 % 3),
      static_cast<int>(start / 5 % depths) };
  }
};

#endif
