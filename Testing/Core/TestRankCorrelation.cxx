// SPDX-License-Identifier: BSD-3-Clause
#include "RankCorrelation.h"

#include <gtest/gtest.h>

/** The statistics of Testing/Benchmarks. */
TEST(TestRankCorrelation, RanksOfEqualsAreShared)
{
  EXPECT_EQ(GetRanks({ 3.0, 1.0, 3.0, 2.0 }), (std::vector<double>{ 2.5, 0.0, 2.5, 1.0 }));
  EXPECT_TRUE(GetRanks({}).empty());
}

TEST(TestRankCorrelation, OnlyTheOrderMatters)
{
  EXPECT_DOUBLE_EQ(GetRankCorrelation({ 1.0, 2.0, 3.0 }, { -1.0, 5.0, 1e9 }), 1.0);
  EXPECT_DOUBLE_EQ(GetRankCorrelation({ 1.0, 2.0, 3.0 }, { 9.0, 8.0, -1e9 }), -1.0);
}

TEST(TestRankCorrelation, KnownValues)
{
  // 1 - 6 * (sum of the squares of the differences of ranks, 10) / (5 * 24).
  EXPECT_DOUBLE_EQ(
    GetRankCorrelation({ 1.0, 2.0, 3.0, 4.0, 5.0 }, { 20.0, 10.0, 50.0, 30.0, 40.0 }), 0.6);
  // With ties: the correlation of the ranks (0, 1.5, 1.5, 3) and (0, 1, 2, 3).
  EXPECT_DOUBLE_EQ(
    GetRankCorrelation({ 1.0, 2.0, 2.0, 4.0 }, { 1.0, 2.0, 3.0, 4.0 }), 4.5 / std::sqrt(4.5 * 5.0));
}

TEST(TestRankCorrelation, NothingCorrelatesWithNothing)
{
  EXPECT_EQ(GetRankCorrelation({ 1.0, 1.0 }, { 1.0, 2.0 }), 0.0);
  EXPECT_EQ(GetRankCorrelation({ 1.0 }, { 1.0 }), 0.0);
  EXPECT_EQ(GetRankCorrelation({}, {}), 0.0);
}
