// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeTable_h
#define hashedoctree_NodeTable_h

#include "Buffer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hashedoctree
{
/**
 * The hash function of the paper (section 2): the low bits of the key, k mod 2^b. Neighbouring
 * keys go to neighbouring slots, but the deep nodes in the root's lower corner all have the same
 * low bits and queue up (reading of the paper E20). Kept because the paper's claim about it is one
 * of the things shown; use MixingHash.
 */
class LowBitsHash
{
public:
  /** A power of two with a load of at most 1/2. */
  explicit LowBitsHash(std::size_t numberOfKeys)
  {
    std::size_t slots = 2;
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
  explicit MixingHash(std::size_t numberOfKeys)
    : NumberOfSlots(2 * numberOfKeys + 2)
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
 * Key of a node to a small value; nothing but hashing. Open addressing with linear probing, at
 * most half full, sized once for the keys to come (paper E17: a fixed size wastes memory on small
 * trees). A slot of 16 bytes holds the key and its value, so that a search that hits reads one
 * cache line. Keys are kept as they are, so the answer is exact whatever the hash.
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
    , Table(this->Slots.GetNumberOfSlots(), Memory::Zeroed)
  {
  }

  /** Adds a key, not 0 and not in the table yet. Adding more than there is room for is not
   * allowed. Returns where the value is. */
  Value& Insert(std::uint64_t key, const Value& value)
  {
    std::size_t slot = this->Slots.GetSlot(key);
    while (this->Table[slot].Key != 0)
    {
      slot = this->Next(slot);
    }
    this->Table[slot] = Slot{ key, value };
    ++this->NumberOfKeys;
    return this->Table[slot].Content;
  }

  /** Asks the machine to load the slot where a key would be, for a later Insert() or Find(). */
  void Prefetch(std::uint64_t key) const
  {
    __builtin_prefetch(&this->Table[this->Slots.GetSlot(key)], 1);
  }

  /** The value of a key, or null. Key 0 is never found. */
  const Value* Find(std::uint64_t key) const
  {
    for (std::size_t slot = this->Slots.GetSlot(key);; slot = this->Next(slot))
    {
      const Slot& here = this->Table[slot];
      if (here.Key == key)
      {
        return key != 0 ? &here.Content : nullptr;
      }
      if (here.Key == 0)
      {
        return nullptr;
      }
    }
  }

  std::size_t GetNumberOfKeys() const { return this->NumberOfKeys; }
  std::size_t GetNumberOfSlots() const { return this->Table.GetSize(); }
  double GetLoadFactor() const
  {
    return static_cast<double>(this->NumberOfKeys) / static_cast<double>(this->Table.GetSize());
  }
  std::size_t GetBytes() const { return this->Table.GetBytes(); }

  /** How many keys are found with i + 1 looks at the table, at index i. O(slots). */
  std::vector<std::size_t> GetProbeLengths() const
  {
    std::vector<std::size_t> lengths;
    for (std::size_t slot = 0; slot < this->Table.GetSize(); ++slot)
    {
      if (this->Table[slot].Key != 0)
      {
        const std::size_t home = this->Slots.GetSlot(this->Table[slot].Key);
        const std::size_t distance =
          slot >= home ? slot - home : slot + this->Table.GetSize() - home;
        if (lengths.size() <= distance)
        {
          lengths.resize(distance + 1, 0);
        }
        ++lengths[distance];
      }
    }
    return lengths;
  }

private:
  struct Slot
  {
    std::uint64_t Key; ///< 0 where the slot is free.
    Value Content;
  };

  std::size_t Next(std::size_t slot) const
  {
    return slot + 1 == this->Table.GetSize() ? 0 : slot + 1;
  }

  Hash Slots;
  Buffer<Slot> Table;
  std::size_t NumberOfKeys = 0;
};
}

#endif
