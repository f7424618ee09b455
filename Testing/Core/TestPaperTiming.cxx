// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTiming.h"

#include <gtest/gtest.h>

#include <string>

using namespace paper_benchmark;

namespace
{
void ExpectSpread(const std::vector<double>& times, double lower, double median, double upper)
{
  const Spread spread = GetSpread(times);
  EXPECT_DOUBLE_EQ(spread.Lower, lower);
  EXPECT_DOUBLE_EQ(spread.Median, median);
  EXPECT_DOUBLE_EQ(spread.Upper, upper);
}
}

TEST(TestPaperTiming, MedianAndMiddleHalf)
{
  ExpectSpread({ 5.0, 1.0, 4.0, 2.0, 30.0 }, 2.0, 4.0, 5.0);
  ExpectSpread({ 4.0, 1.0, 3.0, 2.0 }, 1.0, 2.5, 4.0);
  ExpectSpread({ 9.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0 }, 3.0, 5.0, 7.0);
  ExpectSpread({ 7.0 }, 7.0, 7.0, 7.0);
}

TEST(TestPaperTiming, WidthIsAShareOfTheMedian)
{
  EXPECT_DOUBLE_EQ(GetWidth({ 4.0, 3.0, 6.0 }), 0.75);
}

TEST(TestPaperTiming, SlowerOnlyWhenTheMiddleHalvesLieApart)
{
  const Spread time{ 4.0, 3.0, 5.0 };
  EXPECT_TRUE(IsSlower(time, { 2.0, 1.0, 2.9 }));
  EXPECT_FALSE(IsSlower(time, { 2.0, 1.0, 3.0 })); // They touch.
  EXPECT_FALSE(IsSlower(time, time));
  EXPECT_FALSE(IsSlower({ 2.0, 1.0, 2.9 }, time));
}

TEST(TestPaperTiming, RunsTakeTurnsAndTimesAreForOneSearch)
{
  // A run that says it took long enough is done once in a repetition.
  std::string order;
  const auto makeRun = [&order](char name, double seconds)
  {
    return [&order, name, seconds]() mutable
    {
      order += name;
      return seconds++;
    };
  };
  const auto seconds = MeasureInTurns({ makeRun('a', 10.0), makeRun('b', 20.0) }, 4, 3);
  EXPECT_EQ(order, "ababab");
  EXPECT_EQ(seconds, (std::vector<std::vector<double>>{ { 2.5, 2.75, 3.0 }, { 5.0, 5.25, 5.5 } }));
}

TEST(TestPaperTiming, FewSearchesAreDoneBeforeTheyAreMeasured)
{
  // Run k takes k microseconds more than a measurement must, ten times which warming may take.
  const auto getTime = [](int k) { return SecondsOfMeasurement + 1e-6 * k; };
  const auto time = [&getTime](std::size_t searches)
  {
    int k = 10;
    const auto spreads =
      TimeInTurns({ [&] { return getTime(0); }, [&] { return getTime(k++); } }, searches, 3);
    EXPECT_NEAR(spreads[0].Median * static_cast<double>(searches), getTime(0), 1e-9);
    return spreads[1].Median * static_cast<double>(searches);
  };
  EXPECT_NEAR(time(MostWarmedSearches), getTime(13), 1e-9); // Of 11, 13 and 15.
  EXPECT_NEAR(time(MostWarmedSearches + 1), getTime(11), 1e-9);
  // Five times before: of 15, 21 and 27.
  EXPECT_NEAR(time(WarmingSearches / 5), getTime(21), 1e-9);
  // Ten times before: of 20, 31 and 42.
  EXPECT_NEAR(time(1), getTime(31), 1e-9);
}

TEST(TestPaperTiming, LongSearchesAreWarmAfterOneRun)
{
  int runs = 0;
  TimeInTurns({ [&runs]
                {
                  ++runs;
                  return MostSecondsOfWarming;
                } },
    1, 3);
  EXPECT_EQ(runs, 3 * 2);
}

TEST(TestPaperTiming, ShortRunsAreRepeated)
{
  int runs = 0;
  const auto seconds = MeasureInTurns({ [&runs]
                                        {
                                          ++runs;
                                          return SecondsOfMeasurement / 4.0;
                                        } },
    1, 2);
  EXPECT_EQ(runs, 8);
  EXPECT_EQ(seconds,
    (std::vector<std::vector<double>>{
      { SecondsOfMeasurement / 4.0, SecondsOfMeasurement / 4.0 } }));
}
