// SPDX-License-Identifier: BSD-3-Clause
#include "PaperGain.h"
#include "PaperSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <stdexcept>

using namespace paper_benchmark;

namespace
{
/** A number of each of the paper's sets. */
template <typename Function>
std::vector<double> GetOfEachSet(const Function& function)
{
  std::vector<double> values;
  for (const PaperSet& set : GetPaperSets())
  {
    values.push_back(function(set.Paper));
  }
  return values;
}

std::vector<double> GetTimes(std::size_t kind, std::size_t column)
{
  return GetOfEachSet([=](const PaperNumbers& set) { return set.Microseconds[kind][column]; });
}

template <typename Function>
double GetMeanByNodes(const Function& function)
{
  return GetWeightedMean(GetOfEachSet(function),
    GetOfEachSet([](const PaperNumbers& set) { return set.ThousandNodes; }));
}
}

/** The numbers of the paper: a wrong digit shows in what the paper makes of them. */
TEST(TestPaperSets, AveragesOfTable1FollowFromItsRows)
{
  const PaperAverages& averages = GetPaperAverages();
  for (std::size_t column = 0; column < StartDepthColumn; ++column)
  {
    EXPECT_NEAR(GetMeanByNodes([=](const PaperNumbers& set) { return set.Megabytes[column]; }),
      averages.Megabytes[column], 0.5);
    // The numbers of nodes are rounded to thousands, which moves the means by 3 ms.
    EXPECT_NEAR(
      GetMeanByNodes([=](const PaperNumbers& set) { return set.BuildMilliseconds[column]; }),
      averages.BuildMilliseconds[column], 4.0);
  }
}

TEST(TestPaperSets, AverageOfOptimisationDoesNot)
{
  // Paper E16.
  EXPECT_EQ(GetPaperAverages().OptimiseMilliseconds, 354.0);
  EXPECT_NEAR(
    GetMeanByNodes([](const PaperNumbers& set) { return set.OptimiseMilliseconds; }), 1230.5, 0.5);
  const auto percent = GetOfEachSet([](const PaperNumbers& set)
    { return 100.0 * set.OptimiseMilliseconds / set.BuildMilliseconds[HashedColumn]; });
  EXPECT_NEAR(*std::min_element(percent.begin(), percent.end()), 2.7, 0.05);
  EXPECT_NEAR(*std::max_element(percent.begin(), percent.end()), 70.3, 0.05);
}

TEST(TestPaperSets, RowsOfTable1AgreeWithEachOther)
{
  for (const PaperSet& set : GetPaperSets())
  {
    SCOPED_TRACE(set.Name);
    const PaperNumbers& paper = set.Paper;
    // Of a complete octree 7 of 8 nodes are leaves; a node with brother and child takes 12 of its
    // 24 bytes, and with eight children 24 of 48, as the paper's MB have it.
    EXPECT_NEAR(paper.ThousandLeaves / paper.ThousandNodes, 0.875, 0.012);
    EXPECT_LE(paper.StartDepth, paper.DeepestDepth);
    EXPECT_NEAR(paper.Megabytes[PointersColumn] / 2.0, paper.Megabytes[BrotherChildColumn], 0.51);
    EXPECT_NEAR(paper.Megabytes[PointersColumn], 0.048 * paper.ThousandNodes,
      0.51 + 0.001 * paper.ThousandNodes);
    EXPECT_LE(paper.Megabytes[BrotherChildColumn], paper.Megabytes[HashedColumn]);
    EXPECT_LT(paper.BuildMilliseconds[BrotherChildColumn], paper.BuildMilliseconds[PointersColumn]);
    // Paper E18: the hashed build is the fastest, but for the smallest set.
    EXPECT_EQ(paper.BuildMilliseconds[HashedColumn] < paper.BuildMilliseconds[BrotherChildColumn],
      set.Name != "sphere_1k");
  }
}

TEST(TestPaperSets, StartDepthOfTheStadiumIsNotThatOfItsLeaves)
{
  // Paper E19. Leaves at the deepest depth are children of nodes with two points at least, and no
  // other node above them shares these: so few cannot be half of all leaves.
  const auto& sets = GetPaperSets();
  const auto stadium = std::find_if(
    sets.begin(), sets.end(), [](const PaperSet& set) { return set.Name == "stadium_10k"; });
  ASSERT_NE(stadium, sets.end());
  EXPECT_EQ(stadium->Paper.StartDepth, stadium->Paper.DeepestDepth);
  const double thousandDeepest = 8.0 * stadium->Paper.ThousandPoints / 2.0;
  EXPECT_LT(thousandDeepest, 0.25 * stadium->Paper.ThousandLeaves);
}

