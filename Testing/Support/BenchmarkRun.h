// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_BenchmarkRun_h
#define Testing_Support_BenchmarkRun_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

/** A benchmark's program, which stands beside the test's, and a folder for what it reads and
 * writes. The folder has a random name, so that runs at the same time do not meet, and a blank in
 * it, as paths may have. */
class BenchmarkRun
{
public:
  explicit BenchmarkRun(std::string program)
    : Program(std::move(program))
    , Folder(std::filesystem::temp_directory_path() /
        ("Test " + this->Program + "." + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(this->Folder);
  }
  ~BenchmarkRun() { std::filesystem::remove_all(this->Folder); }
  BenchmarkRun(const BenchmarkRun&) = delete;
  BenchmarkRun& operator=(const BenchmarkRun&) = delete;

  /** For the program's arguments. */
  std::string Quote(const std::string& file) const { return "'" + this->GetPath(file) + "'"; }

  std::string GetPath(const std::string& file) const { return (this->Folder / file).string(); }

  /** Whether it succeeds. What it says is in log.txt. */
  bool Succeeds(const std::string& arguments) const
  {
    const auto program = std::filesystem::canonical("/proc/self/exe").parent_path() / this->Program;
    const std::string command =
      "$EMULATOR '" + program.string() + "' " + arguments + " >" + this->Quote("log.txt") + " 2>&1";
    return std::system(command.c_str()) == 0;
  }

  /** The lines of a file in the folder. */
  std::vector<std::string> ReadLines(const std::string& file) const
  {
    std::ifstream text(this->GetPath(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
    {
      lines.push_back(line);
    }
    return lines;
  }

  std::ptrdiff_t CountFiles() const
  {
    return std::distance(std::filesystem::directory_iterator(this->Folder), {});
  }

private:
  std::string Program;
  std::filesystem::path Folder;
};

#endif
