// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorCheck_h
#define Testing_Benchmarks_LocatorCheck_h

#include "LocatorTiming.h"

namespace locator_benchmark
{
struct CheckResult
{
  std::size_t Checked = 0;
  std::size_t Different = 0;
};

/** The right answers to one question, as sorted squared distances: equally near points may change
 * places. They are ours, of which a few are compared with every point. */
class LocatorCheck
{
public:
  LocatorCheck(const LocatorData& data, const Question& question, LocatorPeer& ours);

  /** Whether ours are those of a comparison with every point. */
  bool IsSound() const { return this->Sound; }

  /** Compares the answers of a peer, of a slow one only some. */
  CheckResult Check(LocatorPeer& peer) const;

  /** Points in an answer, on average. */
  double GetMeanHits() const;

private:
  using Distances2 = std::vector<double>;

  Distances2 Measure(std::size_t position, const std::vector<vtkIdType>& ids) const;
  Distances2 CompareWithEveryPoint(const Position& x) const;
  bool CompareAHandful() const;

  const LocatorData& Data;
  Question What;
  std::vector<Distances2> Right;
  bool Sound;
};
}

#endif
