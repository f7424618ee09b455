// SPDX-License-Identifier: BSD-3-Clause
#include "NodeTable.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <unordered_map>
#include <utility>

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

/** Keys of the first descendants, ten depths below them, of many nodes: all end in the same bits.
 */
std::vector<std::uint64_t> MakeKeysOfLowerCorners(std::size_t count)
{
  std::vector<std::uint64_t> keys;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    keys.push_back((i + 1) << 30);
  }
  return keys;
}

TYPED_TEST(TestNodeTable, KeysOfWhichHalfIsTheSameDiffer)
{
  constexpr std::uint64_t upper = std::uint64_t(1) << 32;
  const std::vector<std::uint64_t> keys{ 5 * upper + 7, 7 * upper + 5, 5 * upper, 7 };
  const auto table = MakeTable<TypeParam>(keys);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    ASSERT_NE(table.Find(keys[i]), nullptr);
    EXPECT_EQ(*table.Find(keys[i]), i);
  }
  for (const std::uint64_t other :
    { 5 * upper + 5, 7 * upper + 7, 6 * upper + 7, 5 * upper + 6, 7 * upper, std::uint64_t(5) })
  {
    EXPECT_EQ(table.Find(other), nullptr) << other;
  }
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
  const auto table = MakeTable<TypeParam>(MakeKeysOfLowerCorners(1000));
  const std::vector<std::size_t> lengths = table.GetProbeLengths();
  EXPECT_EQ(std::accumulate(lengths.begin(), lengths.end(), std::size_t(0)), 1000U);
}

/** Random insertions and erasures, checked against the standard table after each. */
template <typename Hash, typename MakeKey>
void ExpectAsStandardTable(std::size_t capacity, const MakeKey& makeKey)
{
  std::mt19937_64 random(42);
  NodeTable<std::uint64_t, Hash> table(capacity);
  std::unordered_map<std::uint64_t, std::uint64_t> expected;
  for (std::uint64_t trial = 0; trial < 4000; ++trial)
  {
    const std::uint64_t key = makeKey(random);
    if (expected.count(key) == 0 && expected.size() < capacity)
    {
      table.Insert(key, trial);
      expected[key] = trial;
    }
    else
    {
      ASSERT_EQ(table.Erase(key), expected.erase(key) == 1);
      ASSERT_EQ(table.Find(key), nullptr);
      ASSERT_FALSE(table.Erase(key));
    }
    ASSERT_EQ(table.GetNumberOfKeys(), expected.size());
    for (const auto& [present, value] : expected)
    {
      const std::uint64_t* found = std::as_const(table).Find(present);
      ASSERT_TRUE(found != nullptr && *found == value) << present;
    }
    std::size_t listed = 0;
    table.ForEach([&listed](std::uint64_t, std::uint64_t) { ++listed; });
    ASSERT_EQ(listed, expected.size());
  }
}

TYPED_TEST(TestNodeTable, ErasesAsTheStandardTableDoes)
{
  for (const std::size_t capacity : { 1U, 2U, 4U, 16U, 61U })
  {
    SCOPED_TRACE(capacity);
    ExpectAsStandardTable<TypeParam>(
      capacity, [capacity](auto& random) { return 1 + random() % (2 * capacity); });
    // All in one bucket's queue, or in that of the last bucket, which goes on in the first.
    ExpectAsStandardTable<TypeParam>(
      capacity, [capacity](auto& random) { return (1 + random() % (2 * capacity)) << 30; });
    ExpectAsStandardTable<TypeParam>(
      capacity, [capacity](auto& random) { return ((1 + random() % (2 * capacity)) << 30) - 1; });
    // In the queues of a few buckets that reach into each other.
    ExpectAsStandardTable<TypeParam>(capacity,
      [capacity](auto& random)
      { return ((1 + random() % capacity) << 30) - 12 + 4 * (random() % 6); });
  }
}

TYPED_TEST(TestNodeTable, WhatIsNotThereEndsAtABucketThatTurnedNoneAway)
{
  std::vector<std::uint64_t> keys(100000);
  std::mt19937_64 random(43);
  std::generate(keys.begin(), keys.end(), std::ref(random));
  auto table = MakeTable<TypeParam>(keys);
  const auto shareOfFirst = [&table]
  {
    const std::vector<std::size_t> lengths = table.GetProbeLengthsOfAbsentKeys();
    const std::size_t buckets = table.GetNumberOfSlots() / SlotsOfBucket;
    EXPECT_EQ(std::accumulate(lengths.begin(), lengths.end(), std::size_t(0)), buckets);
    return static_cast<double>(lengths[0]) / static_cast<double>(buckets);
  };
  EXPECT_GT(shareOfFirst(), 0.9) << "although more buckets are full";
  for (std::size_t i = 0; i < keys.size() / 2; ++i)
  {
    ASSERT_TRUE(table.Erase(keys[i]));
  }
  EXPECT_GT(shareOfFirst(), 0.98);
  for (std::size_t i = keys.size() / 2; i < keys.size(); ++i)
  {
    ASSERT_TRUE(table.Erase(keys[i]));
  }
  EXPECT_EQ(shareOfFirst(), 1.0) << "an empty table has no marks left";
}

TYPED_TEST(TestNodeTable, GrowsWithItsKeys)
{
  NodeTable<std::uint64_t, TypeParam> table;
  for (std::uint64_t key = 1; key <= 3000; ++key)
  {
    const std::size_t slots = table.GetNumberOfSlots();
    const bool isRoom = table.HasRoom(key);
    ASSERT_EQ(isRoom, 2 * key <= slots);
    table.Reserve(key);
    table.Insert(key, 7 * key);
    ASSERT_LE(table.GetLoadFactor(), 0.5);
    ASSERT_TRUE(isRoom ? table.GetNumberOfSlots() == slots : table.GetNumberOfSlots() >= 2 * slots);
  }
  EXPECT_EQ(table.GetNumberOfKeys(), 3000U);
  for (std::uint64_t key = 1; key <= 3000; ++key)
  {
    ASSERT_NE(table.Find(key), nullptr);
    ASSERT_EQ(*table.Find(key), 7 * key);
  }
  EXPECT_EQ(table.Find(3001), nullptr);
}

TYPED_TEST(TestNodeTable, ValuesCanBeChanged)
{
  NodeTable<std::uint64_t, TypeParam> table(1);
  table.Insert(5, 1);
  *table.Find(5) = 2;
  EXPECT_EQ(*std::as_const(table).Find(5), 2U);
}

TEST(TestNodeTableFacts, OnlyLowBitsSendKeysOfTheSameEndToOneSlot)
{
  // Paper E20.
  const std::vector<std::uint64_t> keys = MakeKeysOfLowerCorners(1000);
  EXPECT_DOUBLE_EQ(GetMeanProbeLength(MakeTable<LowBitsHash>(keys)), 125.5);
  EXPECT_LT(GetMeanProbeLength(MakeTable<MixingHash>(keys)), 1.2);
}

TEST(TestNodeTableFacts, OnlySmallTablesStayInACache)
{
  EXPECT_TRUE(NodeTable<std::uint64_t>(1000).IsCached());
  EXPECT_FALSE(NodeTable<std::uint64_t>(1000000).IsCached());
}

TEST(TestNodeTableFacts, MixingIsShortOnAFullTree)
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
