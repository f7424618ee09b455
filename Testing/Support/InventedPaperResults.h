// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_InventedPaperResults_h
#define Testing_Support_InventedPaperResults_h

#include "PaperResults.h"

/** A time that varies by a tenth, either way. */
inline paper_benchmark::Spread InventTime(double seconds)
{
  return { seconds, 0.95 * seconds, 1.05 * seconds };
}

/** Results of a set, as nobody has measured them, with which all claims of the paper hold that are
 * about one set. Times of searches are microseconds. */
inline paper_benchmark::PaperResults InventPaperResults(const std::string& name)
{
  using namespace paper_benchmark;
  PaperResults set;
  set.Set.Name = name;
  set.Set.Paper = GetPaperSets().front().Paper;
  set.Points = 1000000;
  set.Nodes = 8000000;
  set.Leaves = 7000000;
  set.DeepestDepth = 12;
  set.StartDepth = 8;
  set.DepthDeviation = 1.0;
  set.Bytes = { 80U << 20, 40U << 20, 50U << 20, 20U << 20, 30U << 20, 10U << 20 };
  const double builds[]{ 4.0, 3.0, 3.5, 2.0, 2.5, 1.0 };
  std::transform(builds, builds + NumberOfStructures, set.Builds.begin(), InventTime);
  set.PaperOptimise = InventTime(0.01);
  set.OurOptimise = InventTime(0.001);
  const double times[]{ 4e-6, 32e-6, 16e-6, 8e-6, 2e-6, 3e-6, 6e-6, 1e-6, 5e-6 };
  for (auto& kind : set.Times)
  {
    std::transform(times, times + NumberOfPeers, kind.begin(), InventTime);
  }
  set.SingleSearches = InventTime(3e-6);
  set.BatchSearches = InventTime(2e-6);
  for (std::size_t model = 0; model < NumberOfModels; ++model)
  {
    FrequencyCosts& costs = set.Frequencies[model];
    costs = { static_cast<int>(6 + model), 10.0, 8.0, { 4.0, 4.0, 4.0 } };
    costs.Medians[model] = 2.0;
    for (std::size_t row = 0; row < NumberOfModels; ++row)
    {
      set.PaperWorkloads[row][model] = InventTime(row == model ? 2e-6 : 4e-6);
      set.OurWorkloads[row][model] = InventTime(row == model ? 1e-6 : 3e-6);
    }
  }
  set.Costs = { 10.0, 2.0, 2.5, 1.8, 1.6, 1.5 };
  set.Neighbors.Adjacent = { 40.0, 21.0, 20.0, 9, 18.0, 22.0 };
  set.Neighbors.InRadius = { 60.0, 32.0, 30.0, 9, 25.0, 33.0 };
  set.Neighbors.PaperAdjacent = { 45.0, 26.0, 25.0, 9, 23.0, 27.0 };
  set.Neighbors.PaperInRadius = { 70.0, 37.0, 35.0, 9, 33.0, 38.0 };
  set.Neighbors.PaperAdjacent.TopDown = 17.0;
  set.Neighbors.PaperInRadius.TopDown = 19.0;
  set.Neighbors.MedianTime = InventTime(4e-6);
  set.Neighbors.OwnTime = InventTime(3e-6);
  set.Neighbors.StoredBytes = 1U << 20;
  set.Neighbors.StoredSeconds = 0.5;
  set.Neighbors.Rejected = { 500.0, InventTime(50e-6) };
  set.Neighbors.Taken = { 20.0, InventTime(2e-6) };
  set.Keys.Dilation = InventTime(2e-9);
  set.Keys.Chains = { 3.0, { 0.5, 0.2, 0.2, 0.1, 0.0, 0.0 }, 2.2, 7 };
  set.Keys.LowBits = { 0.5, { 0.6, 0.1, 0.1, 0.1, 0.1, 0.0 }, 2.0, 9 };
  set.Keys.Mixing = { 0.5, { 0.9, 0.05, 0.05, 0.0, 0.0, 0.0 }, 1.1, 4 };
  set.CheckedAnswers = 100;
  return set;
}

#endif
