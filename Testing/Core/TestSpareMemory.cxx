// SPDX-License-Identifier: BSD-3-Clause
#include "SpareMemory.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

using namespace hashedoctree;

TEST(TestSpareMemory, IsUsedWhereItIsLargeEnough)
{
  std::array<std::uint32_t, 4> spare{};
  for (const std::size_t size : { 0U, 1U, 4U })
  {
    Buffer<std::uint32_t> own;
    EXPECT_EQ(FindRoom(size, { spare.data(), sizeof(spare) }, own), spare.data());
    EXPECT_EQ(own.GetSize(), 0U);
  }
}

TEST(TestSpareMemory, IsLeftAloneWhereItIsTooSmall)
{
  std::array<std::uint32_t, 4> spare{};
  Buffer<std::uint32_t> own;
  const std::uint32_t* room = FindRoom(5, { spare.data(), sizeof(spare) }, own);
  EXPECT_EQ(room, own.GetData());
  EXPECT_EQ(own.GetSize(), 5U);
  room = FindRoom(6, {}, own);
  EXPECT_EQ(room, own.GetData());
  EXPECT_EQ(own.GetSize(), 6U);
}
