// SPDX-License-Identifier: BSD-3-Clause
#include "RankedPoints.h"

#include "Lanes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <type_traits>

namespace hashedoctree
{
namespace
{
/** What distances are compared by: all of a distance, or its upper half; and ranks as wide. */
using Whole = double;
using UpperHalf = std::int32_t;
template <typename Key>
using RankOf = std::conditional_t<sizeof(Key) == 4, std::int32_t, std::int64_t>;

template <typename Vector, typename T>
HASHEDOCTREE_INLINE void Load(Vector& vector, const T* from)
{
  std::memcpy(&vector, from, sizeof(vector));
}
template <typename Vector, typename T>
HASHEDOCTREE_INLINE void Store(const Vector& vector, T* to)
{
  std::memcpy(to, &vector, sizeof(vector));
}

template <typename Key>
HASHEDOCTREE_INLINE Key GetKey(double dist2)
{
  if constexpr (std::is_same_v<Key, Whole>)
  {
    return dist2;
  }
  else
  {
    std::uint64_t bits;
    std::memcpy(&bits, &dist2, sizeof(bits));
    return static_cast<Key>(bits >> 32);
  }
}

enum class Before
{
  Less,
  NotGreater
};

/** Adds to the rank of each key the number of the others that are before it. Works on two vectors
 * at a time, also beyond the last key. */
template <Before Which, typename Key>
HASHEDOCTREE_INLINE void AddToRanks(RankOf<Key>* ranks, const Key* keys, std::size_t count,
  const Key* others, std::size_t numberOfOthers)
{
  constexpr std::size_t width = 32 / sizeof(Key);
  using Keys = Lanes<Key, width>;
  using Ranks = Lanes<RankOf<Key>, width>;
  for (std::size_t i = 0; i < count; i += 2 * width)
  {
    Keys a, b;
    Ranks rankOfA, rankOfB;
    Load(a, keys + i);
    Load(b, keys + i + width);
    Load(rankOfA, ranks + i);
    Load(rankOfB, ranks + i + width);
    if constexpr (Which == Before::NotGreater)
    {
      // All but the greater, since for "not greater" AVX2 has no instruction.
      rankOfA += static_cast<RankOf<Key>>(numberOfOthers);
      rankOfB += static_cast<RankOf<Key>>(numberOfOthers);
    }
    for (std::size_t j = 0; j < numberOfOthers; ++j)
    {
      const Keys other = Keys{} + others[j];
      // What is true is -1 in all lanes.
      if constexpr (Which == Before::Less)
      {
        rankOfA -= other < a;
        rankOfB -= other < b;
      }
      else
      {
        rankOfA += other > a;
        rankOfB += other > b;
      }
    }
    Store(rankOfA, ranks + i);
    Store(rankOfB, ranks + i + width);
  }
}

/** Whether each of the distances is before the next one. Writes beyond the last. */
template <Before Which>
HASHEDOCTREE_INLINE bool IsInOrder(double* dist2, std::size_t count)
{
  constexpr std::size_t width = 4;
  std::fill_n(dist2 + count, width, std::numeric_limits<double>::quiet_NaN());
  Lanes<std::int64_t, width> isNot{};
  for (std::size_t i = 0; i + 1 < count; i += width)
  {
    Lanes<double, width> here, next;
    Load(here, dist2 + i);
    Load(next, dist2 + i + 1);
    isNot |= Which == Before::Less ? here >= next : here > next;
  }
  return (isNot[0] | isNot[1] | isNot[2] | isNot[3]) == 0;
}

constexpr std::size_t MostMerged = RankedPoints::MostKept + RankedPoints::MostAdded;
constexpr std::size_t Padding = RankedPoints::Padding;

/** Puts ids in order, given where they are; no two are equal. */
HASHEDOCTREE_INLINE void SortById(const PointIndex** ids, std::size_t count)
{
  if (std::is_sorted(
        ids, ids + count, [](const PointIndex* a, const PointIndex* b) { return *a < *b; }))
  {
    return;
  }
  std::array<const PointIndex*, MostMerged> unsorted;
  std::array<PointIndex, MostMerged + Padding> keys;
  std::array<RankOf<PointIndex>, MostMerged + Padding> ranks;
  std::copy_n(ids, count, unsorted.begin());
  std::transform(ids, ids + count, keys.begin(), [](const PointIndex* id) { return *id; });
  std::fill_n(keys.begin() + count, Padding, PointIndex(0));
  std::fill_n(ranks.begin(), count + Padding, 0);
  AddToRanks<Before::Less>(ranks.data(), keys.data(), count, keys.data(), count);
  for (std::size_t i = 0; i < count; ++i)
  {
    ids[ranks[i]] = unsorted[i];
  }
}

/** Sorts what is nearly in the order of the distances, as far as the first `most`. */
HASHEDOCTREE_INLINE void PutInOrderInline(
  double* dist2, const PointIndex** ids, std::size_t count, std::size_t most)
{
  const std::size_t unsorted = IsInOrder<Before::NotGreater>(dist2, count) ? 0 : count;
  for (std::size_t i = 1; i < unsorted; ++i)
  {
    for (std::size_t j = i; j > 0 && dist2[j] < dist2[j - 1]; --j)
    {
      std::swap(dist2[j], dist2[j - 1]);
      std::swap(ids[j], ids[j - 1]);
    }
  }
  for (std::size_t first = 0; first < std::min(count, most);)
  {
    std::size_t last = first + 1;
    while (last < count && dist2[last] == dist2[first])
    {
      ++last;
    }
    if (last - first > 1)
    {
      SortById(ids + first, last - first);
    }
    first = last;
  }
}

// Two functions, since what is rarely needed slows down what it would stand among.
void PutInOrder(double* dist2, const PointIndex** ids, std::size_t count, std::size_t most)
{
  PutInOrderInline(dist2, ids, count, most);
}
HASHEDOCTREE_WITH_AVX2 void PutInOrderWithVectors(
  double* dist2, const PointIndex** ids, std::size_t count, std::size_t most)
{
  PutInOrderInline(dist2, ids, count, most);
}
}

/** The chosen points of a leaf, with their ranks. */
template <typename Key>
class RankedPoints::Newcomers
{
public:
  /** Leaves out points that come after all that are kept, no more being wanted, and those that
   * `most` others stand right before, equally near and by id. */
  HASHEDOCTREE_INLINE Newcomers(const double* dist2, const PointIndex* ids, std::uint64_t chosen,
    std::size_t most, const RankedPoints& kept)
  {
    constexpr double none = -1.0;
    const double latest = kept.Size >= most ? kept.Dist2[most - 1] : none;
    double before = none;
    const PointIndex* idBefore = nullptr;
    std::size_t equalBefore = 0;
    for (; chosen != 0; chosen &= chosen - 1)
    {
      const auto place = static_cast<unsigned>(__builtin_ctzll(chosen));
      const double here = dist2[place];
      const PointIndex* id = ids + place;
      equalBefore = here == before && *idBefore < *id ? equalBefore + 1 : 0;
      before = here;
      idBefore = id;
      if (equalBefore < most && !(here == latest && *kept.Ids[most - 1] < *id))
      {
        this->Places[this->Count] = static_cast<std::uint8_t>(place);
        this->Keys[this->Count] = GetKey<Key>(here);
        ++this->Count;
      }
    }
    // These are compared, too, although their ranks are not used.
    std::fill_n(this->Keys + this->Count, Padding, Key(0));
    for (std::size_t i = 0; i < this->Count; i += Padding)
    {
      std::fill_n(this->Ranks + i, Padding, -1); // None is before itself.
    }
    AddToRanks<Before::NotGreater>(this->Ranks, this->Keys, this->Count, this->Keys, this->Count);
  }

