// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTables.h"

#include "ModelComparison.h"
#include "PaperMeasurement.h"
#include "PaperSummary.h"

#include <cmath>
#include <ostream>

namespace paper_benchmark
{
namespace
{
const std::vector<std::string> KindNames{ "Direct search", "Adjacent neighbours",
  "In-radius neighbours" };
const std::vector<std::string> WorkloadNames{ "all points", "all leaves", "a grid of 128^3" };

std::string FormatComparison(const ModelComparison& comparison)
{
  switch (comparison.Outcome)
  {
    case ModelOutcome::Wins:
      return "wins, x " + Format(comparison.BestOther);
    case ModelOutcome::Ties:
      return "ties, x " + Format(comparison.BestOther);
    case ModelOutcome::Loses:
      return "loses, x " + Format(comparison.BestOther);
    default:
      return "all alike";
  }
}

void WriteTable3BySet(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\nSet by set: whether the start depth of the row's own model is the fastest, beside those "
       "of the other models that differ from it, and the time of the best of these over its own. "
       "It wins or loses where the middle halves of the repetitions lie apart, else it ties.\n\n";
  std::vector<std::string> head{ "set", "start depths" };
  for (const std::string layout : { "its layout: ", "ours: " })
  {
    for (const std::string& name : WorkloadNames)
    {
      head.push_back(layout + name);
    }
  }
  WriteHead(out, head);
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name, "" };
    for (const FrequencyCosts& model : set.Frequencies)
    {
      row.back() += (row.back().empty() ? "" : ", ") + std::to_string(model.StartDepth);
    }
    for (const auto times : { &PaperResults::PaperWorkloads, &PaperResults::OurWorkloads })
    {
      for (std::size_t workload = 0; workload < NumberOfModels; ++workload)
      {
        row.push_back(FormatComparison(CompareModels(set, times, workload)));
      }
    }
    WriteRow(out, row);
  }
}

/** Gains over one peer, both ways (E15). */
void WriteGains(
  std::ostream& out, const std::vector<PaperResults>& sets, std::size_t kind, std::size_t base)
{
  std::vector<std::string> ratios{ "mean of ratios to " + GetPeerNames()[base] };
  std::vector<std::string> ratio{ "ratio of means to " + GetPeerNames()[base] };
  for (std::size_t peer = 0; peer < NumberOfPeers; ++peer)
  {
    const auto timeOf = [kind](std::size_t which)
    { return [kind, which](const PaperResults& set) { return set.Times[kind][which].Median; }; };
    const auto gain = [&](const PaperResults& set)
    { return timeOf(peer)(set) / timeOf(base)(set); };
    ratios.push_back("x " + Format(Summarise(sets, gain).Mean));
    ratio.push_back(
      "x " + Format(Summarise(sets, timeOf(peer)).Mean / Summarise(sets, timeOf(base)).Mean));
  }
  WriteRow(out, ratios);
  WriteRow(out, ratio);
}
}

void WriteTable1(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\n## Table 1: building and preprocessing\n\nMB are 2^20 bytes of the nodes (ours: "
       "blocks, keys and table), without the points' order. Builds include the sorting of the "
       "points, in ms. Optimisation is the choice of the start depth, in us: in the paper's layout "
       "by counting the leaves in the table, in ours from the counts that the build keeps.\n\n";
  WriteHead(out,
    { "set", "for the paper's", "nodes x1000", "(paper)", "deepest", "(paper)", "start depth",
      "(paper)", "MB 8 pointers", "MB br./child", "MB br./child, parents", "MB paper",
      "MB mixing hash", "MB ours", "ms 8 pointers", "ms br./child", "ms br./child, parents",
      "ms paper", "ms mixing hash", "ms ours", "us optimise paper", "us optimise ours",
      "points x1000", "leaves x1000" });
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name, set.Set.PaperName,
      Format(static_cast<double>(set.Nodes) / 1000.0), Format(set.Set.PaperThousandNodes),
      std::to_string(set.DeepestDepth), std::to_string(set.Set.PaperDeepestDepth),
      std::to_string(set.StartDepth), std::to_string(set.Set.PaperStartDepth) };
    for (const std::size_t bytes : set.Bytes)
    {
      row.push_back(Format(std::ldexp(static_cast<double>(bytes), -20)));
    }
    for (const Spread& build : set.Builds)
    {
      row.push_back(Format(1e3 * build.Median));
    }
    row.push_back(Format(1e6 * set.PaperOptimise.Median));
    row.push_back(Format(1e6 * set.OurOptimise.Median));
    row.push_back(Format(static_cast<double>(set.Points) / 1000.0));
    row.push_back(Format(static_cast<double>(set.Leaves) / 1000.0));
    WriteRow(out, row);
  }
}

