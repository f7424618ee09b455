// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointCollectors_h
#define hashedoctree_PointCollectors_h

#include "PointSearch.h"

#include <algorithm>
#include <limits>

namespace hashedoctree
{
// What a walk hands its points to. A collector has
// - GetBound2(): the squared radius beyond which points are of no use to it, now;
// - Add(dist2, least, ids, count): takes points of a leaf, their squared distances and the least of
//   these, which is within the bound;
// - TakesWithin: whether Add() has, in place of the least, the mask of those within the bound;
// - NeedsIds(): whether it is likely to read ids of the points that it is handed next;
// - HasFixedBall: whether the bound never changes; if it does, it also has
// - GetMostAtOnePlace(): of points at one place, taken by id, how many of the first are of use;
// - TakesWholeNodes: whether it also has
// - AddAll(ids, count): takes points that are known to be within. Only with a fixed ball;
// - TakesPromises: whether it also has
// - HasFound(): whether it has any point, and
// - Promise(dist2): a point that it will be handed is no further than this.
// Private to PointSearch.cxx.

/** The closest point so far. */
class ClosestOne
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;
  static constexpr bool TakesWithin = false;
  static constexpr bool TakesPromises = true;

  /** `select` is PointKernels::Select. */
  ClosestOne(double radius2, std::uint64_t (*select)(const double*, std::size_t, double))
    : Dist2(radius2)
    , Select(select)
  {
  }
  double GetBound2() const { return this->Dist2; }
  /** Most leaves after the first have nothing nearer. */
  bool NeedsIds() const { return !this->HasFound(); }
  std::size_t GetMostAtOnePlace() const { return 1; }
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
        __builtin_prefetch(id); // While the search goes on.
      }
    }
  }
  void Promise(double dist2) { this->Dist2 = std::min(this->Dist2, dist2); }
  bool HasFound() const { return this->Id != nullptr; }
  FoundPoint GetBest() const { return { this->Dist2, *this->Id }; }

private:
  double Dist2;
  std::uint64_t (*Select)(const double*, std::size_t, double);
  const PointIndex* Id = nullptr;
};

/** Adds the points of the mask to those that were found. */
inline void Append(
  const double* dist2, std::uint64_t within, const PointIndex* ids, std::vector<FoundPoint>& found)
{
  for (; within != 0; within &= within - 1)
  {
    const int i = __builtin_ctzll(within);
    found.push_back({ dist2[i], ids[i] });
  }
}

/** The closest so far, any number of them, among others: when these are half as many, all farther
 * ones are dropped, so that each point takes O(1) on average. */
class ClosestMany
{
public:
  static constexpr bool HasFixedBall = false;
  static constexpr bool TakesWholeNodes = false;
  static constexpr bool TakesWithin = true;
  static constexpr bool TakesPromises = false;

  /** `wanted` at least 1. */
  ClosestMany(std::size_t wanted, std::vector<FoundPoint>& found)
    : Wanted(wanted)
    , Most(wanted)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Bound2; }
  static constexpr bool NeedsIds() { return true; }
  std::size_t GetMostAtOnePlace() const { return this->Wanted; }
  void Add(const double* dist2, std::uint64_t within, const PointIndex* ids, std::size_t)
  {
    Append(dist2, within, ids, this->Found);
    if (this->Found.size() >= this->Most)
    {
      this->DropFarther();
      this->Most = this->Wanted + this->Wanted / 2;
    }
  }
  void PutInOrder()
  {
    if (this->Found.size() > this->Wanted)
    {
      this->DropFarther();
    }
    std::sort(this->Found.begin(), this->Found.end());
  }

private:
  void DropFarther()
  {
    const auto last = this->Found.begin() + static_cast<std::ptrdiff_t>(this->Wanted - 1);
    std::nth_element(this->Found.begin(), last, this->Found.end());
    this->Bound2 = last->Dist2;
    this->Found.resize(this->Wanted);
  }

  std::size_t Wanted;
  std::size_t Most; ///< As many make the farther ones be dropped.
  double Bound2 = std::numeric_limits<double>::infinity();
  std::vector<FoundPoint>& Found;
};

/** All that is within a fixed radius, with the distances. */
class AllMeasured
{
public:
  static constexpr bool HasFixedBall = true;
  static constexpr bool TakesWholeNodes = false;
  static constexpr bool TakesWithin = true;
  static constexpr bool TakesPromises = false;

  AllMeasured(double radius2, std::vector<FoundPoint>& found)
    : Radius2(radius2)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Radius2; }
  static constexpr bool NeedsIds() { return true; }
  void Add(const double* dist2, std::uint64_t within, const PointIndex* ids, std::size_t)
  {
    Append(dist2, within, ids, this->Found);
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
  static constexpr bool TakesWithin = true;
  static constexpr bool TakesPromises = false;

  /** `copy` is PointKernels::CopySelected. */
  AllWithin(double radius2, std::vector<PointIndex>& found,
    std::size_t (*copy)(const PointIndex*, std::size_t, std::uint64_t, PointIndex*))
    : Radius2(radius2)
    , Copy(copy)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Radius2; }
  static constexpr bool NeedsIds() { return true; }
  void Add(const double*, std::uint64_t within, const PointIndex* ids, std::size_t count)
  {
    const std::size_t before = this->Found.size();
    this->Found.resize(before + MostAtOnce);
    this->Found.resize(before + this->Copy(ids, count, within, this->Found.data() + before));
  }
  void AddAll(const PointIndex* ids, std::size_t count)
  {
    this->Found.insert(this->Found.end(), ids, ids + count);
  }

private:
  static constexpr std::size_t MostAtOnce = 64; ///< One bit each.

  double Radius2;
  std::size_t (*Copy)(const PointIndex*, std::size_t, std::uint64_t, PointIndex*);
  std::vector<PointIndex>& Found;
};
}

#endif
