// SPDX-License-Identifier: BSD-3-Clause
#include "PaperMinimisers.h"

#include <gtest/gtest.h>

using namespace paper_benchmark;

/** Paper E9: the integer part is right, about half of the roundings are wrong. */
TEST(TestPaperMinimisers, IntegerPartIsRightRoundingIsNot)
{
  const MinimiserComparison comparison = CompareMinimisers(500);
  EXPECT_EQ(comparison.Histograms, 500U);
  EXPECT_EQ(comparison.Agreeing, 500U);
  EXPECT_EQ(comparison.BestInTies, 500U);
  EXPECT_EQ(comparison.OtherInTies, 500U);
  EXPECT_GT(comparison.WronglyRounded, 150U);
  EXPECT_LT(comparison.WronglyRounded, 350U);
}

TEST(TestPaperMinimisers, SameHistogramsEachTime)
{
  EXPECT_EQ(CompareMinimisers(100).WronglyRounded, CompareMinimisers(100).WronglyRounded);
  EXPECT_EQ(CompareMinimisers(0).Histograms, 0U);
}
