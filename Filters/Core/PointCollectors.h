// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointCollectors_h
#define hashedoctree_PointCollectors_h

#include "PointSearch.h"

#include <algorithm>

namespace hashedoctree
{
// What a walk hands its points to. A collector has
// - GetBound2(): the squared radius beyond which points are of no use to it, now;
// - Add(dist2, least, ids, count): takes points of a leaf, their squared distances and the least of
//   these;
// - HasFixedBall: whether the bound never changes;
// - TakesWholeNodes: whether it also has
// - AddAll(ids, count): takes points that are known to be within. Only with a fixed ball.
// Private to PointSearch.cxx.

/** The closest point so far. */
class ClosestOne
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;

  /** `select` is DistanceKernels::Select. */
  ClosestOne(double radius2, std::uint64_t (*select)(const double*, std::size_t, double))
    : Dist2(radius2)
    , Select(select)
  {
  }
  double GetBound2() const { return this->Dist2; }
  void Add(const double* dist2, double least, const PointIndex* ids, std::size_t count)
  {
    // Ids are far away in memory, and looked at only where distances are equal.
    if (least < this->Dist2)
    {
      this->Dist2 = least;
      this->Id = nullptr;
    }
    for (std::uint64_t places = this->Select(dist2, count, least); places != 0;
         places &= places - 1)
    {
      const PointIndex* id = ids + __builtin_ctzll(places);
      if (this->Id == nullptr || *id < *this->Id)
      {
        this->Id = id;
      }
    }
  }
  bool HasFound() const { return this->Id != nullptr; }
  FoundPoint GetBest() const { return { this->Dist2, *this->Id }; }

private:
  double Dist2;
  std::uint64_t (*Select)(const double*, std::size_t, double);
  const PointIndex* Id = nullptr;
};

/** The closest few so far, in order; up to MostWanted, where that beats a heap. */
class ClosestFew
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;
  static constexpr std::size_t MostWanted = 64;

  /** `wanted` in [1, MostWanted]. */
  explicit ClosestFew(std::size_t wanted)
    : Wanted(wanted)
  {
  }
  double GetBound2() const { return this->Bound2; }
  void Add(const double* dist2, double, const PointIndex* ids, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (dist2[i] <= this->Bound2)
      {
        this->Insert(dist2[i], ids[i]);
      }
    }
  }
  void CopyTo(std::vector<FoundPoint>& found) const
  {
    found.resize(this->Size);
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      found[i] = { this->Dist2[i], this->Ids[i] };
    }
  }

private:
  void Insert(double dist2, PointIndex id)
  {
    std::size_t place = this->Size;
    if (this->Size < this->Wanted)
    {
      ++this->Size;
    }
    else if (dist2 == this->Bound2 && id > this->Ids[place - 1])
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
    for (; place > 0 && this->Dist2[place - 1] == dist2 && this->Ids[place - 1] > id; --place)
    {
      this->Ids[place] = this->Ids[place - 1];
      this->Dist2[place] = dist2;
    }
    this->Dist2[place] = dist2;
    this->Ids[place] = id;
    if (this->Size == this->Wanted)
    {
      this->Bound2 = this->Dist2[this->Size - 1];
    }
  }

  std::size_t Wanted;
  std::size_t Size = 0;
  double Bound2 = std::numeric_limits<double>::infinity();
  double Dist2[MostWanted];
  PointIndex Ids[MostWanted];
};

/** The closest so far, any number of them: a heap with the farthest on top. */
class ClosestMany
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;

  ClosestMany(std::size_t wanted, std::vector<FoundPoint>& found)
    : Wanted(wanted)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Bound2; }
  void Add(const double* dist2, double, const PointIndex* ids, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (dist2[i] <= this->Bound2)
      {
        this->Add({ dist2[i], ids[i] });
      }
    }
  }
  void PutInOrder() { std::sort_heap(this->Found.begin(), this->Found.end()); }

private:
  void Add(const FoundPoint& point)
  {
    if (this->Found.size() == this->Wanted)
    {
      if (!(point < this->Found.front()))
      {
        return;
      }
      std::pop_heap(this->Found.begin(), this->Found.end());
      this->Found.pop_back();
    }
    this->Found.push_back(point);
    std::push_heap(this->Found.begin(), this->Found.end());
    if (this->Found.size() == this->Wanted)
    {
      this->Bound2 = this->Found.front().Dist2;
    }
  }

  std::size_t Wanted;
  double Bound2 = std::numeric_limits<double>::infinity();
  std::vector<FoundPoint>& Found;
};

/** All that is within a fixed radius, with the distances. */
class AllMeasured
{
public:
  static constexpr bool HasFixedBall = true;
  static constexpr bool TakesWholeNodes = false;

  AllMeasured(double radius2, std::vector<FoundPoint>& found)
    : Radius2(radius2)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Radius2; }
  void Add(const double* dist2, double, const PointIndex* ids, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (dist2[i] <= this->Radius2)
      {
        this->Found.push_back({ dist2[i], ids[i] });
      }
    }
  }

private:
  double Radius2;
  std::vector<FoundPoint>& Found;
};

/** All that is within a fixed radius. */
class AllWithin
{
public:
  static constexpr bool HasFixedBall = true;
  static constexpr bool TakesWholeNodes = true;

  AllWithin(double radius2, std::vector<PointIndex>& found)
    : Radius2(radius2)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Radius2; }
  void Add(const double* dist2, double, const PointIndex* ids, std::size_t count)
  {
    const std::size_t before = this->Found.size();
    this->Found.resize(before + count);
    PointIndex* end = this->Found.data() + before;
    for (std::size_t i = 0; i < count; ++i)
    {
      *end = ids[i];
      end += dist2[i] <= this->Radius2 ? 1 : 0;
    }
    this->Found.resize(static_cast<std::size_t>(end - this->Found.data()));
  }
  void AddAll(const PointIndex* ids, std::size_t count)
  {
    this->Found.insert(this->Found.end(), ids, ids + count);
  }

private:
  double Radius2;
  std::vector<PointIndex>& Found;
};
}

#endif
