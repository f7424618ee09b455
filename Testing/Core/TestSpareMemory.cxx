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

TEST(TestSpareMemory, IsLeftAloneWhereItIsNotAligned)
{
  alignas(std::uint64_t) std::array<std::uint32_t, 8> spare{};
  for (const std::size_t place : { 0U, 1U, 2U })
  {
    Buffer<std::uint64_t> own;
    const void* room = FindRoom(2, { &spare[place], 4 * sizeof(std::uint32_t) }, own);
    EXPECT_EQ(room == &spare[place], place % 2 == 0);
  }
}
