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
