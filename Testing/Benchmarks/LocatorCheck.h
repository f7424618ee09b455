// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorCheck_h
#define Testing_Benchmarks_LocatorCheck_h

#include "LocatorTiming.h"

namespace locator_benchmark
{
/** The right answers to one question, as sorted squared distances: equally near points may change
 * places. They are ours, of which a few are compared with every point. */
class LocatorCheck
{
public:
  static constexpr std::size_t NumberOfPositions = 50;

  LocatorCheck(const LocatorData& data, const Question& question, LocatorPeer& ours);

  /** Whether ours are those of a comparison with every point. */
  bool IsSound() const { return this->Sound; }

  /** At how many of the positions the peer answers something else. */
  std::size_t CountDifferences(LocatorPeer& peer) const;

  /** Points in an answer, on average. */
  double GetMeanHits() const;

private:
  using Distances2 = std::vector<double>;

  std::vector<Distances2> Measure(LocatorPeer& peer, std::size_t numberOfPositions) const;
  Distances2 CompareWithEveryPoint(const Position& x) const;
  bool CompareAHandful() const;

  const LocatorData& Data;
  Question What;
  std::size_t Checked;
  std::vector<Distances2> Right;
  bool Sound;
};
}

#endif
