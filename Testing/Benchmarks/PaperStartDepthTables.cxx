// SPDX-License-Identifier: BSD-3-Clause
#include "PaperStartDepthTables.h"

#include "PaperNeighborStarts.h"
#include "PaperSummary.h"

#include <cmath>
#include <ostream>

namespace paper_benchmark
{
void WriteModels(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Start-depth models\n\nMean number of nodes that a direct search examines when every "
         "leaf is searched for once: from the root, from the median of the leaves' depths, from "
         "their mean, and local, from the medians of 4096 coarse cells. \"depth +-\" is the "
         "standard deviation of the depths. The decision tree goes from depth to depth by "
         "decisions instead of child by child; no search through single depths can go below the "
         "entropy bound.\n\n";
  WriteHead(out,
    { "set", "depth +-", "root", "median", "mean", "local", "decision tree", "entropy bound" });
  for (const PaperResults& set : sets)
  {
    WriteRow(out,
      { set.Set.Name, Format(set.DepthDeviation), Format(set.Costs.Root), Format(set.Costs.Median),
        Format(set.Costs.Mean), Format(set.Costs.Local), Format(set.Costs.Decisions),
        Format(set.Costs.Bound) });
  }
}

void WriteFrequencies(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Frequency models in nodes\n\nMean number of nodes that a direct search examines, "
         "counted in searches for every leaf, which are weighted by the frequency model: from the "
         "root, from the median of each model, and from the deepest depth (modelled).\n\n";
  WriteHead(out,
    { "set", "searched for", "root", "start depth f_points", "start depth f_leaves",
      "start depth f_grid", "deepest depth" });
  const std::array<std::string, NumberOfModels> names{ "points", "leaves", "grid" };
  for (const PaperResults& set : sets)
  {
    for (std::size_t model = 0; model < NumberOfModels; ++model)
    {
      const FrequencyCosts& costs = set.Frequencies[model];
      std::vector<std::string> row{ set.Set.Name, names[model], Format(costs.Root) };
      for (std::size_t i = 0; i < NumberOfModels; ++i)
      {
        row.push_back(Format(costs.Medians[i]) + " (from " +
          std::to_string(set.Frequencies[i].StartDepth) + ")");
      }
      row.push_back(Format(costs.Deepest));
      WriteRow(out, row);
    }
  }
}

namespace
{
void AppendCosts(std::vector<std::string>& row, const NeighborCosts& costs)
{
  row.push_back(Format(costs.Root));
  row.push_back(Format(costs.Median));
  row.push_back(Format(costs.Climbing));
  row.push_back(Format(costs.Best) + " (" + std::to_string(costs.BestDepth) + ")");
  row.push_back(Format(costs.Own));
}

/** The looks that the paper's own searches take in its table. */
void WriteNeighborStartsOfPaper(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\n### The same in the paper's layout\n\nIts own searches (Algorithm 2; in-radius as in "
       "section 3c), looks in its table, for the same leaves. The root is start depth 0; top-down "
       "is the classical search instead (section 2), which looks at the children that meet what "
       "is searched, and is what Table 2 has from the root.\n\n";
  WriteHead(out,
    { "set", "start depth", "adjacent: top-down", "root", "median", "climbing",
      "best depth for all", "best for each", "in-radius: top-down", "root", "median", "climbing",
      "best depth for all", "best for each" });
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name, std::to_string(set.StartDepth) };
    for (const NeighborCosts* costs :
      { &set.Neighbors.PaperAdjacent, &set.Neighbors.PaperInRadius })
    {
      row.push_back(Format(costs->TopDown));
      AppendCosts(row, *costs);
    }
    WriteRow(out, row);
  }
}
}

void WriteNeighborStarts(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\n## Start depths of neighbour searches\n\nMean number of nodes that a search for the "
       "neighbours of a leaf examines in our layout, counted for "
    << MaxScannedLeaves
    << " leaves, those of points drawn from all: from the root; from the median of all leaves, "
       "which is best for direct searches and which the paper takes for these as well; from the "
       "one depth that is best for all these leaves, found by trying all; and from the depth that "
       "is best for each leaf, which for adjacent searches NodeStartDepths keeps, in one byte for "
       "each node; these are made, and timed, once. Climbing is from parent to parent alone, from "
       "below all leaves, which the paper expects to take more than from the median. The radius is "
       "that of Table 2. The times are of adjacent searches for the same leaves, that of the depth "
       "kept for each with looking it up; fewer leaves than in Table 2, so that more of the tree "
       "is in the caches: they compare with each other only.\n\n";
  WriteHead(out,
    { "set", "start depth", "adjacent: root", "median", "climbing", "best depth for all",
      "best for each", "in-radius: root", "median", "climbing", "best depth for all",
      "best for each", "MB kept", "MB tree", "ms to make", "adjacent, us: median",
      "best for each" });
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name, std::to_string(set.StartDepth) };
    AppendCosts(row, set.Neighbors.Adjacent);
    AppendCosts(row, set.Neighbors.InRadius);
    row.push_back(Format(std::ldexp(static_cast<double>(set.Neighbors.StoredBytes), -20)));
    row.push_back(Format(std::ldexp(static_cast<double>(set.Bytes[OursBuilt]), -20)));
    row.push_back(Format(1e3 * set.Neighbors.StoredSeconds));
    row.push_back(FormatTime(set.Neighbors.MedianTime, 1e6));
    row.push_back(FormatTime(set.Neighbors.OwnTime, 1e6));
    WriteRow(out, row);
  }
  WriteNeighborStartsOfPaper(out, sets);
}

void WriteRejectedOption(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## The option of the adjacent search that the paper rejects\n\nFrom the cells of the "
         "start depth around the leaf along the hierarchy (section 3b), beside the option that "
         "it takes, both from the median, in our layout: mean of "
      << MaxRejectedLeaves
      << " leaves, those of points drawn from all, so few that the caches hold what is searched: "
         "times compare within this table only.\n\n";
  WriteHead(
    out, { "set", "rejected: nodes", "us", "taken: nodes", "us", "nodes, rejected over taken" });
  for (const PaperResults& set : sets)
  {
    const AdjacentOption& rejected = set.Neighbors.Rejected;
    const AdjacentOption& taken = set.Neighbors.Taken;
    WriteRow(out,
      { set.Set.Name, Format(rejected.Nodes), FormatTime(rejected.Time, 1e6), Format(taken.Nodes),
        FormatTime(taken.Time, 1e6), Format(rejected.Nodes / taken.Nodes) });
  }
}

void WriteGainsByDeviation(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Gain by deviation of depth\n\nThe sets from the least to the greatest standard "
         "deviation of the depths of their leaves. The gain is what a direct search costs from the "
         "root over what it costs from the median: in nodes (every leaf once), and in time (every "
         "point once).\n\n";
  WriteHead(out,
    { "set", "depth +-", "mean depth", "gain in nodes", "in time, paper's layout",
      "in time, ours" });
  std::vector<PaperResults> ranked = sets;
  std::sort(ranked.begin(), ranked.end(),
    [](const auto& a, const auto& b) { return a.DepthDeviation < b.DepthDeviation; });
  for (const PaperResults& set : ranked)
  {
    WriteRow(out,
      { set.Set.Name, Format(set.DepthDeviation), Format(set.Costs.Root - 1.0),
        Format(GetGainInNodes(set)), Format(GetGainInTime(set, PaperRoot, PaperStart)),
        Format(GetGainInTime(set, OursRoot, OursMedian)) });
  }
}
}
