// SPDX-License-Identifier: BSD-3-Clause
#include "DistinctKeys.h"

#include "Dimensions.h"
#include "Threads.h"

#include <random>
#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestDistinctKeys : public ::testing::Test
{
protected:
  using Key = MortonKey<Dimension::value>;
  using Keys = std::vector<Key>;

  /** As many keys, of not so many cells. */
  static Keys MakeKeys(std::size_t count, std::uint64_t cells)
  {
    std::mt19937_64 random(231);
    Keys keys(count);
    for (Key& key : keys)
    {
      // All over the root, and in the last bits, too.
      const std::uint64_t cell = random() % cells;
      key = Key(Key::Root().GetFirstAtMaxDepth().GetValue() +
        (cell * 0x9e3779b97f4a7c15U >> (64 - Key::MaxDepth * Dimension::value)));
    }
    return keys;
  }
};

TYPED_TEST_SUITE(TestDistinctKeys, Dimensions);

TYPED_TEST(TestDistinctKeys, HasEachOnceInOrder)
{
  using OfDimension = typename TestFixture::Keys;
  EXPECT_EQ(GetDistinctKeys(OfDimension(), Execution()), OfDimension());
  for (const std::size_t count : { 1U, 2U, 50U, 100000U })
  {
    for (const std::uint64_t cells : { 1U, 40U, 50000U })
    {
      const OfDimension keys = TestFixture::MakeKeys(count, cells);
      const std::set<typename TestFixture::Key> expected(keys.begin(), keys.end());
      for (const unsigned threads : { 1U, 3U })
      {
        EXPECT_EQ(GetDistinctKeys(keys, Execution(OnThreads(threads))),
          OfDimension(expected.begin(), expected.end()))
          << count << ", " << cells;
      }
    }
  }
}

TYPED_TEST(TestDistinctKeys, CanBeInterrupted)
{
  const auto keys = TestFixture::MakeKeys(100000, 1000);
  EXPECT_THROW(
    GetDistinctKeys(keys, Execution(OnThreads(1), [](double) { return false; })), Interrupted);
}
