// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_ClosestFew_h
#define hashedoctree_ClosestFew_h

#include "PointSearch.h"

namespace hashedoctree
{
/**
 * A collector (PointCollectors.h) of the closest few points so far, in the order of their squared
 * distances, equal ones by id; up to MostWanted, where that beats a heap. Up to MostInVectors are
 * kept in the machine's vectors where it has AVX2: a point is put in its place by comparing it with
 * all others at once, without a branch whose way is hard to foresee. Both ways give the same points
 * in the same order.
 */
class ClosestFew
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;
  static constexpr std::size_t MostWanted = 64;
  static constexpr std::size_t MostInVectors = 8;

  /** DistanceKernels::Select. */
  using SelectPoints = std::uint64_t (*)(const double* dist2, std::size_t count, double limit);

  /** `wanted` in [1, MostWanted]. Vectors must only be asked for where HasVectors(). */
  ClosestFew(std::size_t wanted, SelectPoints select, bool useVectors = HasVectors());

  /** Whether the machine has them. */
  static bool HasVectors();

  double GetBound2() const { return this->Bound2; }

  /** `ids` must stay as they are until CopyTo(); `dist2` is what DistanceKernels::ToPoints() has
   * written, of at most 64 points. */
  void Add(const double* dist2, double, const PointIndex* ids, std::size_t count)
  {
    if (this->UseVectors)
    {
      this->AddWithVectors(dist2, ids, count);
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (dist2[i] <= this->Bound2)
      {
        this->Insert(dist2[i], ids + i, this->Wanted);
        this->SetBound();
      }
    }
  }
  void CopyTo(std::vector<FoundPoint>& found) const;

private:
  void AddWithVectors(const double* dist2, const PointIndex* ids, std::size_t count);
  /** Puts a point in its place among at most `most`, if it is not beyond them. */
  void Insert(double dist2, const PointIndex* id, std::size_t most)
  {
    std::size_t place = this->Size;
    if (this->Size < most)
    {
      ++this->Size;
    }
    else if (dist2 > this->Dist2[place - 1] ||
      (dist2 == this->Dist2[place - 1] && *id > *this->Ids[place - 1]))
    {
      return;
    }
    else
    {
      --place;
    }
    for (; place > 0 && this->Dist2[place - 1] > dist2; --place)
    {
      this->Dist2[place] = this->Dist2[place - 1];
      this->Ids[place] = this->Ids[place - 1];
    }
    for (; place > 0 && this->Dist2[place - 1] == dist2 && *this->Ids[place - 1] > *id; --place)
    {
      this->Dist2[place] = dist2;
      this->Ids[place] = this->Ids[place - 1];
    }
    this->Dist2[place] = dist2;
    this->Ids[place] = id;
  }
  void SetBound()
  {
    if (this->Size >= this->Wanted)
    {
      this->Bound2 = this->Dist2[this->Wanted - 1];
    }
  }

  std::size_t Wanted;
  SelectPoints Select;
  bool UseVectors;
  std::size_t Size = 0; ///< With vectors up to MostInVectors, also where fewer are wanted.
  double Bound2 = std::numeric_limits<double>::infinity();
  double Dist2[MostWanted];
  const PointIndex* Ids[MostWanted]; ///< Far away in memory, and looked at as late as can be.
};
}

#endif