  /** Whether any two keys are equal. Such ones have all been given the last of their ranks. */
  HASHEDOCTREE_INLINE bool HasEqualOnes() const
  {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      sum += static_cast<std::size_t>(this->Ranks[i]);
    }
    return sum != this->Count * (this->Count - 1) / 2;
  }
  /** Gives equal keys different ranks, in the order of their places. Returns whether the distances
   * are equal, too, and stops where they are not. */
  HASHEDOCTREE_INLINE bool PartEqualOnes(const double* dist2)
  {
    double dist2OfRank[MostAdded];
    std::uint8_t taken[MostAdded] = {}; // How many have been given a rank from each one down.
    for (std::size_t i = this->Count; i-- > 0;)
    {
      const RankOf<Key> last = this->Ranks[i];
      const double here = dist2[this->Places[i]];
      if (taken[last] == 0)
      {
        dist2OfRank[last] = here;
      }
      else if (here != dist2OfRank[last])
      {
        return false;
      }
      this->Ranks[i] = last - taken[last];
      ++taken[last];
    }
    return true;
  }

  std::size_t Count = 0;
  Key Keys[MostAdded + Padding];
  std::uint8_t Places[MostAdded];         ///< In the leaf.
  RankOf<Key> Ranks[MostAdded + Padding]; ///< Among themselves.
};

