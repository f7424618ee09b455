// SPDX-License-Identifier: BSD-3-Clause
#include "ContinuousCost.h"

#include "OddHistogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace hashedoctree;

namespace
{
/** Share of the weight at a depth. */
double GetShare(const DepthHistogram& histogram, std::size_t depth)
{
  double total = 0.0;
  for (const std::uint64_t weight : histogram)
  {
    total += static_cast<double>(weight);
  }
  return static_cast<double>(histogram[depth]) / total;
}

/** What all searches together examine beyond their leaves when they start at a depth. */
std::uint64_t GetSumOfDistances(const DepthHistogram& histogram, int startDepth)
{
  std::uint64_t sum = 0;
  for (int depth = 0; depth < static_cast<int>(histogram.size()); ++depth)
  {
    sum += histogram[static_cast<std::size_t>(depth)] *
      static_cast<std::uint64_t>(std::abs(depth - startDepth));
  }
  return sum;
}

/** The paper's integral by the midpoint rule, from the density itself. */
double IntegrateCost(const DepthHistogram& histogram, double x)
{
  constexpr int steps = 2000;
  double cost = 1.0;
  for (std::size_t depth = 0; depth < histogram.size(); ++depth)
  {
    for (int step = 0; step < steps; ++step)
    {
      const double t = (step + 0.5) / steps;
      const double density = 6.0 * GetShare(histogram, depth) * t * (1.0 - t);
      cost += density * std::abs(x - static_cast<double>(depth) - t) / steps;
    }
  }
  return cost;
}
}

TEST(TestContinuousCost, IsTheIntegralOfThePaper)
{
  std::mt19937 random(91);
  for (int trial = 0; trial < 20; ++trial)
  {
    const DepthHistogram histogram = MakeOddHistogram(random);
    const ContinuousCost cost(histogram);
    for (double x = -1.0; x < 24.0; x += 0.37)
    {
      ASSERT_NEAR(cost.GetCost(x), IntegrateCost(histogram, x), 1e-5);
    }
  }
}

TEST(TestContinuousCost, ExceedsTheDiscreteCostByThreeSixteenths)
{
  // Paper E8: it does not interpolate.
  std::mt19937 random(92);
  for (int trial = 0; trial < 200; ++trial)
  {
    const DepthHistogram histogram = MakeOddHistogram(random);
    const ContinuousCost cost(histogram);
    for (std::size_t depth = 0; depth < histogram.size(); ++depth)
    {
      ASSERT_NEAR(cost.GetCost(static_cast<double>(depth) + 0.5),
        GetMeanCost(histogram, static_cast<int>(depth)) + 3.0 / 16.0 * GetShare(histogram, depth),
        1e-12);
    }
  }
}

TEST(TestContinuousCost, DerivativeIsTheDistributionTwiceLessOne)
{
  std::mt19937 random(93);
  const DepthHistogram histogram = MakeOddHistogram(random);
  const ContinuousCost cost(histogram);
  constexpr double step = 1e-5;
  for (double x = 0.05; x < static_cast<double>(histogram.size()); x += 0.1)
  {
    const double slope = (cost.GetCost(x + step) - cost.GetCost(x - step)) / (2.0 * step);
    ASSERT_NEAR(slope, 2.0 * cost.GetDistribution(x) - 1.0, 1e-6);
  }
  EXPECT_EQ(cost.GetDistribution(-3.0), 0.0);
  EXPECT_NEAR(cost.GetDistribution(30.0), 1.0, 1e-12);
}

TEST(TestContinuousCost, FloorOfTheMinimiserIsTheMedian)
{
  // Paper Fig. 8 and E9: the integer part is right, rounding is not.
  std::mt19937 random(94);
  int wronglyRounded = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const DepthHistogram histogram = MakeOddHistogram(random);
    const ContinuousCost cost(histogram);
    const double minimiser = cost.GetMinimiser();
    ASSERT_NEAR(cost.GetDistribution(minimiser), 0.5, 1e-9);
    ASSERT_EQ(static_cast<int>(std::floor(minimiser)), GetMedianDepth(histogram));
    ASSERT_EQ(GetBestStartDepth(histogram), GetMedianDepth(histogram));
    wronglyRounded += std::lround(minimiser) != GetMedianDepth(histogram) ? 1 : 0;
  }
  EXPECT_GT(wronglyRounded, 500);
}

TEST(TestContinuousCost, FloorOfTheMinimiserIsACheapestDepthInTies)
{
  std::mt19937 random(95);
  int ties = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    DepthHistogram histogram(1 + random() % 8);
    for (std::uint64_t& weight : histogram)
    {
      weight = random() % (3 + trial % 10);
    }
    histogram.back() = 1;
    const int median = GetMedianDepth(histogram);
    std::uint64_t upTo = 0;
    std::uint64_t above = 0;
    for (std::size_t depth = 0; depth < histogram.size(); ++depth)
    {
      (static_cast<int>(depth) <= median ? upTo : above) += histogram[depth];
    }
    const double minimiser = ContinuousCost(histogram).GetMinimiser();
    const int floor = static_cast<int>(std::floor(minimiser));
    ASSERT_EQ(GetSumOfDistances(histogram, floor), GetSumOfDistances(histogram, median));
    ASSERT_EQ(floor, upTo == above ? median + 1 : median);
    ASSERT_TRUE(upTo != above || minimiser == floor) << "the lower end of the gap";
    ties += floor == median ? 0 : 1;
  }
  EXPECT_GT(ties, 100);
}

TEST(TestContinuousCost, NoWeight)
{
  const ContinuousCost cost(DepthHistogram{ 0, 0 });
  EXPECT_EQ(cost.GetCost(1.0), 0.0);
  EXPECT_EQ(cost.GetMinimiser(), 0.0);
  EXPECT_EQ(cost.GetDistribution(1.0), 0.0);
}

TEST(TestContinuousCost, GapInTheMiddle)
{
  // Half of the weight on either side of depths 2 to 4: the smallest minimiser is the gap's lower
  // end.
  const ContinuousCost cost(DepthHistogram{ 0, 4, 0, 0, 0, 4 });
  EXPECT_EQ(cost.GetMinimiser(), 2.0);
  EXPECT_NEAR(cost.GetCost(2.0), cost.GetCost(4.5), 1e-12);
}

TEST(TestContinuousCost, WeightsOfManyDigits)
{
  // One more above depth 1 than it has: to the last of 60 bits, all but one of them lie from there
  // on.
  const std::uint64_t large = (std::uint64_t(1) << 60) + 128;
  const ContinuousCost cost(DepthHistogram{ large, 1, large + 1 });
  EXPECT_EQ(cost.GetMinimiser(), 2.0);
}
