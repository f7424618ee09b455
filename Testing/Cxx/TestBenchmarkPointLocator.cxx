// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRun.h"
#include "MarkdownTables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

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

  /** A file of points on a helix, or at one place where that has no pitch, and of a last one. */
  void WritePoints(
    const std::string& file, int count, const std::string& last, double pitch = 0.1) const
  {
    std::ofstream out(this->Locators.GetPath(file));
    out << "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='" << count + 1
        << "'><Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>\n";
    for (int i = 0; i < count; ++i)
    {
      out << std::cos(pitch * i) << " " << std::sin(pitch * i) << " " << pitch * i << "\n";
    }
    out << last << "</DataArray></Points></Piece></PolyData></VTKFile>\n";
  }

  /** The times of the last run. */
  MarkdownTables::Table ReadTimes() const
  {
    std::ifstream file(this->Locators.GetPath("locator.md"));
    return MarkdownTables(file).Get("Point locators");
  }

  BenchmarkRun Locators{ "BenchmarkPointLocator" };
};
}

TEST_F(TestBenchmarkPointLocator, MeasuresAllPeersAndChecksTheirAnswers)
{
  ASSERT_TRUE(this->Succeeds(SmallRun));
  const MarkdownTables::Table times = this->ReadTimes();
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

TEST_F(TestBenchmarkPointLocator, MeasuresPointsOfAFile)
{
  this->WritePoints("a helix.vtp", 1500, "5 5 5");
  this->WritePoints("one place.vtp", 1500, "5 5 5", 0.0);
  for (const std::string name : { "a helix", "one place" })
  {
    ASSERT_TRUE(this->Succeeds("--points " + this->Locators.Quote(name + ".vtp") +
      " --threads 1 --queries near --operations closest,radius --repetition-time 0.0001"
      " --benchmark_repetitions=1"));
    const MarkdownTables::Table times = this->ReadTimes();
    ASSERT_EQ(times.size(), 1U + 2);
    EXPECT_EQ(times[1][0], name);
    EXPECT_EQ(times[1][1], "1501");
    for (const std::size_t row : { 1U, 2U })
    {
      EXPECT_GT(std::strtod(times[row][6].c_str(), nullptr), 0.0);
    }
  }
}

TEST_F(TestBenchmarkPointLocator, PointsThatCannotBeMeasured)
{
  this->WritePoints("few.vtp", 998, "5 5 5");
  this->WritePoints("infinite.vtp", 1500, "5 inf 5");
  this->WritePoints("large.vtp", 1500, "5 1e39 5"); // for a float
  std::ofstream(this->Locators.GetPath("no.vtp")) << "points\n";
  const std::ptrdiff_t files = this->Locators.CountFiles();
  const std::map<std::string, std::string> reasons{ { "few.vtp", "at least 1000" },
    { "infinite.vtp", "not finite" }, { "large.vtp", "not finite" },
    { "no.vtp", "finds no points" }, { "none.vtp", "cannot read" } };
  for (const auto& [file, reason] : reasons)
  {
    EXPECT_FALSE(this->Succeeds("--points " + this->Locators.Quote(file))) << file;
    const std::vector<std::string> said = this->Locators.ReadLines("log.txt");
    ASSERT_FALSE(said.empty());
    EXPECT_EQ(said.back().rfind("error: ", 0), 0U) << said.back();
    EXPECT_NE(said.back().find(file), std::string::npos) << said.back();
    EXPECT_NE(said.back().find(reason), std::string::npos) << said.back();
    EXPECT_EQ(this->Locators.CountFiles(), files + 1) << "what it said";
  }
}

TEST_F(TestBenchmarkPointLocator, BadArguments)
{
  for (const std::string arguments :
    { "--data bunny", "--data terrain --terrain none.vtp", "--sizes 10", "--points=", "--queries",
      "--threads 0", "--operations close", "--peers octrees", "--repetition-time x", "--fast",
      "--benchmark_out=file", "--benchmark_list_tests=true",
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
