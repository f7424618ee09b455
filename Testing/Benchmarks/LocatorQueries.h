// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorQueries_h
#define Testing_Benchmarks_LocatorQueries_h

#include "LocatorPeers.h"

namespace locator_benchmark
{
/** Where to search in a data set, in random order. */
struct LocatorQueries
{
  /** Points of the data, moved by about half the distance to their nearest neighbours. */
  std::vector<Position> Near;
  /** Uniform in the box of the points. */
  std::vector<Position> Uniform;
  /** Median distance from the near positions to their 30th closest point. */
  double Radius;

  const std::vector<Position>& Get(const std::string& kind) const
  {
    return kind == "near" ? this->Near : this->Uniform;
  }
};

/** `count` positions of each kind. `locator` is one of the data. */
LocatorQueries MakeQueries(const LocatorData& data, LocatorPeer& locator, std::size_t count);
}

#endif
