// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperTiming_h
#define Testing_Benchmarks_PaperTiming_h

#include <chrono>
#include <functional>
#include <vector>

namespace paper_benchmark
{
/** Of repeated measurements, in seconds: the median, and between which times the middle half of
 * them lies. */
struct Spread
{
  double Median = 0.0;
  double Lower = 0.0;
  double Upper = 0.0;
};

/** The width of the middle half over the median. */
inline double GetWidth(const Spread& time)
{
  return (time.Upper - time.Lower) / time.Median;
}

/** One is slower than another when the middle halves of their repetitions lie apart. */
inline bool IsSlower(const Spread& time, const Spread& other)
{
  return time.Lower > other.Upper;
}

/** How long a call takes. */
template <typename Function>
double GetSeconds(const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/** A measurement goes on for at least so long: runs that take less are repeated for it. */
constexpr double SecondsOfMeasurement = 2e-3;

/** Runs of no more searches are done before they are measured: some structures are searched in turn
 * in several ways, and the first one shall not load the caches for the others. A run of more
 * searches does that for itself. */
constexpr std::size_t MostWarmedSearches = 1000000;

/** They are done as often as makes so many searches, once at least and ten times at most: caches
 * that others use as well keep what is asked for again and again, so that a second run still loads
 * them for a third. */
constexpr std::size_t WarmingSearches = 100000;
constexpr std::size_t MostWarmingRuns = 10;
/** After so long they are warm, too: few, but long searches. */
constexpr double MostSecondsOfWarming = 0.02;

/** Of at least one time. The middle half is from the quarter of the times that are below it,
 * rounded down, to as many above it: of five, the second to the fourth, of fewer all. */
Spread GetSpread(std::vector<double> times);

/** Does all runs in turns, again and again, so that a machine that changes its speed slows them all
 * alike. A run does `searches` searches, or one build, and returns the seconds that it took; what
 * comes back is for one of them: for each run, in the same order, the time of each repetition. */
std::vector<std::vector<double>> MeasureInTurns(
  const std::vector<std::function<double()>>& runs, std::size_t searches, int repetitions);

/** MeasureInTurns() with warm caches, and the spread of each run. */
std::vector<Spread> TimeInTurns(
  std::vector<std::function<double()>> runs, std::size_t searches, int repetitions);
}

#endif
