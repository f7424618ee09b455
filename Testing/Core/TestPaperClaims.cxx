// SPDX-License-Identifier: BSD-3-Clause
#include "InventedPaperResults.h"
#include "MarkdownTables.h"
#include "PaperClaims.h"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

using namespace paper_benchmark;

namespace
{
using Sets = std::vector<PaperResults>;

/** Sets with which all claims hold: the more the depths vary, the less is gained. */
Sets MakeSets()
{
  Sets sets;
  for (int i = 0; i < 5; ++i)
  {
    sets.push_back(InventPaperResults("set" + std::to_string(i)));
    PaperResults& set = sets.back();
    set.DepthDeviation = 1.0 + i;
    set.Costs.Root = 20.0 - i;
    set.Times[Direct][PaperRoot] = InventTime((60.0 - i) * 1e-6);
    set.Times[Direct][OursRoot] = InventTime((50.0 - i) * 1e-6);
  }
  return sets;
}

using Verdicts = std::vector<std::string>;

/** The row of the claim that begins so: what is measured and the verdict, of the paper's layout and
 * of ours. */
Verdicts Judge(const Sets& sets, const std::string& claim)
{
  std::stringstream text;
  WriteClaims(text, sets);
  const MarkdownTables report(text);
  for (const auto& row : report.Get("Claims of the paper"))
  {
    if (row.front().rfind(claim, 0) == 0)
    {
      return { row.begin() + 1, row.end() };
    }
  }
  return {};
}

/** Breaks a claim in one set, then in all of them, which must show in the verdict of one layout, 0
 * of the paper's and 1 of ours, and in that alone when the claim is judged for each. */
void ExpectJudged(const std::string& claim, std::size_t layout,
  const std::function<void(PaperResults&)>& breakIn, const std::string& inOne,
  const std::string& inAll = "does not hold")
{
  SCOPED_TRACE(claim + ", layout " + std::to_string(layout));
  Sets sets = MakeSets();
  Verdicts row = Judge(sets, claim);
  ASSERT_EQ(row.size(), 4U);
  const bool both = row[2] == "the same";
  EXPECT_EQ(row[2 * layout + 1], "holds");
  breakIn(sets[2]);
  row = Judge(sets, claim);
  EXPECT_EQ(row[2 * layout + 1], inOne);
  EXPECT_EQ(row[3 - 2 * layout], both ? inOne : row[0] == "-" ? "-" : "holds");
  std::for_each(sets.begin(), sets.end(), breakIn);
  row = Judge(sets, claim);
  EXPECT_EQ(row[2 * layout + 1], inAll);
}

constexpr const char* OneOfFive = "depends: 4 of 5 sets";
constexpr const char* OneOfFifteen = "depends: 14 of 15 models of sets";
constexpr const char* TenOfFifteen = "depends: 10 of 15 models of sets";
}

TEST(TestPaperClaims, OfModels)
{
  ExpectJudged(
    "The optimised start is never worse", 0,
    [](PaperResults& set) { set.Frequencies[1].Medians[1] = 11.0; }, OneOfFifteen, TenOfFifteen);
  ExpectJudged(
    "... nor slower, direct", 0,
    [](PaperResults& set) { set.Times[Direct][PaperRoot] = InventTime(1e-6); }, OneOfFive);
  ExpectJudged(
    "... nor slower, direct", 1,
    [](PaperResults& set) { set.Times[Direct][OursRoot] = InventTime(0.5e-6); }, OneOfFive);
  ExpectJudged(
    "The root is the worst", 0, [](PaperResults& set) { set.Frequencies[2].Deepest = 11.0; },
    OneOfFifteen, TenOfFifteen);
  ExpectJudged(
    "The right frequency model is the best", 0,
    [](PaperResults& set) { set.Frequencies[0].Medians[2] = 1.5; }, OneOfFifteen, TenOfFifteen);
  ExpectJudged(
    "... and the fastest", 0,
    [](PaperResults& set) { set.PaperWorkloads[0][1] = InventTime(1e-6); }, OneOfFifteen,
    TenOfFifteen);
  ExpectJudged(
    "... and the fastest", 1,
    [](PaperResults& set) { set.OurWorkloads[2][0] = InventTime(0.5e-6); }, OneOfFifteen,
    TenOfFifteen);
}

