// SPDX-License-Identifier: BSD-3-Clause
/**
 * Time to build point locators and to search with them: ours beside those of VTK and nanoflann, on
 * the same points and at the same positions, in turns. All searches are checked against each other
 * at some positions, and ours at a few against every point (LocatorCheck.h).
 */
#include "LocatorFile.h"
#include "LocatorGroup.h"
#include "LocatorReport.h"
#include "LocatorSamples.h"
#include "ReportFile.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <stdexcept>

using namespace locator_benchmark;

namespace
{
/** Repetitions in random order, so that a machine that changes its speed slows all peers alike. */
void InitializeGoogleBenchmark(const std::string& program, const std::vector<std::string>& others)
{
  static std::vector<std::string> arguments{ program, "--benchmark_repetitions=5",
    "--benchmark_enable_random_interleaving=true" };
  arguments.insert(arguments.end(), others.begin(), others.end());
  std::vector<char*> pointers;
  pointers.reserve(arguments.size());
  for (std::string& argument : arguments)
  {
    pointers.push_back(argument.data());
  }
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (count > 1)
  {
    throw std::runtime_error(std::string("unknown argument '") + pointers[1] + "'; try --help");
  }
}

std::size_t RunGroup(
  const LocatorOptions& options, const LocatorData& data, LocatorResults& results)
{
  const auto start = std::chrono::steady_clock::now();
  LocatorGroup group(options, data);
  group.Register();
  const std::size_t count = benchmark::RunSpecifiedBenchmarks(&results);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  std::printf("%s, %zu points: %zu benchmarks in %.0f s\n", data.GetName().c_str(),
    data.GetNumberOfPoints(), count, time.count());
  std::fflush(stdout);
  return count;
}

std::size_t RunSamples(const LocatorOptions& options, LocatorResults& results)
{
  std::size_t count = 0;
  for (const std::size_t size : options.Sizes)
  {
    for (const std::string& name : options.Data)
    {
      count += RunGroup(options, MakeSample(name, size, options.TerrainPath), results);
    }
  }
  return count;
}

/** Sets Data and Sizes to what the file has, since the report takes its rows from them. */
std::size_t RunOwnData(LocatorOptions& options, LocatorResults& results)
{
  const LocatorData data = ReadOwnData(*options.PointsPath);
  options.Data = { data.GetName() };
  options.Sizes = { data.GetNumberOfPoints() };
  return RunGroup(options, data, results);
}

int Run(const std::string& program, LocatorOptions options)
{
  InitializeGoogleBenchmark(program, options.Others);
  ReportFile json(options.OutputDirectory + "/locator.json");
  ReportFile markdown(options.OutputDirectory + "/locator.md");
  LocatorResults results(json.GetStream());
  const std::size_t count =
    options.PointsPath ? RunOwnData(options, results) : RunSamples(options, results);
  results.Close();
  if (count == 0)
  {
    throw std::runtime_error("--benchmark_filter leaves nothing to measure");
  }
  WriteReport(options, results, markdown.GetStream());
  json.Keep();
  markdown.Keep();
  return results.HasFailed() ? 1 : 0;
}
}

int main(int argc, char** argv)
{
  try
  {
    const LocatorOptions options = ReadOptions({ argv + 1, argv + argc });
    if (options.HelpWanted)
    {
      std::cout << GetHelp();
    }
    return Run(argv[0], options);
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << error.what() << "\n";
    return 2;
  }
}
