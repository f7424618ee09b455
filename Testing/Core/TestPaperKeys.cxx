// SPDX-License-Identifier: BSD-3-Clause
#include "PaperKeys.h"

#include <gtest/gtest.h>

using namespace paper_benchmark;

TEST(TestPaperKeys, ProbesAreSharedOutByPowersOfTwo)
{
  // 1 key by looking at 1 bucket, 2 by 2, and so on to 18 keys by 18 buckets: 171 keys.
  std::vector<std::size_t> lengths;
  for (std::size_t buckets = 1; buckets <= 18; ++buckets)
  {
    lengths.push_back(buckets);
  }
  const HashProbes probes = SummariseProbes(0.25, lengths);
  EXPECT_EQ(probes.Load, 0.25);
  EXPECT_EQ(probes.Greatest, 18U);
  EXPECT_DOUBLE_EQ(probes.Mean, 18.0 * 19.0 * 37.0 / 6.0 / 171.0);
  const double keys[]{ 1.0, 2.0, 7.0, 26.0, 100.0, 35.0 };
  for (std::size_t i = 0; i < probes.Shares.size(); ++i)
  {
    EXPECT_DOUBLE_EQ(probes.Shares[i], keys[i] / 171.0);
  }
}

TEST(TestPaperKeys, AllInTheFirstBucket)
{
  const HashProbes probes = SummariseProbes(0.5, { 7 });
  EXPECT_EQ(probes.Shares.front(), 1.0);
  EXPECT_EQ(probes.Mean, 1.0);
  EXPECT_EQ(probes.Greatest, 1U);
}