template <typename Key>
HASHEDOCTREE_INLINE void RankedPoints::MergeRanked(Newcomers<Key>& added, const double* dist2,
  const PointIndex* ids, std::size_t most, Sort putInOrder)
{
  const bool isFirst = this->Dist2 == this->Dist2Lists[0];
  double* mergedDist2 = this->Dist2Lists[isFirst ? 1 : 0];
  const PointIndex** mergedIds = this->IdLists[isFirst ? 1 : 0];
  if (this->Size > 0)
  {
    Key keys[MostKept + Padding];
    RankOf<Key> ranks[MostKept + Padding];
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      keys[i] = GetKey<Key>(this->Dist2[i]);
    }
    std::fill_n(keys + this->Size, Padding, Key(0));
    for (std::size_t i = 0; i < this->Size + Padding; ++i)
    {
      ranks[i] = static_cast<RankOf<Key>>(i);
    }
    AddToRanks<Before::NotGreater>(added.Ranks, added.Keys, added.Count, keys, this->Size);
    AddToRanks<Before::Less>(ranks, keys, this->Size, added.Keys, added.Count);
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      mergedDist2[ranks[i]] = this->Dist2[i];
      mergedIds[ranks[i]] = this->Ids[i];
    }
  }
  for (std::size_t i = 0; i < added.Count; ++i)
  {
    mergedDist2[added.Ranks[i]] = dist2[added.Places[i]];
    mergedIds[added.Ranks[i]] = ids + added.Places[i];
  }
  const std::size_t count = this->Size + added.Count;
  if (!IsInOrder<Before::Less>(mergedDist2, count))
  {
    putInOrder(mergedDist2, mergedIds, count, most);
  }
  this->Dist2 = mergedDist2;
  this->Ids = mergedIds;
  this->Size = std::min(count, most);
}

HASHEDOCTREE_INLINE void RankedPoints::MergeInline(const double* dist2, const PointIndex* ids,
  std::uint64_t chosen, std::size_t most, Sort putInOrder)
{
  Newcomers<UpperHalf> added(dist2, ids, chosen, most, *this);
  if (added.Count == 0)
  {
    return;
  }
  if (!added.HasEqualOnes() || added.PartEqualOnes(dist2))
  {
    this->MergeRanked(added, dist2, ids, most, putInOrder);
    return;
  }
  // As from far away, where the distances to all points are nearly the same.
  Newcomers<Whole> whole(dist2, ids, chosen, most, *this);
  if (whole.HasEqualOnes())
  {
    whole.PartEqualOnes(dist2);
  }
  this->MergeRanked(whole, dist2, ids, most, putInOrder);
}

void RankedPoints::Merge(
  const double* dist2, const PointIndex* ids, std::uint64_t chosen, std::size_t most)
{
  this->MergeInline(dist2, ids, chosen, most, PutInOrder);
}

HASHEDOCTREE_WITH_AVX2 void RankedPoints::MergeWithVectors(
  const double* dist2, const PointIndex* ids, std::uint64_t chosen, std::size_t most)
{
  this->MergeInline(dist2, ids, chosen, most, PutInOrderWithVectors);
}
}
