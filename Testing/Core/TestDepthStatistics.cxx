// SPDX-License-Identifier: BSD-3-Clause
#include "DepthStatistics.h"

#include "RandomHistogram.h"
#include "SampleTree.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace hashedoctree;

TEST(TestDepthStatistics, CostByHand)
{
  const DepthHistogram histogram{ 0, 2, 1, 1 };
  EXPECT_DOUBLE_EQ(GetMeanCost(histogram, 0), (2 * 2 + 3 + 4) / 4.0);
  EXPECT_DOUBLE_EQ(GetMeanCost(histogram, 1), (2 * 1 + 2 + 3) / 4.0);
  EXPECT_DOUBLE_EQ(GetMeanCost(histogram, 2), (2 * 2 + 1 + 2) / 4.0);
  EXPECT_DOUBLE_EQ(GetMeanCost(histogram, 5), (2 * 5 + 4 + 3) / 4.0);
}

TEST(TestDepthStatistics, NoWeight)
{
  for (const DepthHistogram& histogram : { DepthHistogram{}, DepthHistogram{ 0, 0, 0 } })
  {
    EXPECT_EQ(GetMeanCost(histogram, 1), 0.0);
    EXPECT_EQ(GetMedianDepth(histogram), 0);
    EXPECT_EQ(GetMeanDepth(histogram), 0);
    EXPECT_EQ(GetBestStartDepth(histogram), 0);
  }
}

TEST(TestDepthStatistics, TiesGoToTheSmallerDepth)
{
  EXPECT_EQ(GetMedianDepth({ 0, 5, 0, 0, 5 }), 1);
  EXPECT_EQ(GetMedianDepth({ 0, 5, 0, 0, 6 }), 4);
  EXPECT_EQ(GetMedianDepth({ 0, 5, 1, 0, 5 }), 2);
  EXPECT_DOUBLE_EQ(GetMeanCost({ 0, 5, 0, 0, 5 }, 1), GetMeanCost({ 0, 5, 0, 0, 5 }, 4));
}

TEST(TestDepthStatistics, EachModelHasItsStartDepth)
{
  const DepthCounts counts{ { 0, 6, 0, 1, 4 }, { 0, 5, 0, 0, 2 }, { 0, 4, 0, 0, 5 } };
  const auto get = [&counts](StartDepthModel model, FrequencyModel frequency) {
    return GetStartDepth(counts, { model, frequency, 7 }, 3);
  };
  for (const StartDepthModel median : { StartDepthModel::Median, StartDepthModel::Local })
  {
    EXPECT_EQ(get(median, FrequencyModel::Leaves), 1);
    EXPECT_EQ(get(median, FrequencyModel::Points), 4);
    EXPECT_EQ(get(median, FrequencyModel::Grid), 1);
  }
  EXPECT_EQ(get(StartDepthModel::Mean, FrequencyModel::Leaves), 2) << "25 / 11";
  EXPECT_EQ(get(StartDepthModel::Mean, FrequencyModel::Points), 3) << "24 / 9";
  EXPECT_EQ(get(StartDepthModel::Mean, FrequencyModel::Grid), 1);
  EXPECT_EQ(get(StartDepthModel::Root, FrequencyModel::Leaves), 0);
  EXPECT_EQ(get(StartDepthModel::Fixed, FrequencyModel::Leaves), 7);
}

TEST(TestDepthStatistics, MeanDepthIsRounded)
{
  EXPECT_EQ(GetMeanDepth({ 0, 0, 0, 7 }), 3);
  EXPECT_EQ(GetMeanDepth({ 0, 1, 1 }), 2) << "one and a half goes up";
  EXPECT_EQ(GetMeanDepth({ 0, 2, 1 }), 1);
  EXPECT_EQ(GetMeanDepth({ 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 }), 1);
  // To the last digit, also beyond those of a double.
  const std::uint64_t many = std::uint64_t(1) << 62;
  EXPECT_EQ(GetMeanDepth({ many, many }), 1);
  EXPECT_EQ(GetMeanDepth({ many + 1, many }), 0);
  EXPECT_EQ(GetMeanDepth({ 0, 0, 2 * many }), 2);
}

TEST(TestDepthStatistics, MedianCostsTheLeast)
{
  std::mt19937 random(81);
  for (int trial = 0; trial < 2000; ++trial)
  {
    DepthHistogram histogram = MakeRandomHistogram(random, 1 + random() % 22);
    histogram.back() += 1;
    const int cheapest = GetBestStartDepth(histogram);
    for (int depth = 0; depth < 30; ++depth)
    {
      ASSERT_LE(GetMeanCost(histogram, cheapest), GetMeanCost(histogram, depth));
    }
    ASSERT_EQ(GetMedianDepth(histogram), cheapest);
  }
}

TEST(TestDepthStatistics, MedianOfTheGridModelCostsTheLeast)
{
  // From depths 1 to 3 the costs are equal to the last digit, of which a double has too few.
  const DepthHistogram leaves{ 0, 2, 0, 30, 6, 7, 3, 1, 11, 0, 15, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1,
    10, 7, 2, 7, 3, 3, 3, 4 };
  const DepthHistogram histogram = GetDepthHistogram({ leaves, {}, {} }, FrequencyModel::Grid, 2);
  EXPECT_EQ(GetMedianDepth(histogram), 1);
  EXPECT_EQ(GetBestStartDepth(histogram), 1);
}

TEST(TestDepthStatistics, FrequencyModels)
{
  const DepthCounts counts{ { 0, 6, 16 }, { 0, 2, 10 }, { 0, 40, 7 } };
  EXPECT_EQ(GetDepthHistogram(counts, FrequencyModel::Leaves, 3), (DepthHistogram{ 0, 6, 16 }));
  EXPECT_EQ(GetDepthHistogram(counts, FrequencyModel::Points, 3), (DepthHistogram{ 0, 40, 7 }));
  EXPECT_EQ(GetDepthHistogram(counts, FrequencyModel::Grid, 3), (DepthHistogram{ 0, 48, 16 }));
  EXPECT_EQ(GetDepthHistogram(counts, FrequencyModel::Grid, 2), (DepthHistogram{ 0, 24, 16 }));
}

TEST(TestDepthStatistics, GridWeightsAddUpToTheRoot)
{
  // Down to the last depth the sum is 2^63, which only integers hold to the last digit.
  const PointSample<3, double> coincident{ "coincident", std::vector<double>(300, 1.0) };
  for (const auto& sample :
    { coincident, PointSample<3, double>{ "clusters", MakeClusteredPoints<3, double>(5000, 82) } })
  {
    const SampleTree<3, double> made(sample);
    const DepthHistogram grid =
      GetDepthHistogram(made.Tree.GetDepthCounts(), FrequencyModel::Grid, 3);
    EXPECT_EQ(std::accumulate(grid.begin(), grid.end(), std::uint64_t(0)),
      std::uint64_t(1) << (3 * made.Tree.GetDeepestDepth()));
  }
}

TEST(TestDepthStatistics, GridMedianHoldsAtFullDepth)
{
  // Chain of coincident points: 7/8 of the volume is at depth 1.
  const SampleTree<3, double> made(
    PointSample<3, double>{ "coincident", std::vector<double>(300, 1.0) });
  EXPECT_EQ(made.Tree.GetDeepestDepth(), 21);
  EXPECT_EQ(
    GetMedianDepth(GetDepthHistogram(made.Tree.GetDepthCounts(), FrequencyModel::Grid, 3)), 1);
}
