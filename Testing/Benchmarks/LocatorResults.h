// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorResults_h
#define Testing_Benchmarks_LocatorResults_h

#include "LocatorCase.h"

#include <benchmark/benchmark.h>

#include <iosfwd>
#include <map>

namespace locator_benchmark
{
/** Takes what Google Benchmark measures: all groups go to one JSON file, and the counters of
 * all repetitions are kept for their medians. */
class LocatorResults : public benchmark::BenchmarkReporter
{
public:
  /** Writes JSON to the stream, which must outlive this. */
  explicit LocatorResults(std::ostream& json) { this->Json.SetOutputStream(&json); }

  bool ReportContext(const Context& context) override
  {
    return this->HasContext || (this->HasContext = this->Json.ReportContext(context));
  }

  void ReportRuns(const std::vector<Run>& runs) override;

  /** Ends the file. Not Finalize(), which is called after every group. */
  void Close() { this->Json.Finalize(); }

  bool HasFailed() const { return !this->Errors.empty(); }
  const std::map<std::string, std::string>& GetErrors() const { return this->Errors; }

  /** A counter of a benchmark, the median of its repetitions; not a number when there is none. */
  double GetCounter(const LocatorCase& which, const std::string& counter) const;

  /** The seconds for one query or build. */
  double GetSeconds(const LocatorCase& which) const
  {
    return this->GetCounter(which, "seconds_each");
  }

private:
  benchmark::JSONReporter Json;
  bool HasContext = false;
  std::map<std::string, std::map<std::string, std::vector<double>>> Counters;
  std::map<std::string, std::string> Errors;
};
}

#endif
