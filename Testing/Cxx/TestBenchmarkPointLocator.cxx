// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRun.h"
#include "MarkdownTables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{
/** All peers, operations and positions, in a time that threads may need to start. */
constexpr const char* SmallRun = "--data clusters,outlier --sizes 1000 --threads 1,2 "
                                 "--queries near,uniform,ordered,points,above "
                                 "--operations build,closest,closest8,closest32,closest100,radius "
                                 "--repetition-time 0.0001 --benchmark_repetitions=1 ";

class TestBenchmarkPointLocator : public testing::Test
{
protected:
  bool Succeeds(const std::string& arguments) const
  {
    return this->Locators.Succeeds("--output " + this->Locators.Quote("") + " " + arguments);
  }

  BenchmarkRun Locators{ "BenchmarkPointLocator" };
};
}

TEST_F(TestBenchmarkPointLocator, MeasuresAllPeersAndChecksTheirAnswers)
{
  ASSERT_TRUE(this->Succeeds(SmallRun));
  std::ifstream file(this->Locators.GetPath("locator.md"));
  const MarkdownTables report(file);
  const MarkdownTables::Table& times = report.Get("Point locators");
  // Of each data set and number of threads one row of builds, and five operations at five kinds of
  // positions.
  ASSERT_EQ(times.size(), 1U + 2 * 2 * (1 + 5 * 5));
  for (std::size_t row = 1; row < times.size(); ++row)
  {
    // Behind the time of ours how many times as long the six others take.
    ASSERT_EQ(times[row].size(), 13U);
    for (std::size_t column = 6; column < times[row].size(); ++column)
    {
      const double value = std::strtod(times[row][column].c_str(), nullptr);
      EXPECT_TRUE(value > 0.0 && std::isfinite(value)) << row << ": " << times[row][column];
    }
  }
}

TEST_F(TestBenchmarkPointLocator, BadArguments)
{
  for (const std::string arguments : { "--data bunny", "--data terrain --terrain none.vtp",
         "--sizes 10", "--queries", "--threads 0", "--operations close", "--peers octrees",
         "--repetition-time x", "--fast", "--benchmark_out=file", "--benchmark_list_tests=true",
         "--benchmark_report_aggregates_only=true", "--benchmark_display_aggregates_only=true",
         "--data cube --sizes 1000 --benchmark_filter=none" })
  {
    EXPECT_FALSE(this->Succeeds(arguments)) << arguments;
    const std::vector<std::string> said = this->Locators.ReadLines("log.txt");
    ASSERT_FALSE(said.empty());
    EXPECT_EQ(said.back().rfind("error: ", 0), 0U) << said.back();
    EXPECT_EQ(this->Locators.CountFiles(), 1) << "what it said";
  }
}
