// SPDX-License-Identifier: BSD-3-Clause
#include "ModelComparison.h"

#include <gtest/gtest.h>

using namespace paper_benchmark;

namespace
{
/** A set whose models have these start depths, and in the row of the leaves these times. */
ModelComparison Compare(
  const std::array<int, NumberOfModels>& startDepths, const std::array<Spread, NumberOfModels>& row)
{
  PaperResults set;
  for (std::size_t model = 0; model < NumberOfModels; ++model)
  {
    set.Frequencies[model].StartDepth = startDepths[model];
  }
  set.OurWorkloads[1] = row;
  return CompareModels(set, &PaperResults::OurWorkloads, 1);
}

constexpr Spread Own{ 10.0, 9.0, 11.0 };
}

TEST(TestModelComparison, WinsWhenAllOthersAreSlower)
{
  const ModelComparison comparison =
    Compare({ 7, 8, 3 }, { { { 15.0, 12.0, 16.5 }, Own, { 20.0, 18.0, 22.0 } } });
  EXPECT_EQ(comparison.Outcome, ModelOutcome::Wins);
  EXPECT_DOUBLE_EQ(comparison.BestOther, 1.5);
  EXPECT_DOUBLE_EQ(comparison.Width, 0.3);
}

TEST(TestModelComparison, TiesWhenOneIsNotSlower)
{
  const ModelComparison comparison =
    Compare({ 7, 8, 3 }, { { { 12.0, 10.5, 13.0 }, Own, { 20.0, 18.0, 22.0 } } });
  EXPECT_EQ(comparison.Outcome, ModelOutcome::Ties);
  EXPECT_DOUBLE_EQ(comparison.BestOther, 1.2);
}

TEST(TestModelComparison, LosesWhenOneIsFaster)
{
  const ModelComparison comparison =
    Compare({ 7, 8, 3 }, { { { 20.0, 18.0, 22.0 }, Own, { 8.0, 7.0, 8.5 } } });
  EXPECT_EQ(comparison.Outcome, ModelOutcome::Loses);
  EXPECT_DOUBLE_EQ(comparison.BestOther, 0.8);
}

TEST(TestModelComparison, ModelsOfTheSameStartDepthDoNotCount)
{
  // The first is faster by chance alone: its searches are the same.
  const std::array<Spread, NumberOfModels> row{ { { 5.0, 4.0, 8.0 }, Own, { 20.0, 18.0, 22.0 } } };
  const ModelComparison comparison = Compare({ 8, 8, 3 }, row);
  EXPECT_EQ(comparison.Outcome, ModelOutcome::Wins);
  EXPECT_DOUBLE_EQ(comparison.BestOther, 2.0);
  EXPECT_DOUBLE_EQ(comparison.Width, 0.2);
  EXPECT_EQ(Compare({ 8, 8, 8 }, row).Outcome, ModelOutcome::Alike);
  EXPECT_EQ(Compare({ 8, 8, 8 }, row).BestOther, 1.0);
}

TEST(TestModelComparison, RowsAndLayoutsAreKeptApart)
{
  PaperResults set;
  for (std::size_t model = 0; model < NumberOfModels; ++model)
  {
    set.Frequencies[model].StartDepth = static_cast<int>(model);
    set.PaperWorkloads[2][model] = { 2.0, 2.0, 2.0 };
    set.OurWorkloads[2][model] = { 6.0, 6.0, 6.0 };
  }
  set.PaperWorkloads[2][2] = { 1.0, 1.0, 1.0 };
  set.OurWorkloads[2][0] = { 3.0, 3.0, 3.0 };
  EXPECT_EQ(CompareModels(set, &PaperResults::PaperWorkloads, 2).Outcome, ModelOutcome::Wins);
  EXPECT_EQ(CompareModels(set, &PaperResults::OurWorkloads, 2).Outcome, ModelOutcome::Loses);
}
