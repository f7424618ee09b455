// SPDX-License-Identifier: BSD-3-Clause
#include "Buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <utility>
#include <vector>

using namespace hashedoctree;

namespace
{
/** On both sides of where large pages begin, and with a rest beyond whole ones. */
constexpr std::size_t Sizes[] = { 1, 5000, FirstLargeSize - 1, FirstLargeSize, FirstLargeSize + 1,
  LargePageSize, 5 * LargePageSize / 2 + 3 };

/** Address space of this process, in bytes. */
std::size_t GetAddressSpace()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * SmallPageSize;
}
}

TEST(TestBuffer, ZeroedMemoryIsZeroWhateverWasThereBefore)
{
  for (const std::size_t size : Sizes)
  {
    {
      Buffer<char> before(size);
      std::fill_n(before.GetData(), size, '\x7f');
    }
    Buffer<char> buffer(size, Memory::Zeroed);
    EXPECT_EQ(std::count(buffer.GetData(), buffer.GetData() + size, '\0'),
      static_cast<std::ptrdiff_t>(size));
    // All of it can be written to.
    std::fill_n(buffer.GetData(), size, '\x7f');
    EXPECT_EQ(buffer[size - 1], '\x7f');
  }
}

TEST(TestBuffer, ValuesAreAligned)
{
  struct alignas(64) Line
  {
    char Bytes[64];
  };
  for (const std::size_t size : Sizes)
  {
    for (const Memory memory : { Memory::Uninitialised, Memory::Zeroed })
    {
      const Buffer<Line> buffer(size / sizeof(Line) + 1, memory);
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.GetData()) % alignof(Line), 0U) << size;
    }
  }
}

TEST(TestBuffer, MovingLeavesNothingBehind)
{
  for (const std::size_t size : Sizes)
  {
    std::vector<Buffer<char>> buffers;
    buffers.reserve(2);
    buffers.emplace_back(size, Memory::Zeroed);
    buffers[0][size - 1] = 'a';
    buffers.emplace_back(std::move(buffers[0]));
    EXPECT_EQ(buffers[0].GetSize(), 0U);
    EXPECT_EQ(buffers[0].GetData(), nullptr);
    EXPECT_EQ(buffers[1][size - 1], 'a');
    Buffer<char> assigned(7);
    assigned = std::move(buffers[1]);
    EXPECT_EQ(buffers[1].GetSize(), 0U);
    EXPECT_EQ(assigned.GetSize(), size);
    EXPECT_EQ(assigned[size - 1], 'a');
  }
}

TEST(TestBuffer, LargeZeroedMemoryGoesBackToTheSystem)
{
  constexpr std::size_t size = 33 * LargePageSize + 1;
  const std::size_t before = GetAddressSpace();
  for (int i = 0; i < 100; ++i)
  {
    Buffer<char> buffer(size, Memory::Zeroed);
    buffer[size - 1] = 'a';
    EXPECT_GE(GetAddressSpace(), before + size);
  }
  EXPECT_LT(GetAddressSpace(), before + size);
}

TEST(TestBuffer, MoreThanThereIsThrows)
{
  for (const Memory memory : { Memory::Uninitialised, Memory::Zeroed })
  {
    EXPECT_THROW(Buffer<char>(std::size_t(1) << 60, memory), std::bad_alloc);
    // Bytes that a size_t cannot count, or whose whole pages it cannot.
    EXPECT_THROW(Buffer<double>(std::size_t(1) << 61, memory), std::bad_alloc);
    EXPECT_THROW(Buffer<char>(SIZE_MAX, memory), std::bad_alloc);
    EXPECT_THROW(Buffer<double>(SIZE_MAX / sizeof(double), memory), std::bad_alloc);
  }
}
