// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkRun.h"
#include "MarkdownTables.h"
#include "ReportFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

namespace
{
/** The program on point sets that have the names and sizes of the smallest ones of the paper's
 * experiments, but random points. */
class TestBenchmarkPaper : public testing::Test
{
protected:
  TestBenchmarkPaper()
  {
    this->WritePoints("sphere_1k", 900);
    this->WritePoints("stadium_10k", 10000);
  }

  void WritePoints(const std::string& name, std::size_t count) const
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform;
    std::ofstream file(this->Paper.GetPath(name + ".xyz"), std::ios::binary);
    for (std::size_t i = 0; i < 3 * count; ++i)
    {
      const float coordinate = uniform(random);
      file.write(reinterpret_cast<const char*>(&coordinate), sizeof(coordinate));
    }
  }

  bool Succeeds(const std::string& arguments) const
  {
    return this->Paper.Succeeds("--points " + this->Paper.Quote("") + " --output " +
      this->Paper.Quote("paper.md") + " " + arguments);
  }

  /** Expects the program to end with one line. */
  void ExpectError(const std::string& arguments, const std::string& error) const
  {
    EXPECT_FALSE(this->Succeeds(arguments)) << arguments;
    const std::vector<std::string> said = this->Paper.ReadLines("log.txt");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said.front().rfind(error, 0), 0U) << said.front();
  }

  BenchmarkRun Paper{ "BenchmarkPaper" };
};

bool IsTime(const std::string& cell)
{
  return std::stod(cell) > 0.0 && cell.find(" ~") != std::string::npos;
}
}

TEST_F(TestBenchmarkPaper, WritesAllTables)
{
  ASSERT_TRUE(this->Succeeds("--sets sphere_1k,stadium_10k --repetitions 3"));
  std::ifstream file(this->Paper.GetPath("paper.md"));
  const MarkdownTables report(file);
  EXPECT_EQ(report.GetCell("Trees", "sphere_1k", "points x1000"), "0.90 (0.9)");
  EXPECT_EQ(report.GetCell("Trees", "stadium_10k", "points x1000"), "10.0 (10)");
  for (const std::string kind : { "Direct search", "Adjacent neighbours", "In-radius neighbours" })
  {
    for (const std::string set : { "sphere_1k", "stadium_10k" })
    {
      EXPECT_TRUE(IsTime(report.GetCell(kind, set, "8 pointers")));
      EXPECT_TRUE(IsTime(report.GetCell(kind, set, "ours, local")));
    }
  }
  EXPECT_TRUE(IsTime(report.GetCell("Builds, ms", "sphere_1k", "ours")));
  EXPECT_LT(std::stod(report.GetCell("Choosing the start depth, us", "sphere_1k", "ours")), 10.0)
    << "a thousand of them take longer, but one does not even where it is emulated";
  const std::string starts = "Start depths of neighbour searches";
  EXPECT_LT(std::stod(report.GetCell(starts, "stadium_10k", "climbing")),
    std::stod(report.GetCell(starts, "stadium_10k", "adjacent: root")));
  const std::string options = "The option of the adjacent search that the paper rejects";
  const std::string ofPaper = "The same in the paper's layout";
  const double topDown = std::stod(report.GetCell(ofPaper, "stadium_10k", "adjacent: top-down"));
  EXPECT_LT(topDown, std::stod(report.GetCell(ofPaper, "stadium_10k", "root")));
  EXPECT_GT(topDown, 8.0) << "at least the seven leaves around a corner, and the root";
  EXPECT_TRUE(IsTime(report.GetCell(options, "stadium_10k", "us")));
  EXPECT_GT(std::stod(report.GetCell(options, "stadium_10k", "rejected: nodes")),
    std::stod(report.GetCell(options, "stadium_10k", "taken: nodes")));
  EXPECT_GE(report.Get("Claims of the paper").size(), 19U);

  const std::vector<std::string> lines = this->Paper.ReadLines("paper.md");
  const auto answers = std::find_if(lines.begin(), lines.end(),
    [](const std::string& line) { return line.rfind("- Answers: ", 0) == 0; });
  ASSERT_NE(answers, lines.end());
  EXPECT_EQ(answers->rfind("- Answers: 0 of ", 0), 0U) << *answers;
}

TEST_F(TestBenchmarkPaper, MissingSetIsAnErrorBeforeAnythingIsMeasured)
{
  std::ofstream(this->Paper.GetPath("paper.md")) << "of the run before";
  for (const std::string arguments : { "", "--quick", "--sets sphere_1k,csg_82k" })
  {
    this->ExpectError(arguments, "error: cannot read '");
  }
  EXPECT_EQ(this->Paper.ReadLines("paper.md"), std::vector<std::string>{ "of the run before" });
  EXPECT_EQ(this->Paper.CountFiles(), 4) << "the points, the log and the old report";
}

TEST_F(TestBenchmarkPaper, RunThatFailsLeavesTheReportOfAnotherAlone)
{
  ReportFile report(this->Paper.GetPath("paper.md"));
  EXPECT_EQ(this->Paper.CountFiles(), 2) << "the points; a run that is killed leaves nothing else";
  EXPECT_FALSE(this->Succeeds("--sets sphere"));
  report.GetStream() << "of another run";
  report.Keep();
  EXPECT_EQ(this->Paper.ReadLines("paper.md"), std::vector<std::string>{ "of another run" });
}

TEST_F(TestBenchmarkPaper, FolderIsNoReport)
{
  std::filesystem::create_directory(this->Paper.GetPath("folder"));
  EXPECT_THROW(ReportFile(this->Paper.GetPath("folder")), std::runtime_error);
  EXPECT_EQ(this->Paper.CountFiles(), 3) << "the points and the folder";
}

TEST_F(TestBenchmarkPaper, BadArguments)
{
  for (const std::string arguments : { "--sets sphere", "--quick --sets flow_257k",
         "--repetitions 2", "--repetitions 5x", "--repetitions 3.5", "--fast", "--sets" })
  {
    this->ExpectError(arguments, "error: ");
  }
}
