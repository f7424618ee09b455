// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorGroup_h
#define Testing_Benchmarks_LocatorGroup_h

#include "LocatorCheck.h"
#include "LocatorOptions.h"
#include "LocatorQueries.h"

#include <benchmark/benchmark.h>

#include <map>

namespace locator_benchmark
{
/** The benchmarks of one data set, which run in turns. They share the built locators, and only one
 * group is in memory at a time. */
class LocatorGroup
{
public:
  /** Both must outlive the group. */
  LocatorGroup(const LocatorOptions& options, const LocatorData& data);
  ~LocatorGroup();
  LocatorGroup(const LocatorGroup&) = delete;
  void operator=(const LocatorGroup&) = delete;

  /** Registers the benchmarks with Google Benchmark, until the group is destroyed. */
  void Register();

private:
  void Run(benchmark::State& state, const LocatorCase& which);
  void BuildPeers();

  /** What is wrong with the peer, which then has no time; empty when nothing is. */
  std::string FindError(const LocatorCase& which);
  LocatorCheck& GetCheck(const LocatorCase& which);
  Question MakeQuestion(const LocatorCase& which) const;

  const LocatorOptions& Options;
  const LocatorData& Data;
  LocatorQueries Queries;
  std::map<std::string, std::unique_ptr<LocatorPeer>> Peers;
  std::map<std::string, std::unique_ptr<LocatorCheck>> Checks;
  std::map<std::string, CheckResult> CheckResults;
};
}

#endif
