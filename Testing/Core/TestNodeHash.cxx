// SPDX-License-Identifier: BSD-3-Clause
#include "NodeHash.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

TEST(TestNodeHash, LowBitsAreTheKeysOwn)
{
  const LowBitsHash hash(3);
  EXPECT_EQ(hash.GetNumberOfSlots(), 8U);
  EXPECT_EQ(hash.GetSlot(0b1101), 0b101U);
}

TEST(TestNodeHash, MixingStaysWithinTheTable)
{
  for (const std::size_t count : { 0U, 1U, 5U, 1000U })
  {
    const MixingHash hash(count);
    for (int bit = 0; bit < 64; ++bit)
    {
      EXPECT_LT(hash.GetSlot(~std::uint64_t(0) >> bit), hash.GetNumberOfSlots());
    }
  }
}
