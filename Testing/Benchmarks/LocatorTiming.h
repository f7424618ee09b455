// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorTiming_h
#define Testing_Benchmarks_LocatorTiming_h

#include "LocatorCase.h"
#include "LocatorPeers.h"

#include <map>

namespace locator_benchmark
{
/** How long something took, and how often it was done. */
struct Timing
{
  double Seconds = 0.0;
  std::size_t Count = 0;
};

/** A way to search, at some positions. */
struct Question
{
  Operation What;
  double Radius;
  const std::vector<Position>* Positions;
};

/** Lets vtkSMPTools, with which builds and queries are shared out, use this many threads. */
void UseThreads(int threads);

/** How many times as fast as one thread some are at arithmetic that needs no memory, at this
 * moment. On a virtual machine it may be less than their number, whatever they do. */
double MeasureGainOfThreads(int threads);

/** Ids that were found, at a position. */
using Answers = std::map<std::size_t, std::vector<vtkIdType>>;

/** Answers to the question at the first positions, with the threads that are in use; at fewer
 * positions when it takes longer than `seconds`. */
Answers GetAnswers(
  LocatorPeer& peer, const Question& question, std::size_t numberOfPositions, double seconds);

/** Asks at all positions again and again, for about `seconds`. A slow peer does not get through
 * them once: they are in random order, so that the first ones stand for all. */
Timing TimeQueries(LocatorPeer& peer, const Question& question, double seconds);

/** Builds at least once, and again until about `seconds` are over. One build before does not count:
 * the first after some seconds without any often takes milliseconds longer, whoever's it is. */
Timing TimeBuilds(const PeerKind& kind, const LocatorData& data, double seconds);
}

#endif
