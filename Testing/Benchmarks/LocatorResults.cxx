// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorResults.h"

#include "Median.h"
#include "RunError.h"

#include <cstdio>
#include <limits>

namespace locator_benchmark
{
void LocatorResults::ReportRuns(const std::vector<Run>& runs)
{
  this->Json.ReportRuns(runs);
  for (const Run& run : runs)
  {
    const std::string& name = run.run_name.function_name;
    const std::string error = GetRunError(run);
    if (!error.empty())
    {
      if (this->Errors.emplace(name, error).second)
      {
        std::fprintf(stderr, "error: %s: %s\n", name.c_str(), error.c_str());
      }
    }
    else if (run.run_type == Run::RT_Iteration)
    {
      for (const auto& counter : run.counters)
      {
        this->Counters[name][counter.first].push_back(counter.second.value);
      }
    }
  }
}

double LocatorResults::GetCounter(const LocatorCase& which, const std::string& counter) const
{
  const auto found = this->Counters.find(which.GetName());
  if (found == this->Counters.end() || found->second.count(counter) == 0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return GetMedian(found->second.at(counter));
}
}
