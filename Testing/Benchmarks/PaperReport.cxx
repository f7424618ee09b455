// SPDX-License-Identifier: BSD-3-Clause
#include "PaperReport.h"

#include "PaperAnswers.h"
#include "PaperBatch.h"
#include "PaperClaims.h"
#include "PaperKeys.h"
#include "PaperMeasurement.h"
#include "PaperStartDepthTables.h"
#include "PaperTable1.h"
#include "PaperTable2.h"
#include "PaperTable3.h"
#include "PaperTiming.h"

#include <fstream>
#include <ostream>
#include <thread>

namespace paper_benchmark
{
namespace
{
std::string GetProcessor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

void WriteConditions(std::ostream& out, const std::vector<PaperResults>& sets, int repetitions)
{
  out << "# The paper's experiments\n\n- Machine: " << GetProcessor() << ", "
      << std::thread::hardware_concurrency()
      << " threads, of which one is used; the paper's: Pentium IV, 3 GHz\n- Compiler: "
      << HASHEDOCTREE_COMPILER << "\n- Times: medians of " << repetitions
      << " repetitions, structures in turns, each repeated for at least "
      << 1e3 * SecondsOfMeasurement << " ms; runs of at most " << MostWarmedSearches / 1000
      << " thousand searches are done 1 to " << MostWarmingRuns
      << " times before they are measured, until " << WarmingSearches / 1000
      << " thousand searches are done or " << 1e3 * MostSecondsOfWarming
      << " ms are over; after ~ their spread, which is the width of the middle half of the "
         "repetitions, of fewer than five all, in percent of the median\n- Trees: one point per "
         "leaf to depth 21, empty "
         "leaves are nodes; all structures have the same leaves\n- Point sets: made by "
         "Data/make_point_sets.py as stand-ins for the paper's, see Data/README.md; the points "
         "are in random order there\n";
  std::size_t checked = 0;
  std::size_t different = 0;
  for (const PaperResults& set : sets)
  {
    checked += set.CheckedAnswers;
    different += set.DifferentAnswers;
  }
  out
    << "- Answers: " << different << " of " << checked
    << " that were compared differ: in each structure the leaves of up to " << CheckedLeaves
    << " points and the neighbours of " << CheckedNeighborhoods
    << " leaves of each set, by both searches, and in the other tables the sums of what searches "
       "find\n\nAll structures have their "
       "memory in large pages. The trees with pointers come from a pool, siblings side by side; "
       "pointers have 8 bytes (the paper's 4). \"Paper\" is its own layout: every node in a table "
       "of 2^21 slots with chains, hashed by the 21 low bits of its key; \"mixing hash\" is the "
       "same with a multiplicative hash and a slot for each node.\n";
}
}

void WriteReport(const std::vector<PaperResults>& sets, int repetitions, std::ostream& markdown)
{
  WriteConditions(markdown, sets, repetitions);
  WriteTable1(markdown, sets);
  WriteTable2(markdown, sets);
  WriteBatch(markdown, sets);
  WriteTable3(markdown, sets);
  WriteFrequencies(markdown, sets);
  WriteModels(markdown, sets);
  WriteGainsByDeviation(markdown, sets);
  WriteNeighborStarts(markdown, sets);
  WriteRejectedOption(markdown, sets);
  WriteKeys(markdown, sets);
  WriteClaims(markdown, sets);
}
}
