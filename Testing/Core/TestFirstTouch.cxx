// SPDX-License-Identifier: BSD-3-Clause
#include "FirstTouch.h"

#include "OnThisThread.h"
#include "Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sys/mman.h>
#include <vector>

using namespace hashedoctree;

namespace
{
/** Gives the pages that hold nothing but these values back to the system: a sanitizer may have
 * written to them, or an earlier owner of the memory. */
template <typename T>
void GiveBack(Buffer<T>& buffer)
{
  const auto begin = reinterpret_cast<std::uintptr_t>(buffer.GetData());
  const std::uintptr_t first = (begin + SmallPageSize - 1) / SmallPageSize * SmallPageSize;
  const std::uintptr_t last = (begin + buffer.GetBytes()) / SmallPageSize * SmallPageSize;
  ASSERT_EQ(madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED), 0);
}

/** Whether the system has handed out every page that holds any of these values. */
template <typename T>
bool AreThere(const Buffer<T>& buffer)
{
  const auto begin = reinterpret_cast<std::uintptr_t>(buffer.GetData());
  const std::uintptr_t first = begin / SmallPageSize * SmallPageSize;
  const std::size_t length = begin + buffer.GetBytes() - first;
  std::vector<unsigned char> pages((length + SmallPageSize - 1) / SmallPageSize);
  if (mincore(reinterpret_cast<void*>(first), length, pages.data()) != 0)
  {
    ADD_FAILURE() << "mincore() does not know the buffer";
  }
  return std::all_of(
    pages.begin(), pages.end(), [](unsigned char page) { return (page & 1U) != 0; });
}
}

TEST(TestFirstTouch, AllPagesAreThere)
{
  for (const std::size_t bytes :
    { std::size_t(40) << 20, (std::size_t(33) << 20) + 4097, (std::size_t(33) << 20) + 8 })
  {
    for (const Memory memory : { Memory::Uninitialised, Memory::Zeroed })
    {
      Buffer<char> buffer(bytes, memory);
      GiveBack(buffer);
      EXPECT_FALSE(AreThere(buffer)) << "or there is nothing to show";
      TouchPages(buffer, Execution(OnThreads(3)));
      EXPECT_TRUE(AreThere(buffer));
    }
  }
}

TEST(TestFirstTouch, ZeroedMemoryStaysZeroed)
{
  for (const std::size_t count : { 1U, 3U, 5000U, 3000000U })
  {
    Buffer<int> buffer(count, Memory::Zeroed);
    TouchPages(buffer, Execution());
    EXPECT_TRUE(
      std::all_of(buffer.GetData(), buffer.GetData() + count, [](int value) { return value == 0; }))
      << count;
  }
}

TEST(TestFirstTouch, SmallArraysAreLeftAsTheyAre)
{
  Buffer<char> buffer(FirstLargeSize - 1);
  std::fill_n(buffer.GetData(), buffer.GetSize(), 'x');
  TouchPages(buffer, Execution());
  EXPECT_TRUE(std::all_of(buffer.GetData(), buffer.GetData() + buffer.GetSize(),
    [](char value) { return value == 'x'; }));
}

TEST(TestFirstTouch, TellsProgressEveryEightMegabytes)
{
  int looks = 0;
  const Execution execution(OnThisThread,
    [&looks](double fraction)
    {
      EXPECT_EQ(fraction, 0.0);
      ++looks;
      return true;
    });
  Buffer<char> buffer(std::size_t(40) << 20);
  TouchPages(buffer, execution);
  EXPECT_GE(looks, 5);

  EXPECT_THROW(TouchPages(buffer, MakeInterrupted()), Interrupted);
}

TEST(TestFirstTouch, NothingToTouch)
{
  Buffer<char> buffer(0);
  TouchPages(buffer, Execution());
  EXPECT_EQ(buffer.GetSize(), 0U);
}
