// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorResults.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace locator_benchmark
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

void LocatorResults::ReportRuns(const std::vector<Run>& runs)
{
  this->Json.ReportRuns(runs);
  for (const Run& run : runs)
  {
    const std::string& name = run.run_name.function_name;
    if (run.error_occurred)
    {
      if (this->Errors.emplace(name, run.error_message).second)
      {
        std::fprintf(stderr, "error: %s: %s\n", name.c_str(), run.error_message.c_str());
      }
    }
    else if (run.run_type == Run::RT_Iteration)
    {
      this->Seconds[name].push_back(run.counters.at("seconds_each").value);
      for (const auto& counter : run.counters)
      {
        this->Counters[name][counter.first] = counter.second.value;
      }
    }
  }
}

double LocatorResults::GetSeconds(const LocatorCase& which) const
{
  const auto found = this->Seconds.find(which.GetName());
  if (found == this->Seconds.end())
  {
    return NotANumber;
  }
  std::vector<double> times = found->second;
  std::sort(times.begin(), times.end());
  const std::size_t middle = times.size() / 2;
  return times.size() % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
}

double LocatorResults::GetCounter(const LocatorCase& which, const std::string& counter) const
{
  const auto found = this->Counters.find(which.GetName());
  if (found == this->Counters.end() || found->second.count(counter) == 0)
  {
    return NotANumber;
  }
  return found->second.at(counter);
}
}
