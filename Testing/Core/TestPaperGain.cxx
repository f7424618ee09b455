// SPDX-License-Identifier: BSD-3-Clause
#include "PaperGain.h"

#include <gtest/gtest.h>

using namespace paper_benchmark;

/** Paper E15: both readings, on sets of which one takes ten times as long. */
TEST(TestPaperGain, MeanOfRatiosIsNotRatioOfMeans)
{
  const Gain gain = GetGain({ 6.0, 20.0 }, { 1.0, 10.0 });
  EXPECT_DOUBLE_EQ(gain.MeanOfRatios, 4.0);
  EXPECT_DOUBLE_EQ(gain.RatioOfMeans, 26.0 / 11.0);
}

TEST(TestPaperGain, OverItselfIsOne)
{
  const Gain gain = GetGain({ 6.0, 20.0 }, { 6.0, 20.0 });
  EXPECT_EQ(gain.MeanOfRatios, 1.0);
  EXPECT_EQ(gain.RatioOfMeans, 1.0);
}

TEST(TestPaperGain, Means)
{
  EXPECT_DOUBLE_EQ(GetMean({ 1.0, 2.0, 6.0 }), 3.0);
  EXPECT_DOUBLE_EQ(GetWeightedMean({ 1.0, 2.0, 6.0 }, { 1.0, 1.0, 2.0 }), 3.75);
}