TEST(TestPaperClaims, OfNeighborsAndBuilds)
{
  ExpectJudged(
    "... and not slower than pointers", 0,
    [](PaperResults& set) { set.Times[Direct][Pointers] = InventTime(1.5e-6); }, OneOfFive);
  ExpectJudged(
    "... and not slower than pointers", 1,
    [](PaperResults& set) { set.Times[Direct][OursMedian] = InventTime(5e-6); }, OneOfFive);
  ExpectJudged(
    "Adjacent searches are not slower", 0,
    [](PaperResults& set) { set.Times[Adjacent][PaperRoot] = InventTime(1.5e-6); }, OneOfFive);
  ExpectJudged(
    "... and in-radius ones", 1,
    [](PaperResults& set) { set.Times[InRadius][OursRoot] = InventTime(0.5e-6); }, OneOfFive);
  ExpectJudged(
    "From the root, direct searches in hashed", 0,
    [](PaperResults& set) { set.Times[Direct][PaperRoot] = InventTime(20e-6); }, OneOfFive);
  ExpectJudged(
    "From the root, direct searches in hashed", 1,
    [](PaperResults& set) { set.Times[Direct][OursRoot] = InventTime(20e-6); }, OneOfFive);
  ExpectJudged(
    "From the root, direct searches in hashed", 0,
    [](PaperResults& set)
    {
      set.Times[Direct][BrotherChild] = InventTime(1e-6);
      set.Times[Direct][PaperRoot] = InventTime(3e-6);
    },
    OneOfFive);
  ExpectJudged(
    "From the root, direct searches in hashed", 0,
    [](PaperResults& set) { set.Times[Direct][PaperRoot] = set.Times[Direct][BrotherChild]; },
    OneOfFive);
  EXPECT_NE(Judge(MakeSets(), "From the root, direct searches in hashed")[0].find(
              "time over 8 pointers: 14.0 to 15.0, mean 14.5; over brother/child: 1.75 to 1.88"),
    std::string::npos);
  EXPECT_NE(Judge(MakeSets(), "From the start depth leaves above")[2].find("1.048 to 1.048"),
    std::string::npos);
  ExpectJudged(
    "From the start depth leaves above", 1,
    [](PaperResults& set) { set.Neighbors.Adjacent.Climbing = 21.0; }, OneOfFive);
  ExpectJudged(
    "The direct start depth serves", 1,
    [](PaperResults& set) { set.Neighbors.Adjacent.Median = 23.0; }, OneOfFive);
  ExpectJudged(
    "The direct start depth serves", 0,
    [](PaperResults& set) { set.Neighbors.PaperAdjacent.Median = 28.0; }, OneOfFive);
  ExpectJudged(
    "... and in-radius searches", 0,
    [](PaperResults& set) { set.Neighbors.PaperInRadius.Median = 39.0; }, OneOfFive);
  ExpectJudged(
    "From the start depth leaves above", 0,
    [](PaperResults& set) { set.Neighbors.PaperAdjacent.Climbing = 26.0; }, OneOfFive);
  ExpectJudged(
    "... and in-radius searches", 1,
    [](PaperResults& set) { set.Neighbors.InRadius.Median = 34.0; }, OneOfFive);
  ExpectJudged(
    "A start depth for each node", 1, [](PaperResults& set) { set.Neighbors.Adjacent.Own = 21.0; },
    OneOfFive);
  ExpectJudged(
    "The build is not slower", 0,
    [](PaperResults& set) { set.Builds[PaperBuilt] = InventTime(5.0); }, OneOfFive);
  ExpectJudged(
    "The build is not slower", 1,
    [](PaperResults& set) { set.Builds[OursBuilt] = InventTime(3.5); }, OneOfFive);
  ExpectJudged(
    "The memory is not above", 0, [](PaperResults& set) { set.Bytes[PaperBuilt] = 43U << 20; },
    OneOfFive);
  ExpectJudged(
    "The memory is not above", 1, [](PaperResults& set) { set.Bytes[OursBuilt] = 43U << 20; },
    OneOfFive);
  ExpectJudged(
    "Choosing the start depth", 0, [](PaperResults& set) { set.PaperOptimise = InventTime(0.021); },
    OneOfFive);
  ExpectJudged(
    "Choosing the start depth", 1, [](PaperResults& set) { set.OurOptimise = InventTime(0.011); },
    OneOfFive);
}

TEST(TestPaperClaims, SpeedUpIsTheMeanOfRatiosToBrotherChild)
{
  // 16 and 32 times in each set; in one of them 10 times, by which the mean falls below 15.
  Sets sets = MakeSets();
  const std::string claim = "Direct searches are 15 times";
  EXPECT_EQ(Judge(sets, claim)[1], "holds");
  EXPECT_EQ(Judge(sets, claim)[3], "holds");
  sets[1].Times[Direct][PaperStart] = InventTime(3.2e-6);
  EXPECT_EQ(Judge(sets, claim)[1], "does not hold");
  EXPECT_EQ(Judge(sets, claim)[3], "holds");
  EXPECT_NE(Judge(sets, claim)[0].find("10.0 to 16.0, mean 14.8"), std::string::npos);
  EXPECT_NE(Judge(sets, claim)[0].find("ratio of means: 14.3"), std::string::npos);
  for (PaperResults& set : sets)
  {
    set.Times[Adjacent][OursMedian] = InventTime(17e-6);
  }
  EXPECT_EQ(Judge(sets, "Adjacent searches are several")[3], "does not hold");
  EXPECT_EQ(Judge(sets, "Adjacent searches are several")[1], "holds");
  EXPECT_EQ(Judge(sets, "In-radius searches are several")[3], "holds");
}

