// SPDX-License-Identifier: BSD-3-Clause
#include "NodeTable.h"

#include "MortonKey.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

using namespace hashedoctree;

template <typename Hash>
NodeTable<std::uint64_t, Hash> MakeTable(const std::vector<std::uint64_t>& keys)
{
  NodeTable<std::uint64_t, Hash> table(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    EXPECT_EQ(table.Insert(keys[i], i), i);
  }
  return table;
}

/** Mean looks at the table for one key that is in it. */
template <typename Table>
double GetMeanProbeLength(const Table& table)
{
  const std::vector<std::size_t> lengths = table.GetProbeLengths();
  double sum = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    sum += static_cast<double>(lengths[i] * (i + 1));
  }
  return sum / static_cast<double>(table.GetNumberOfKeys());
}

template <typename Hash>
class TestNodeTable : public ::testing::Test
{
};
using Hashes = ::testing::Types<LowBitsHash, MixingHash>;
TYPED_TEST_SUITE(TestNodeTable, Hashes);

/** Keys of deep nodes in the root's lower corner, all ending in the same bits. */
std::vector<std::uint64_t> MakeCornerKeys(std::size_t count)
{
  std::vector<std::uint64_t> keys;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    keys.push_back((i + 1) << 30);
  }
  return keys;
}

TYPED_TEST(TestNodeTable, FindsWhatIsInItAndNothingElse)
{
  std::mt19937_64 random(41);
  std::set<std::uint64_t> distinct;
  while (distinct.size() < 5000)
  {
    distinct.insert(random() >> (random() % 60));
    distinct.erase(0);
  }
  const std::vector<std::uint64_t> keys(distinct.begin(), distinct.end());
  const auto table = MakeTable<TypeParam>(keys);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    table.Prefetch(keys[i]);
    ASSERT_NE(table.Find(keys[i]), nullptr);
    ASSERT_EQ(*table.Find(keys[i]), i);
  }
  for (int trial = 0; trial < 20000; ++trial)
  {
    const std::uint64_t key = 1 + (random() >> (1 + random() % 60));
    ASSERT_EQ(table.Find(key) != nullptr, distinct.count(key) == 1) << key;
  }
}

TYPED_TEST(TestNodeTable, EmptyTableFindsNothing)
{
  const NodeTable<std::uint64_t, TypeParam> table;
  EXPECT_EQ(table.Find(1), nullptr);
  EXPECT_EQ(table.GetNumberOfKeys(), 0U);
  EXPECT_TRUE(table.GetProbeLengths().empty());
}

TYPED_TEST(TestNodeTable, IsAtMostHalfFull)
{
  for (std::size_t count = 1; count < 300; ++count)
  {
    std::vector<std::uint64_t> keys(count);
    std::iota(keys.begin(), keys.end(), 1U);
    const auto table = MakeTable<TypeParam>(keys);
    EXPECT_EQ(table.GetNumberOfKeys(), count);
    EXPECT_LE(table.GetLoadFactor(), 0.5);
    EXPECT_DOUBLE_EQ(table.GetLoadFactor(),
      static_cast<double>(count) / static_cast<double>(table.GetNumberOfSlots()));
    EXPECT_EQ(table.GetBytes(), 16 * table.GetNumberOfSlots());
  }
}

TYPED_TEST(TestNodeTable, ProbeLengthsCountEveryKey)
{
  const auto table = MakeTable<TypeParam>(MakeCornerKeys(1000));
  const std::vector<std::size_t> lengths = table.GetProbeLengths();
  EXPECT_EQ(std::accumulate(lengths.begin(), lengths.end(), std::size_t(0)), 1000U);
}

TEST(TestHashes, LowBitsAreTheKeysOwn)
{
  const LowBitsHash hash(3);
  EXPECT_EQ(hash.GetNumberOfSlots(), 8U);
  EXPECT_EQ(hash.GetSlot(0b1101), 0b101U);
}

TEST(TestHashes, MixingStaysWithinTheTable)
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

TEST(TestHashes, OnlyLowBitsSendCornerChainsToOneSlot)
{
  // Paper E20.
  const std::vector<std::uint64_t> keys = MakeCornerKeys(1000);
  EXPECT_DOUBLE_EQ(GetMeanProbeLength(MakeTable<LowBitsHash>(keys)), 125.5);
  EXPECT_LT(GetMeanProbeLength(MakeTable<MixingHash>(keys)), 1.2);
}

TEST(TestHashes, MixingIsShortOnAFullTree)
{
  // All nodes of depth 5: what a uniform scan gives.
  NodeTable<std::uint64_t> table(32768);
  for (std::uint32_t i = 0; i < 32768; ++i)
  {
    table.Insert(32768 + i, i);
  }
  const std::vector<std::size_t> lengths = table.GetProbeLengths();
  EXPECT_LE(lengths.size(), 4U);
}