void WriteTable2(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Table 2: searches, us each\n\nDirect: every point of the set, from its coordinates "
         "on, as in the paper. Neighbours: of "
      << NumberOfNeighborSearches
      << " leaves drawn from all, in random order. The radius, which the paper does not tell, is "
         "the side of the cells at the median depth. The start depth is the median of the leaves "
         "(f_leaves); \"ours, local\" has the medians of 4096 coarse cells. From the root the "
         "paper's layout searches top-down, with geometric tests for neighbours, as the trees with "
         "pointers do; with parents, neighbours are searched from the smallest ancestor that holds "
         "them all.\n";
  for (std::size_t kind = 0; kind < NumberOfKinds; ++kind)
  {
    out << "\n### " << KindNames[kind] << "\n\n";
    std::vector<std::string> head{ "set" };
    head.insert(head.end(), GetPeerNames().begin(), GetPeerNames().end());
    WriteHead(out, head);
    for (const PaperResults& set : sets)
    {
      std::vector<std::string> row{ set.Set.Name };
      for (const Spread& time : set.Times[kind])
      {
        row.push_back(Format(1e6 * time.Median, 3));
      }
      WriteRow(out, row);
    }
    std::vector<std::string> means{ "mean" };
    std::vector<std::string> spreads{ "spread, %" };
    for (std::size_t peer = 0; peer < NumberOfPeers; ++peer)
    {
      means.push_back(Format(1e6 *
          Summarise(sets, [=](const PaperResults& set) { return set.Times[kind][peer].Median; })
            .Mean,
        3));
      const auto spread = [=](const PaperResults& set)
      {
        const Spread& time = set.Times[kind][peer];
        return 100.0 * (time.Upper - time.Lower) / time.Median;
      };
      spreads.push_back(Format(Summarise(sets, spread).Highest, 0));
    }
    WriteRow(out, means);
    WriteRow(out, spreads);
    WriteGains(out, sets, kind, PaperStart);
    WriteGains(out, sets, kind, OursMedian);
  }
  out << "\nThe paper's gains of its own layout with the start depth, as it prints them (means of "
         "ratios): direct x 3.8, 15.7, 26.9 to 8 pointers, brother/child and its layout from the "
         "root; adjacent x 3.8, 3.6, 6.2; in-radius x 14.5, 13.8, 24.2. As ratios of the means, "
         "direct: x 2.9, 11.7, 20.8.\n";
}

void WriteTable3(std::ostream& out, const std::vector<PaperResults>& sets)
{
  constexpr double paper[3][3] = { { 1.30, 1.33, 2.45 }, { 0.95, 0.93, 1.52 },
    { 1.70, 1.66, 0.89 } };
  out << "\n## Table 3: direct searches by frequency model, us each\n\nMeans over the sets, from "
         "start depths that are medians by the three models. Leaves: at most "
      << MaxLeafSearches
      << " of a set, every k-th. Searches begin with keys, not with coordinates.\n\n";
  WriteHead(out,
    { "search", "paper's numbers: f_points", "f_leaves", "f_grid", "its layout here: f_points",
      "f_leaves", "f_grid", "ours: f_points", "f_leaves", "f_grid" });
  for (std::size_t row = 0; row < 3; ++row)
  {
    std::vector<std::string> cells{ WorkloadNames[row] };
    for (const double number : paper[row])
    {
      cells.push_back(Format(number));
    }
    for (const auto times : { &PaperResults::PaperWorkloads, &PaperResults::OurWorkloads })
    {
      for (std::size_t model = 0; model < 3; ++model)
      {
        cells.push_back(Format(1e6 *
            Summarise(
              sets, [=](const PaperResults& set) { return (set.*times)[row][model].Median; })
              .Mean,
          3));
      }
    }
    WriteRow(out, cells);
  }
  WriteTable3BySet(out, sets);
}
}
