// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_ClosestFew_h
#define hashedoctree_ClosestFew_h

#include "PointSearch.h"
#include "RankedPoints.h"

#include <limits>

namespace hashedoctree
{
/**
 * A collector (PointCollectors.h) of the closest few points so far, in the order of their squared
 * distances, equal ones by id; up to MostWanted, where that beats choosing among many. Up to
 * MostInRegisters are kept in the machine's vectors where it has AVX2: a point is put in its place
 * by comparing it with all others at once. More are merged leaf by leaf (RankedPoints.h). All ways
 * give the same points in the same order.
 */
class ClosestFew
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;
  static constexpr bool TakesWithin = true;
  static constexpr bool TakesPromises = false;
  static constexpr std::size_t MostWanted = RankedPoints::MostKept;
  static constexpr std::size_t MostInRegisters = 8;

  /** PointKernels::Select. */
  using SelectPoints = std::uint64_t (*)(const double* dist2, std::size_t count, double limit);

  /** `wanted` in [1, MostWanted]. Vectors must only be asked for where HasVectors(). */
  ClosestFew(std::size_t wanted, SelectPoints select, bool useVectors = HasVectors());

  /** Whether the machine has AVX2. */
  static bool HasVectors();

  double GetBound2() const { return this->Bound2; }
  static constexpr bool NeedsIds() { return true; }
  std::size_t GetMostAtOnePlace() const { return this->Wanted; }

  /** `ids` must stay as they are until CopyTo(); `dist2` and `within` are what
   * PointKernels::MeasurePointsWithin() gives, of at most RankedPoints::MostAdded. */
  void Add(const double* dist2, std::uint64_t within, const PointIndex* ids, std::size_t count);
  void CopyTo(std::vector<FoundPoint>& found) const;

private:
  bool UsesRegisters() const { return this->UseVectors && this->Wanted <= MostInRegisters; }
  void AddInRegisters(
    const double* dist2, std::uint64_t within, const PointIndex* ids, std::size_t count);
  void SetBound()
  {
    if (this->Kept.Size >= this->Wanted)
    {
      this->Bound2 = this->Kept.Dist2[this->Wanted - 1];
    }
  }

  std::size_t Wanted;
  [[maybe_unused]] SelectPoints Select; ///< Only vectors need it.
  bool UseVectors;
  double Bound2 = std::numeric_limits<double>::infinity();
  RankedPoints Kept; ///< In registers up to MostInRegisters, also where fewer are wanted.
};
}

#endif
