// SPDX-License-Identifier: BSD-3-Clause
#include "PaperReport.h"

#include "InventedPaperResults.h"
#include "MarkdownTables.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace paper_benchmark;

namespace
{
/** The report of two sets. The second has three times the nodes, four times the bytes and the time
 * of builds, and in the searches of the paper's layout from its start depth ten times the time. */
MarkdownTables MakeReport()
{
  std::vector<PaperResults> sets{ InventPaperResults("first"), InventPaperResults("second") };
  sets[1].Set.Paper = GetPaperSets()[1].Paper; // 144 against 4.4 thousand nodes
  sets[1].Nodes *= 3;
  sets[1].Bytes[PaperBuilt] *= 4;
  sets[1].Builds[PaperBuilt] = InventTime(8.0);
  for (auto& times : sets[1].Times)
  {
    times[PaperStart] = { 20e-6, 18e-6, 24e-6 };
  }
  sets[1].OurWorkloads[0][0] = { 5e-6, 3e-6, 9e-6 };
  std::stringstream text;
  WriteReport(sets, 5, text);
  return MarkdownTables(text);
}
}

TEST(TestPaperReport, Table1HasThePapersNumbersBesideOurs)
{
  const MarkdownTables report = MakeReport();
  EXPECT_EQ(report.GetCell("Trees", "second", "nodes x1000"), "24000 (144)");
  EXPECT_EQ(report.GetCell("Trees", "second", "leaves x1000"), "7000 (126)");
  EXPECT_EQ(report.GetCell("Trees", "second", "points x1000"), "1000 (35)");
  EXPECT_EQ(report.GetCell("Trees", "first", "deepest depth"), "12 (6)");
  EXPECT_EQ(report.GetCell("Trees", "first", "start depth"), "8 (4)");
  EXPECT_EQ(report.GetCell("Memory, MB", "second", "paper's layout (the paper's)"), "80.0 (50)");
  EXPECT_EQ(report.GetCell("Memory, MB", "second", "ours"), "10.0");
  EXPECT_EQ(report.GetCell("Builds, ms", "second", "br./child (the paper's)"), "3000 ~10% (215)");
  EXPECT_EQ(report.GetCell("Builds, ms", "first", "paper's layout / 8 pointers"), "0.50 (1.98)");
  EXPECT_EQ(report.GetCell("Builds, ms", "first", "ours / 8 pointers"), "0.25");
  const std::string optimise = "Choosing the start depth, us";
  EXPECT_EQ(report.GetCell(optimise, "first", "paper's layout (the paper's)"), "10000 ~10% (7800)");
  EXPECT_EQ(report.GetCell(optimise, "first", "% of its build (the paper's)"), "0.500 (70.3)");
}

TEST(TestPaperReport, MeansOfTable1AreWeightedByNodes)
{
  const MarkdownTables report = MakeReport();
  // (20 + 3 * 80) / 4, and (4.4 * 45 + 144 * 50) / 148.4.
  EXPECT_EQ(
    report.GetCell("Memory, MB", "mean by nodes", "paper's layout (the paper's)"), "65.0 (49.9)");
  EXPECT_EQ(
    report.GetCell("Builds, ms", "mean by nodes", "paper's layout (the paper's)"), "6500 (182)");
  EXPECT_EQ(
    report.GetCell("The paper's averages", "printed", "ms choosing the start depth"), "354");
  EXPECT_EQ(
    report.GetCell("The paper's averages", "from its rows", "ms choosing the start depth"), "1231");
}

