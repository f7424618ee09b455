// SPDX-License-Identifier: BSD-3-Clause
#include "DistinctKeys.h"

#include "CurveBuilders.h"
#include "Dimensions.h"
#include "OnThisThread.h"
#include "Threads.h"

#include <algorithm>
#include <random>
#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestDistinctKeys : public ::testing::Test
{
protected:
  using Keys = CurveKeys<Dimension::value>;

  /** As many keys, of so many cells. */
  static Keys MakeKeys(std::size_t count, std::size_t cells)
  {
    const Keys some = MakeRandomKeys<Dimension::value>(cells, 231);
    std::mt19937_64 random(232);
    Keys keys(count);
    std::generate(keys.begin(), keys.end(), [&] { return some[random() % cells]; });
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
    for (const std::size_t cells : { 1U, 40U, 50000U })
    {
      const OfDimension keys = TestFixture::MakeKeys(count, cells);
      const std::set<typename OfDimension::value_type> expected(keys.begin(), keys.end());
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
  EXPECT_THROW(GetDistinctKeys(keys, MakeInterrupted()), Interrupted);
}
