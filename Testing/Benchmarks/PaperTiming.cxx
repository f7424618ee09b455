// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTiming.h"

#include <algorithm>

namespace paper_benchmark
{
std::vector<Spread> TimeInTurns(
  const std::vector<std::function<double()>>& runs, std::size_t searches, int repetitions)
{
  std::vector<std::vector<double>> seconds(runs.size());
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    for (std::size_t run = 0; run < runs.size(); ++run)
    {
      seconds[run].push_back(runs[run]() / static_cast<double>(searches));
    }
  }
  std::vector<Spread> spreads;
  for (std::vector<double>& times : seconds)
  {
    std::sort(times.begin(), times.end());
    const std::size_t middle = times.size() / 2;
    const double median =
      times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2.0;
    spreads.push_back({ median, times.front(), times.back() });
  }
  return spreads;
}
}
