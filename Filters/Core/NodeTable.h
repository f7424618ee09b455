// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeTable_h
#define hashedoctree_NodeTable_h

#include "Buffer.h"
#include "FirstTouch.h"
#include "KeyMatch.h"
#include "NodeHash.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hashedoctree
{
/**
 * Key of a node to a small value; nothing but hashing. Open addressing, at most half full, sized
 * for the keys to come (paper E17: a fixed size wastes memory on small trees). Keys are kept as
 * they are, so the answer is exact whatever the hash.
 *
 * Slots are probed linearly, a bucket at a time. A bucket is one cache line, its keys are compared
 * together, and it ends the probing unless a key was turned away from it, being full: so a key that
 * is not there, which is what a search that starts too deep meets most often, mostly costs one
 * cache line and no guessing of branches. Erase() leaves no free slots between a key's home and its
 * own; buckets that it filled may go on saying that they turned keys away, until they lose one.
 *
 * Const members may be called from many threads at once. Find(), Insert() and Erase() are O(1) on
 * average.
 */
template <typename Value, typename Hash = MixingHash>
class NodeTable
{
public:
  /** Room for this many keys. No key is found in it. */
  explicit NodeTable(std::size_t numberOfKeys = 0)
    : SlotHash(Hash(numberOfKeys))
    , Buckets(this->SlotHash.GetNumberOfSlots() / SlotsOfBucket, Memory::Zeroed)
  {
  }

  /** See FirstTouch.h; for a table without keys. */
  void TouchPages(const Execution& execution)
  {
    hashedoctree::TouchPages(this->Buckets, execution);
  }

  /** Whether there is room for this many keys in all. */
  bool HasRoom(std::size_t numberOfKeys) const
  {
    return 2 * numberOfKeys <= this->GetNumberOfSlots();
  }
  /** Makes room for this many keys in all. Where there is too little, the table is filled anew at
   * twice its size or more: O(1) for each key ever inserted. References to values end. Where memory
   * is out it throws std::bad_alloc, and nothing has changed. */
  void Reserve(std::size_t numberOfKeys)
  {
    if (this->HasRoom(numberOfKeys))
    {
      return;
    }
    NodeTable larger(std::max(numberOfKeys, this->GetNumberOfSlots()));
    this->ForEach([&larger](std::uint64_t key, const Value& value) { larger.Insert(key, value); });
    *this = std::move(larger);
  }

  /** Adds a key, not 0 and not in the table yet. Adding more than there is room for is not
   * allowed. Returns where the value is; references to other values end. */
  Value& Insert(std::uint64_t key, const Value& value)
  {
    std::size_t at = this->GetHome(key);
    while (this->Buckets[at].IsFull())
    {
      this->Buckets[at].SetTurnedAway(true);
      at = this->GetNext(at);
    }
    ++this->NumberOfKeys;
    return this->Buckets[at].Add(key, value);
  }

  /** Takes out a key, not 0; whether it was there. References to values end. */
  bool Erase(std::uint64_t key)
  {
    for (std::size_t at = this->GetHome(key);; at = this->GetNext(at))
    {
      Bucket& bucket = this->Buckets[at];
      const auto* slot = std::find(bucket.Keys, bucket.Keys + SlotsOfBucket, key);
      const bool turnedAway = bucket.HasTurnedAway();
      if (slot != bucket.Keys + SlotsOfBucket)
      {
        bucket.Remove(static_cast<std::size_t>(slot - bucket.Keys));
        --this->NumberOfKeys;
        if (turnedAway)
        {
          this->FillHole(at);
        }
        return true;
      }
      if (!turnedAway)
      {
        return false;
      }
    }
  }

  /** Whether it stays in a core's second cache, so that to ask for slots ahead is of no use. */
  bool IsCached() const { return this->GetBytes() <= BytesOfSecondCache; }

  /** Asks the machine to load the slot where a key would be, for a later Insert() or Find(). Inline
   * always: left to itself GCC takes a function that only does so for one that does nothing, and
   * leaves out the call. */
  [[gnu::always_inline]] void Prefetch(std::uint64_t key) const
  {
    __builtin_prefetch(&this->Buckets[this->GetHome(key)], 1);
  }

  /** The value of a key, not 0, or null. */
  const Value* Find(std::uint64_t key) const
  {
    for (std::size_t at = this->GetHome(key);; at = this->GetNext(at))
    {
      const Bucket& bucket = this->Buckets[at];
      const unsigned match = MatchKeys(bucket.Keys, key);
      if (match != 0)
      {
        return &bucket.Values[__builtin_ctz(match)];
      }
      if (!bucket.HasTurnedAway())
      {
        return nullptr;
      }
    }
  }

  /** To change the value. */
  Value* Find(std::uint64_t key)
  {
    return const_cast<Value*>(static_cast<const NodeTable*>(this)->Find(key));
  }

  /** Calls function(key, value) for every key, in no order of meaning. O(slots). */
  template <typename Function>
  void ForEach(const Function& function) const
  {
    for (std::size_t bucket = 0; bucket < this->Buckets.GetSize(); ++bucket)
    {
      const Bucket& here = this->Buckets[bucket];
      for (std::size_t slot = 0; slot < SlotsOfBucket && here.Keys[slot] != 0; ++slot)
      {
        function(here.Keys[slot], here.Values[slot]);
      }
    }
  }

  std::size_t GetNumberOfKeys() const { return this->NumberOfKeys; }
  std::size_t GetNumberOfSlots() const { return this->Buckets.GetSize() * SlotsOfBucket; }
  double GetLoadFactor() const
  {
    return static_cast<double>(this->NumberOfKeys) / static_cast<double>(this->GetNumberOfSlots());
  }
  std::size_t GetBytes() const { return this->Buckets.GetBytes(); }

  /** How many keys are found by looking at i + 1 buckets, at index i. O(slots). */
  std::vector<std::size_t> GetProbeLengths() const
  {
    std::vector<std::size_t> lengths;
    for (std::size_t bucket = 0; bucket < this->Buckets.GetSize(); ++bucket)
    {
      for (const std::uint64_t key : this->Buckets[bucket].Keys)
      {
        if (key != 0)
        {
          CountAt(lengths, this->GetDistance(this->GetHome(key), bucket));
        }
      }
    }
    return lengths;
  }
  /** For how many buckets a key that belongs there and is not in the table costs a look at i + 1
   * buckets, at index i. O(slots). */
  std::vector<std::size_t> GetProbeLengthsOfAbsentKeys() const
  {
    std::vector<std::size_t> lengths;
    for (std::size_t home = 0; home < this->Buckets.GetSize(); ++home)
    {
      std::size_t last = home;
      while (this->Buckets[last].HasTurnedAway())
      {
        last = this->GetNext(last);
      }
      CountAt(lengths, this->GetDistance(home, last));
    }
    return lengths;
  }

private:
  static constexpr std::size_t BytesOfSecondCache = std::size_t(1) << 20;

  /** Slots are filled from the first on; key 0 marks a free one. */
  struct alignas(SlotsOfBucket*(sizeof(std::uint64_t) + sizeof(Value))) Bucket
  {
    std::uint64_t Keys[SlotsOfBucket];
    Value Values[SlotsOfBucket];

    bool IsFull() const { return this->Keys[SlotsOfBucket - 1] != 0; }
    /** Whether a key that belongs here may be further on: the order of two keys tells, which costs
     * no memory. (In a half full table 0.14 to 0.17 of the buckets are full, 0.04 to 0.07 have
     * turned a key away.) */
    bool HasTurnedAway() const { return this->Keys[0] < this->Keys[1]; }
    void SetTurnedAway(bool turnedAway)
    {
      if (this->HasTurnedAway() != turnedAway)
      {
        std::swap(this->Keys[0], this->Keys[1]);
        std::swap(this->Values[0], this->Values[1]);
      }
    }
    /** To one that is not full. */
    Value& Add(std::uint64_t key, const Value& value)
    {
      std::size_t slot = 0;
      while (this->Keys[slot] != 0)
      {
        ++slot;
      }
      this->Keys[slot] = key;
      this->Values[slot] = value;
      this->SetTurnedAway(false);
      return this->Values[slot == 1 && this->Keys[0] == key ? 0 : slot];
    }
    /** The last key takes the place of the one that goes. No key is then turned away. */
    void Remove(std::size_t slot)
    {
      std::size_t last = SlotsOfBucket - 1;
      while (this->Keys[last] == 0)
      {
        --last;
      }
      this->Keys[slot] = this->Keys[last];
      this->Values[slot] = this->Values[last];
      this->Keys[last] = 0;
      this->SetTurnedAway(false);
    }
  };
  static_assert(sizeof(Value) == 8 && SlotsOfBucket == MatchedKeys, "a bucket is one cache line");

  static void CountAt(std::vector<std::size_t>& lengths, std::size_t distance)
  {
    lengths.resize(std::max(lengths.size(), distance + 1), 0);
    ++lengths[distance];
  }

  std::size_t GetHome(std::uint64_t key) const
  {
    return this->SlotHash.GetSlot(key) / SlotsOfBucket;
  }
  std::size_t GetNext(std::size_t bucket) const
  {
    return bucket + 1 == this->Buckets.GetSize() ? 0 : bucket + 1;
  }
  /** Steps of GetNext() from one bucket to another. */
  std::size_t GetDistance(std::size_t from, std::size_t to) const
  {
    return to >= from ? to - from : to + this->Buckets.GetSize() - from;
  }

  /** Fills the free slot of a bucket that had turned keys away. A key further on belongs there when
   * its home is not beyond the hole; the first such leaves the next hole, until a bucket that had
   * turned none away ends the probing. */
  void FillHole(std::size_t hole)
  {
    bool turnedAway = true;
    for (std::size_t from = this->GetNext(hole); turnedAway; from = this->GetNext(from))
    {
      Bucket& bucket = this->Buckets[from];
      turnedAway = bucket.HasTurnedAway();
      for (std::size_t slot = 0; slot < SlotsOfBucket && bucket.Keys[slot] != 0; ++slot)
      {
        if (this->GetDistance(this->GetHome(bucket.Keys[slot]), from) >=
          this->GetDistance(hole, from))
        {
          this->Buckets[hole].Add(bucket.Keys[slot], bucket.Values[slot]);
          this->Buckets[hole].SetTurnedAway(true); // There may be more.
          bucket.Remove(slot);
          hole = from;
          break;
        }
      }
    }
  }

  Hash SlotHash;
  Buffer<Bucket> Buckets;
  std::size_t NumberOfKeys = 0;
};
}

#endif
