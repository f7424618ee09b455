// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_RatioReporter_h
#define Testing_Benchmarks_RatioReporter_h

#include "Median.h"
#include "RunError.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

/**
 * Collects the real time of every repetition of benchmarks named "subject/data" and prints, after
 * Google Benchmark's own table, one Markdown row per data set: the median time of each subject in
 * milliseconds, its spread (largest less smallest, in percent of the median), and how many times
 * the median of the first subject, in the order of registration, it is.
 */
class RatioReporter : public benchmark::ConsoleReporter
{
public:
  void ReportRuns(const std::vector<Run>& runs) override
  {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
    {
      if (run.run_type == Run::RT_Iteration && GetRunError(run).empty())
      {
        const std::string& name = run.run_name.function_name;
        const std::size_t slash = name.find('/');
        const Key key{ name.substr(0, slash), name.substr(slash + 1) };
        this->Registered[run.family_index] = key;
        this->Times[key].push_back(
          1e3 * run.real_accumulated_time / static_cast<double>(run.iterations));
      }
      this->Failed = this->Failed || !GetRunError(run).empty();
    }
  }

  void Finalize() override
  {
    ConsoleReporter::Finalize();
    std::vector<std::string> subjects;
    std::vector<std::string> dataSets;
    for (const auto& [index, key] : this->Registered) // Reports come in any order.
    {
      AddOnce(key.first, subjects);
      AddOnce(key.second, dataSets);
    }
    std::printf(
      "\nMedian times (their spread), and how many times those of %s they are.\n\n| data |",
      subjects.empty() ? "none" : subjects.front().c_str());
    for (const std::string& subject : subjects)
    {
      std::printf(" %s |", subject.c_str());
    }
    std::printf("\n|---|");
    for (std::size_t i = 0; i < subjects.size(); ++i)
    {
      std::printf("---|");
    }
    for (const std::string& data : dataSets)
    {
      std::printf("\n| %s |", data.c_str());
      const double base = GetMedian(this->Times[{ subjects.front(), data }]);
      for (const std::string& subject : subjects)
      {
        const std::vector<double>& times = this->Times[{ subject, data }];
        const double median = GetMedian(times);
        const auto [least, most] = std::minmax_element(times.begin(), times.end());
        std::printf(" %.1f ms (%.0f %%), x %.2f |", median,
          times.empty() ? 0.0 : 100.0 * (*most - *least) / median, median / base);
      }
    }
    std::printf("\n");
  }

  bool HasFailed() const { return this->Failed; }

private:
  using Key = std::pair<std::string, std::string>; ///< Subject and data.

  static void AddOnce(const std::string& name, std::vector<std::string>& names)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  }

  std::map<std::int64_t, Key> Registered;
  std::map<Key, std::vector<double>> Times;
  bool Failed = false;
};

/** Runs the registered benchmarks: repetitions in random order, so that a machine that changes its
 * speed slows all subjects alike. Returns the exit code: 1 for errors, 2 where the arguments are
 * wrong or leave nothing to measure. */
inline int RunInTurns(int argc, char** argv)
{
  std::vector<std::string> defaults{ argv[0], "--benchmark_repetitions=5",
    "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.2" };
  defaults.insert(defaults.end(), argv + 1, argv + argc);
  std::vector<char*> arguments;
  arguments.reserve(defaults.size());
  for (std::string& argument : defaults)
  {
    arguments.push_back(argument.data());
  }
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  RatioReporter reporter;
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()) ||
    benchmark::RunSpecifiedBenchmarks(&reporter) == 0)
  {
    return 2;
  }
  return reporter.HasFailed() ? 1 : 0;
}

#endif
