// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorQueries_h
#define Testing_Benchmarks_LocatorQueries_h

#include "LocatorPeers.h"

namespace locator_benchmark
{
/** Where to search in a data set. */
struct LocatorQueries
{
  /** Points of the data, in random order, moved by about half the distance to their nearest
   * neighbours; where these are at the same place, as among duplicates, not at all. */
  std::vector<Position> Near;
  /** Uniform in the box of the points, in random order. */
  std::vector<Position> Uniform;
  /** Moved points, too, but in runs of neighbours along the Morton curve: what one search has
   * loaded is there for the next, as when a filter asks for each point of a scan. */
  std::vector<Position> Ordered;
  /** Points of the data, in random order. */
  std::vector<Position> Points;
  /** Above the box along z by ten times its largest side. */
  std::vector<Position> Above;
  /** Slightly above the median distance from near positions to their 30th closest point, of those
   * where it is above 0; 1 if there are none. */
  double Radius;

  const std::vector<Position>& Get(const std::string& kind) const
  {
    return kind == "near" ? this->Near
      : kind == "uniform" ? this->Uniform
      : kind == "ordered" ? this->Ordered
      : kind == "points"  ? this->Points
                          : this->Above;
  }
};

/** `count` positions of each kind. `locator` is one of the data. */
LocatorQueries MakeQueries(const LocatorData& data, LocatorPeer& locator, std::size_t count);
}

#endif
