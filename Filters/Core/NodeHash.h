// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeHash_h
#define hashedoctree_NodeHash_h

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/** Slots that a table looks at together; with values of 8 bytes they fill one cache line. */
constexpr std::size_t SlotsOfBucket = 4;

/** 2^64 by the golden ratio; the upper bits of a number's product with it depend on all bits of the
 * number. */
constexpr std::uint64_t GoldenMultiplier = 0x9e3779b97f4a7c15U;

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
 * A multiplicative hash: the key times GoldenMultiplier, scaled to the number of slots, so that a
 * table need not be a power of two and its load is 1/2, or in small tables less.
 */
class MixingHash
{
public:
  /** Slots for so many keys: the whole buckets that are more than twice as many. */
  explicit MixingHash(std::size_t numberOfKeys)
    : NumberOfSlots((2 * numberOfKeys / SlotsOfBucket + 1) * SlotsOfBucket)
  {
  }
  std::size_t GetNumberOfSlots() const { return static_cast<std::size_t>(this->NumberOfSlots); }
  std::size_t GetSlot(std::uint64_t key) const
  {
    __extension__ using Product = unsigned __int128;
    const std::uint64_t mixed = key * GoldenMultiplier;
    return static_cast<std::size_t>(Product(mixed) * this->NumberOfSlots >> 64);
  }

private:
  std::uint64_t NumberOfSlots;
};
}

#endif
