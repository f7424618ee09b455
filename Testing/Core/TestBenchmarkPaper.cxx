// SPDX-License-Identifier: BSD-3-Clause
#include "MarkdownTables.h"
#include "ReportFile.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

namespace
{
/** The program beside this one, on point sets that have the names and sizes of the smallest ones of
 * the paper's experiments, but random points. */
class TestBenchmarkPaper : public testing::Test
{
protected:
  /** The folder has a random name, so that runs at the same time do not meet, and a blank in it, as
   * paths may have. */
  TestBenchmarkPaper()
    : Folder(std::filesystem::temp_directory_path() /
        ("Test BenchmarkPaper." + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(this->Folder);
    this->WritePoints("sphere_1k", 900);
    this->WritePoints("stadium_10k", 10000);
  }
  ~TestBenchmarkPaper() override { std::filesystem::remove_all(this->Folder); }

  void WritePoints(const std::string& name, std::size_t count) const
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform;
    std::ofstream file(this->Folder / (name + ".xyz"), std::ios::binary);
    for (std::size_t i = 0; i < 3 * count; ++i)
    {
      const float coordinate = uniform(random);
      file.write(reinterpret_cast<const char*>(&coordinate), sizeof(coordinate));
    }
  }

  /** Whether it succeeds. What it says is in log.txt. */
  bool Run(const std::string& arguments) const
  {
    const auto program =
      std::filesystem::canonical("/proc/self/exe").parent_path() / "BenchmarkPaper";
    const std::string folder = "'" + this->Folder.string() + "'";
    const std::string command = "$EMULATOR '" + program.string() + "' --points " + folder +
      " --output " + folder + "/paper.md " + arguments + " >" + folder + "/log.txt 2>&1";
    return std::system(command.c_str()) == 0;
  }

  std::vector<std::string> ReadLog() const
  {
    std::ifstream log(this->Folder / "log.txt");
    std::vector<std::string> lines;
    for (std::string line; std::getline(log, line);)
    {
      lines.push_back(line);
    }
    return lines;
  }

  std::ptrdiff_t CountFiles() const
  {
    return std::distance(std::filesystem::directory_iterator(this->Folder), {});
  }

  std::filesystem::path Folder;
};

bool IsTime(const std::string& cell)
{
  return std::stod(cell) > 0.0 && cell.find(" ~") != std::string::npos;
}
}

TEST_F(TestBenchmarkPaper, WritesAllTables)
{
  ASSERT_TRUE(this->Run("--sets sphere_1k,stadium_10k --repetitions 3"));
  std::ifstream file(this->Folder / "paper.md");
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

  std::ifstream text(this->Folder / "paper.md");
  std::string line;
  while (line.rfind("- Answers: ", 0) != 0 && std::getline(text, line))
  {
  }
  EXPECT_EQ(line.rfind("- Answers: 0 of ", 0), 0U) << line;
}

TEST_F(TestBenchmarkPaper, MissingSetIsAnErrorBeforeAnythingIsMeasured)
{
  std::ofstream(this->Folder / "paper.md") << "of the run before";
  for (const std::string arguments : { "", "--quick", "--sets sphere_1k,csg_82k" })
  {
    EXPECT_FALSE(this->Run(arguments));
    ASSERT_EQ(this->ReadLog().size(), 1U);
    EXPECT_EQ(this->ReadLog().front().rfind("error: cannot read '", 0), 0U);
  }
  std::string kept;
  std::getline(std::ifstream(this->Folder / "paper.md"), kept);
  EXPECT_EQ(kept, "of the run before");
  EXPECT_EQ(this->CountFiles(), 4) << "the points, the log and the old report";
}

TEST_F(TestBenchmarkPaper, RunThatFailsLeavesTheReportOfAnotherAlone)
{
  ReportFile report((this->Folder / "paper.md").string());
  EXPECT_EQ(this->CountFiles(), 2) << "the points; a run that is killed leaves nothing else";
  EXPECT_FALSE(this->Run("--sets sphere"));
  report.GetStream() << "of another run";
  report.Keep();
  EXPECT_EQ(std::filesystem::file_size(this->Folder / "paper.md"), 14U);
}

TEST_F(TestBenchmarkPaper, FolderIsNoReport)
{
  const std::filesystem::path folder = this->Folder / "folder";
  std::filesystem::create_directory(folder);
  EXPECT_THROW(ReportFile(folder.string()), std::runtime_error);
  EXPECT_EQ(this->CountFiles(), 3) << "the points and the folder";
}

TEST_F(TestBenchmarkPaper, BadArguments)
{
  for (const std::string arguments : { "--sets sphere", "--quick --sets flow_257k",
         "--repetitions 2", "--repetitions 5x", "--repetitions 3.5", "--fast", "--sets" })
  {
    EXPECT_FALSE(this->Run(arguments)) << arguments;
    ASSERT_EQ(this->ReadLog().size(), 1U);
    EXPECT_EQ(this->ReadLog().front().rfind("error: ", 0), 0U);
  }
}