TEST(TestPaperSets, AveragesAndGainsOfTable2FollowFromItsRows)
{
  // Paper E15: the gains are means of ratios, not ratios of means.
  const PaperAverages& averages = GetPaperAverages();
  for (std::size_t kind = 0; kind < averages.Gains.size(); ++kind)
  {
    for (std::size_t column = 0; column < NumberOfColumns; ++column)
    {
      SCOPED_TRACE(std::to_string(kind) + ", " + std::to_string(column));
      EXPECT_NEAR(GetMean(GetTimes(kind, column)), averages.Microseconds[kind][column], 0.0051);
      const Gain gain = GetGain(GetTimes(kind, column), GetTimes(kind, StartDepthColumn));
      EXPECT_NEAR(gain.MeanOfRatios, averages.Gains[kind][column], 0.051);
    }
  }
  const auto getRatioOfMeans = [](std::size_t column)
  { return GetGain(GetTimes(0, column), GetTimes(0, StartDepthColumn)).RatioOfMeans; };
  EXPECT_NEAR(getRatioOfMeans(PointersColumn), 2.9, 0.05);
  EXPECT_NEAR(getRatioOfMeans(BrotherChildColumn), 11.7, 0.05);
  EXPECT_NEAR(getRatioOfMeans(HashedColumn), 20.8, 0.05);
}

TEST(TestPaperSets, GainsInTheCaptionOfTable2)
{
  // "Between 10 % (random volume) and 1090 % (maracanã)", over 8 pointers.
  const auto gains = GetOfEachSet([](const PaperNumbers& set)
    { return set.Microseconds[0][PointersColumn] / set.Microseconds[0][StartDepthColumn]; });
  EXPECT_NEAR(*std::min_element(gains.begin(), gains.end()), 1.10, 0.005);
  EXPECT_NEAR(*std::max_element(gains.begin(), gains.end()), 10.9, 0.05);
}

TEST(TestPaperSets, AreThoseOfTheGenerator)
{
  // "name": (generator, count),   # the paper's name
  const auto script =
    std::filesystem::path(__FILE__).parent_path() / "../../Data/make_point_sets.py";
  std::ifstream file(script);
  const std::regex entry("    \"(\\w+)\": \\(.+, ([0-9_]+)\\), +# (.+)");
  std::vector<std::string> generated;
  std::smatch match;
  for (std::string line; std::getline(file, line);)
  {
    if (std::regex_match(line, match, entry))
    {
      std::string count = match[2];
      count.erase(std::remove(count.begin(), count.end(), '_'), count.end());
      generated.push_back(match[1].str() + ", " + count + ", " + match[3].str());
    }
  }
  std::vector<std::string> sets;
  for (const PaperSet& set : GetPaperSets())
  {
    sets.push_back(set.Name + ", " + std::to_string(set.Points) + ", " + set.Paper.Name);
  }
  EXPECT_EQ(sets.size(), 17U);
  EXPECT_EQ(generated, sets);
}

TEST(TestPaperSets, PointsAreReadWholeOrNotAtAll)
{
  // A random name, so that runs at the same time do not meet.
  const auto folder = std::filesystem::temp_directory_path() /
    ("TestPaperSets." + std::to_string(std::random_device()()));
  std::filesystem::create_directory(folder);
  PaperSet set;
  set.Name = "two";
  set.Points = 2;
  const std::vector<float> points{ 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F };
  const auto write = [&](std::size_t bytes)
  {
    std::ofstream(folder / "two.xyz", std::ios::binary)
      .write(reinterpret_cast<const char*>(points.data()), static_cast<std::streamsize>(bytes));
  };
  const auto getError = [&]
  {
    try
    {
      ReadPoints(folder.string(), set);
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string advice =
    "; make the points with /usr/bin/python3 Data/make_point_sets.py FOLDER, and give --points "
    "FOLDER";
  const std::string path = "'" + (folder / "two.xyz").string() + "'";
  EXPECT_EQ(getError(), "cannot read " + path + advice);
  const std::string tooSmall = path + " does not hold 2 points" + advice;
  for (const std::size_t bytes : { 0, 12, 23 })
  {
    write(bytes);
    EXPECT_EQ(getError(), tooSmall);
  }
  write(24);
  EXPECT_EQ(ReadPoints(folder.string(), set), points);
  set.Points = 1;
  EXPECT_EQ(getError(), path + " does not hold 1 points" + advice);
  std::filesystem::remove_all(folder);
}

TEST(TestPaperSets, NamesAreDifferent)
{
  std::vector<std::string> names;
  for (const PaperSet& set : GetPaperSets())
  {
    names.push_back(set.Name);
    names.push_back(set.Paper.Name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names.size(), 34U);
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}