TEST(TestPaperClaims, GainByDeviationIsACorrelation)
{
  Sets sets = MakeSets();
  const std::string claim = "The gain is small where depths vary";
  EXPECT_EQ(Judge(sets, claim)[1], "holds");
  EXPECT_EQ(Judge(sets, claim)[3], "holds");
  for (PaperResults& set : sets)
  {
    set.Times[Direct][OursRoot] = InventTime(set.DepthDeviation);
  }
  EXPECT_EQ(Judge(sets, claim)[1], "holds");
  EXPECT_EQ(Judge(sets, claim)[3], "depends: nodes holds, time does not hold");
  sets.resize(2);
  EXPECT_EQ(Judge(sets, claim)[1], "cannot be told");
}

TEST(TestPaperClaims, TimesThatOverlapCannotBeTold)
{
  // Not slower is no verdict where the median is, however widely the repetitions are spread.
  Sets sets = MakeSets();
  Spread& build = sets[2].Builds[OursBuilt];
  build.Median = 1.02 * std::max(sets[2].Builds[PointersBuilt].Median, build.Median);
  build.Lower = 0.5 * build.Median;
  const std::string claim = "The build is not slower";
  EXPECT_EQ(Judge(sets, claim)[3], "depends: 4 of 5 sets, cannot be told in 1");
  sets[0].Builds[OursBuilt] = InventTime(10.0 * build.Median);
  EXPECT_EQ(Judge(sets, claim)[3], "depends: 3 of 5 sets, cannot be told in 1");
  sets[2].Times[Direct][OursMedian] = { 1.02 * sets[2].Times[Direct][OursRoot].Median, 0.0, 1.0 };
  EXPECT_EQ(Judge(sets, "... nor slower")[3], "depends: 4 of 5 sets, cannot be told in 1");
}

TEST(TestPaperClaims, GainsOfTwoSetsAreRanked)
{
  // The gains fall from set to set.
  const std::string volume = "... as in random volumes";
  const std::string detail = "... and large with many levels of detail";
  Sets sets = MakeSets();
  EXPECT_EQ(Judge(sets, volume)[1], "not measured");
  sets[4].Set.Name = "random_cube_4000k";
  sets[1].Set.Name = "stadium_10k";
  EXPECT_EQ(Judge(sets, volume)[1], "holds");
  EXPECT_EQ(Judge(sets, volume)[3], "holds");
  EXPECT_EQ(Judge(sets, detail)[3], "holds");
  EXPECT_NE(Judge(sets, detail)[0].find("less than in 1 of 4 others; in time"), std::string::npos);
  std::swap(sets[4].Set.Name, sets[1].Set.Name);
  EXPECT_EQ(Judge(sets, volume)[1], "does not hold");
  EXPECT_EQ(Judge(sets, detail)[1], "does not hold");
  sets[1].Times[Direct][OursRoot] = InventTime(1e-6);
  EXPECT_EQ(Judge(sets, volume)[3], "depends: nodes does not hold, time holds");
}

TEST(TestPaperClaims, OfMinimisers)
{
  // Paper E9.
  const Verdicts floor = Judge(MakeSets(), "The integer part of the continuous minimiser");
  EXPECT_EQ(floor[0], "the three agree on 2000 of 2000 random histograms of odd weight");
  EXPECT_EQ(floor[1], "holds");
  const Verdicts rounded = Judge(MakeSets(), "... and so it is when rounded");
  const int wrong = std::stoi(rounded[0].substr(std::string("rounding is wrong on ").size()));
  EXPECT_EQ(rounded[1], "depends: " + std::to_string(2000 - wrong) + " of 2000 histograms");
  EXPECT_EQ(Judge(MakeSets(), "... and so it is where half of the weight lies")[1], "holds");
}

TEST(TestPaperClaims, MemoryIsJudgedOfBigSets)
{
  Sets sets = MakeSets();
  sets[0].Nodes = 1000;
  sets[0].Bytes[OursBuilt] = 100U << 20;
  const std::string claim = "The memory is not above";
  EXPECT_EQ(Judge(sets, claim)[3], "holds");
  sets.resize(1);
  EXPECT_EQ(Judge(sets, claim)[3], "not measured");
}
