// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTiming.h"

#include "Median.h"

#include <algorithm>
#include <utility>

namespace paper_benchmark
{
namespace
{
/** Mean seconds of one run. */
double MeasureRun(const std::function<double()>& run)
{
  double seconds = 0.0;
  int runs = 0;
  while (seconds < SecondsOfMeasurement)
  {
    seconds += run();
    ++runs;
  }
  return seconds / runs;
}
}

Spread GetSpread(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  const std::size_t last = times.size() - 1;
  return { GetMedian(times), times[last / 4], times[last - last / 4] };
}

std::vector<std::vector<double>> MeasureInTurns(
  const std::vector<std::function<double()>>& runs, std::size_t searches, int repetitions)
{
  std::vector<std::vector<double>> seconds(runs.size());
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    for (std::size_t run = 0; run < runs.size(); ++run)
    {
      seconds[run].push_back(MeasureRun(runs[run]) / static_cast<double>(searches));
    }
  }
  return seconds;
}

std::vector<Spread> TimeInTurns(
  std::vector<std::function<double()>> runs, std::size_t searches, int repetitions)
{
  if (searches <= MostWarmedSearches)
  {
    const std::size_t before =
      std::clamp<std::size_t>(WarmingSearches / searches, 1, MostWarmingRuns);
    for (std::function<double()>& run : runs)
    {
      run = [before, once = std::move(run)]
      {
        double seconds = 0.0;
        for (std::size_t i = 0; i < before && seconds < MostSecondsOfWarming; ++i)
        {
          seconds += once();
        }
        return once();
      };
    }
  }
  std::vector<Spread> spreads;
  for (const std::vector<double>& times : MeasureInTurns(runs, searches, repetitions))
  {
    spreads.push_back(GetSpread(times));
  }
  return spreads;
}
}