TEST(TestPaperReport, Table2HasGainsBothWays)
{
  const MarkdownTables report = MakeReport();
  const std::string kind = "Adjacent neighbours";
  EXPECT_EQ(report.GetCell(kind, "second", "paper, start depth"), "20.0 ~30% (8.70)");
  EXPECT_EQ(report.GetCell(kind, "second", "8 pointers"), "4.00 ~10% (38.34)");
  EXPECT_EQ(report.GetCell(kind, "second", "brother/child"), "32.0 ~10% (35.93)");
  EXPECT_EQ(report.GetCell(kind, "second", "paper, root"), "8.00 ~10% (59.70)");
  EXPECT_EQ(report.GetCell(kind, "second", "ours, median"), "1.00 ~10%");
  EXPECT_EQ(report.GetCell(kind, "mean", "paper, start depth"), "11.0 (8.16)");
  EXPECT_EQ(report.GetCell(kind, "largest spread", "paper, start depth"), "~30%");
  // Of 32 over 2 and 20; in the paper of 23.85 and 35.93 over 7.63 and 8.70.
  EXPECT_EQ(
    report.GetCell(kind, "mean of ratios to paper, start depth", "brother/child"), "x 8.80 (3.63)");
  EXPECT_EQ(
    report.GetCell(kind, "ratio of means to paper, start depth", "brother/child"), "x 2.91 (3.66)");
  EXPECT_EQ(report.GetCell(kind, "mean of ratios to ours, median", "paper, start depth"), "x 11.0");
  EXPECT_EQ(report.GetCell("The paper's gains", "Direct search", "brother/child"), "x 15.7");
}

TEST(TestPaperReport, NodesAndProbes)
{
  const MarkdownTables report = MakeReport();
  const std::string neighbors = "Start depths of neighbour searches";
  EXPECT_EQ(report.GetCell(neighbors, "first", "climbing"), "22.0");
  EXPECT_EQ(report.GetCell(neighbors, "first", "best depth for all"), "20.0 (9)");
  EXPECT_EQ(report.GetCell(neighbors, "first", "best for each"), "18.0");
  EXPECT_EQ(report.GetCell(neighbors, "first", "adjacent, us: median"), "4.00 ~10%");
  EXPECT_EQ(report.Get(neighbors)[1].back(), "3.00 ~10%");
  const std::string ofPaper = "The same in the paper's layout";
  EXPECT_EQ(report.GetCell(ofPaper, "first", "adjacent: top-down"), "17.0");
  EXPECT_EQ(report.GetCell(ofPaper, "first", "in-radius: top-down"), "19.0");
  const std::string chains = "Chains in the paper's table";
  EXPECT_EQ(report.GetCell(chains, "first", "mean"), "2.20");
  EXPECT_EQ(report.GetCell(chains, "first", "mean if even"), "2.50");
  const MarkdownTables::Table& probes = report.Get("Buckets of ours");
  EXPECT_EQ(probes[1],
    (MarkdownTables::Row{
      "first", "low bits", "0.50", "60.0", "10.0", "10.0", "10.0", "10.0", "0.00", "2.00", "9" }));
  EXPECT_EQ(probes[2][1], "mixing");
}

TEST(TestPaperReport, ModelsAndBatches)
{
  const MarkdownTables report = MakeReport();
  EXPECT_EQ(report.Get("Start-depth models")[1],
    (MarkdownTables::Row{ "first", "1.00", "10.0", "2.00", "2.50", "1.80", "1.60", "1.50" }));
  EXPECT_EQ(report.Get("Frequency models in nodes")[2],
    (MarkdownTables::Row{
      "first", "leaves", "10.0", "4.00 (from 6)", "2.00 (from 7)", "4.00 (from 8)", "8.00" }));
  EXPECT_EQ(report.Get("Gain by deviation of depth")[1],
    (MarkdownTables::Row{ "first", "1.00", "9.00", "5.00", "4.00", "6.00" }));
  EXPECT_EQ(report.Get("Direct search for many positions at once")[1],
    (MarkdownTables::Row{ "first", "8000", "3.00 ~10%", "2.00 ~10%", "x 1.50" }));
}

TEST(TestPaperReport, Table3HasTheLargestSpread)
{
  const MarkdownTables report = MakeReport();
  const std::string heading = "Table 3: direct searches by frequency model, us each";
  EXPECT_EQ(report.GetCell(heading, "all points", "ours: f_points"), "3.00 ~120%");
  EXPECT_EQ(report.GetCell(heading, "all leaves", "f_leaves"), "0.93");
  EXPECT_EQ(report.GetCell(heading, "a grid of 128^3", "f_grid"), "0.89") << "E12";
  const std::string bySet = heading + " 2";
  EXPECT_EQ(report.GetCell(bySet, "first", "start depths"), "6, 7, 8");
  EXPECT_EQ(report.GetCell(bySet, "first", "ours: all points"), "wins, x 3.00 ~10%");
  EXPECT_EQ(report.GetCell(bySet, "second", "ours: all points"), "ties, x 0.60 ~120%");
}
