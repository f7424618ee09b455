// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorOptions_h
#define Testing_Benchmarks_LocatorOptions_h

#include "LocatorCase.h"

#include <optional>

namespace locator_benchmark
{
/** What to measure, from the command line. */
struct LocatorOptions
{
  /** Fewer points could not fill the largest answers. */
  static constexpr std::size_t LeastSize = 1000;

  std::vector<std::string> Data{ "terrain", "cube", "sphere", "clusters", "filaments", "duplicates",
    "outlier" };
  std::vector<std::size_t> Sizes{ 10000, 100000, 1000000 };
  std::vector<std::string> Queries{ "near", "uniform" };
  std::vector<Operation> Operations{ Operation::Build, Operation::Closest, Operation::Closest8,
    Operation::Closest32, Operation::Radius };
  std::vector<int> Threads{ 1, 2 };
  /** The first is the one that the others are compared with. */
  std::vector<std::string> Peers;
  /** Seconds after which a repetition stops counting. */
  double RepetitionTime = 0.04;
  std::string TerrainPath;
  /** A file of points to measure in place of Data and Sizes, if given. */
  std::optional<std::string> PointsPath;
  std::string OutputDirectory = ".";
  /** Arguments that are not ours, but Google Benchmark's. */
  std::vector<std::string> Others;
  bool HelpWanted = false;

  /** All benchmarks of one data set and size: builds, then queries. */
  std::vector<LocatorCase> MakeCases(const std::string& data, std::size_t size) const;
};

/** Throws std::runtime_error, with one line that says what is wrong. */
LocatorOptions ReadOptions(const std::vector<std::string>& arguments);

std::string GetHelp();
}

#endif
