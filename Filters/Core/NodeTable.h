// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeTable_h
#define hashedoctree_NodeTable_h

#include "Buffer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hashedoctree
{
/** Slots that a table looks at together; with values of 8 bytes they fill one cache line. */
constexpr std::size_t SlotsOfBucket = 4;

/**
 * The hash function of the paper (section 2): the low bits of the key, k mod 2^b. Neighbouring
 * keys go to neighbouring slots, but the deep nodes in the root's lower corner all have the same
 * low bits and queue up (reading of the paper E20). Kept because the paper's claim about it is one
 * of the things shown; use MixingHash.
 */
class LowBitsHash
{
public:
  /** Slots for so many keys: a power of two, at least twice as many. */
  explicit LowBitsHash(std::size_t numberOfKeys)
  {
    std::size_t slots = SlotsOfBucket;
    while (slots < 2 * numberOfKeys)
    {
      slots *= 2;
    }
    this->Mask = slots - 1;
  }
  std::size_t GetNumberOfSlots() const { return this->Mask + 1; }
  std::size_t GetSlot(std::uint64_t key) const
  {
    return static_cast<std::size_t>(key) & this->Mask;
  }

private:
  std::size_t Mask;
};

/**
 * A multiplicative hash: the key times an odd constant (2^64 over the golden ratio), of which the
 * upper half is scaled to the number of slots, so that a table need not be a power of two and its
 * load is always 1/2.
 */
class MixingHash
{
public:
  /** Slots for so many keys: twice as many, in whole buckets. */
  explicit MixingHash(std::size_t numberOfKeys)
    : NumberOfSlots((2 * numberOfKeys / SlotsOfBucket + 1) * SlotsOfBucket)
  {
  }
  std::size_t GetNumberOfSlots() const { return static_cast<std::size_t>(this->NumberOfSlots); }
  std::size_t GetSlot(std::uint64_t key) const
  {
    const std::uint64_t mixed = (key * 0x9e3779b97f4a7c15U) >> 32;
    return static_cast<std::size_t>(mixed * this->NumberOfSlots >> 32);
  }

private:
  std::uint64_t NumberOfSlots;
};

/**
 * Key of a node to a small value; nothing but hashing. Open addressing, at most half full, sized
 * once for the keys to come (paper E17: a fixed size wastes memory on small trees). Keys are kept
 * as they are, so the answer is exact whatever the hash.
 *
 * Slots are probed linearly, a bucket at a time. A bucket is one cache line, its keys are compared
 * together, and it ends the probing unless it is full: so a key that is not there, which is what a
 * search that starts too deep meets most often, costs one cache line and no guessing of branches.
 *
 * Const members may be called from many threads at once. Mean cost of Find() is O(1).
 */
template <typename Value, typename Hash = MixingHash>
class NodeTable
{
public:
  /** No key is found in it. */
  NodeTable()
    : NodeTable(0)
  {
  }
  /** Room for this many keys. */
  explicit NodeTable(std::size_t numberOfKeys)
    : Slots(Hash(numberOfKeys))
    , Buckets(this->Slots.GetNumberOfSlots() / SlotsOfBucket, Memory::Zeroed)
  {
  }

  /** Adds a key, not 0 and not in the table yet. Adding more than there is room for is not
   * allowed. Returns where the value is. */
  Value& Insert(std::uint64_t key, const Value& value)
  {
    std::size_t home = this->GetHome(key);
    while (this->Buckets[home].IsFull())
    {
      home = this->GetNext(home);
    }
    Bucket& bucket = this->Buckets[home];
    std::size_t slot = 0;
    while (bucket.Keys[slot] != 0)
    {
      ++slot;
    }
    bucket.Keys[slot] = key;
    bucket.Values[slot] = value;
    ++this->NumberOfKeys;
    return bucket.Values[slot];
  }

  /** Asks the machine to load the slot where a key would be, for a later Insert() or Find(). */
  void Prefetch(std::uint64_t key) const
  {
    __builtin_prefetch(&this->Buckets[this->GetHome(key)], 1);
  }

  /** The value of a key, not 0, or null. */
  const Value* Find(std::uint64_t key) const
  {
    for (std::size_t home = this->GetHome(key);; home = this->GetNext(home))
    {
      const Bucket& bucket = this->Buckets[home];
      unsigned match = 0;
      for (std::size_t slot = 0; slot < SlotsOfBucket; ++slot)
      {
        match |= (bucket.Keys[slot] == key ? 1U : 0U) << slot;
      }
      if (match != 0)
      {
        return &bucket.Values[__builtin_ctz(match)];
      }
      if (!bucket.IsFull())
      {
        return nullptr;
      }
    }
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
          const std::size_t size = this->Buckets.GetSize();
          const std::size_t distance = (bucket + size - this->GetHome(key)) % size;
          lengths.resize(std::max(lengths.size(), distance + 1), 0);
          ++lengths[distance];
        }
      }
    }
    return lengths;
  }

private:
  /** Slots are filled from the first on; key 0 marks a free one. */
  struct alignas(SlotsOfBucket*(sizeof(std::uint64_t) + sizeof(Value))) Bucket
  {
    std::uint64_t Keys[SlotsOfBucket];
    Value Values[SlotsOfBucket];

    bool IsFull() const { return this->Keys[SlotsOfBucket - 1] != 0; }
  };
  static_assert(sizeof(Value) == 8, "a bucket must fill one cache line");

  std::size_t GetHome(std::uint64_t key) const { return this->Slots.GetSlot(key) / SlotsOfBucket; }
  std::size_t GetNext(std::size_t bucket) const
  {
    return bucket + 1 == this->Buckets.GetSize() ? 0 : bucket + 1;
  }

  Hash Slots;
  Buffer<Bucket> Buckets;
  std::size_t NumberOfKeys = 0;
};
}

#endif
