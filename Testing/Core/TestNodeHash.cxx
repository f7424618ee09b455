// SPDX-License-Identifier: BSD-3-Clause
#include "NodeHash.h"

#include <gtest/gtest.h>

#include <vector>

using namespace hashedoctree;

TEST(TestNodeHash, LowBitsAreTheKeysOwn)
{
  const LowBitsHash hash(3);
  EXPECT_EQ(hash.GetNumberOfSlots(), 8U);
  EXPECT_EQ(hash.GetSlot(0b1101), 0b101U);
}

TEST(TestNodeHash, SlotsOfTheDrawing)
{
  // Plugin/Documentation/structures.svg, the paper's Fig. 3(c): k mod 2^3.
  const LowBitsHash hash(4);
  ASSERT_EQ(hash.GetNumberOfSlots(), 8U);
  const std::vector<std::uint64_t> keys{ 0b11000, 0b1, 0b11010, 0b11011, 0b100, 0b101, 0b110,
    0b111 };
  for (std::size_t slot = 0; slot < keys.size(); ++slot)
  {
    EXPECT_EQ(hash.GetSlot(keys[slot]), slot);
  }
  EXPECT_EQ(hash.GetSlot(0b11001), hash.GetSlot(0b1)) << "a chain of two";
}

TEST(TestNodeHash, MixingReachesAllOfATableOfAnySize)
{
  for (const std::size_t count : { 1000UL, 1UL << 20, 1UL << 33 })
  {
    const MixingHash hash(count);
    std::vector<int> keysOfPart(16, 0);
    for (std::uint64_t key = 1; key <= 1600; ++key)
    {
      ++keysOfPart[hash.GetSlot(key) / (hash.GetNumberOfSlots() / 16 + 1)];
    }
    for (const int keys : keysOfPart)
    {
      EXPECT_GT(keys, 60) << count;
      EXPECT_LT(keys, 140) << count;
    }
  }
}

TEST(TestNodeHash, MixingStaysWithinTheTable)
{
  for (const std::size_t count : { 0UL, 1UL, 5UL, 1000UL, 1UL << 40 })
  {
    const MixingHash hash(count);
    for (int bit = 0; bit < 64; ++bit)
    {
      EXPECT_LT(hash.GetSlot(~std::uint64_t(0) >> bit), hash.GetNumberOfSlots());
    }
  }
}
