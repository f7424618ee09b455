// SPDX-License-Identifier: BSD-3-Clause
#include "PaperReport.h"

#include "PaperMeasurement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <ostream>
#include <thread>

namespace paper_benchmark
{
namespace
{
const std::vector<std::string> KindNames{ "Direct search", "Adjacent neighbours",
  "In-radius neighbours" };
const std::vector<std::string> ModelNames{ "f_points", "f_leaves", "f_grid" };
const std::vector<std::string> WorkloadNames{ "all points", "all leaves", "a grid of 128^3" };

std::string Format(double number, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, number);
  return text;
}

/** Three digits or more. */
std::string Format(double number)
{
  return Format(number, number < 9.995 ? 2 : number < 99.95 ? 1 : 0);
}

std::string FormatRange(double lowest, double highest)
{
  return Format(lowest) + " to " + Format(highest);
}

void WriteRow(std::ostream& out, const std::vector<std::string>& cells)
{
  out << "|";
  for (const std::string& cell : cells)
  {
    out << " " << cell << " |";
  }
  out << "\n";
}

void WriteHead(std::ostream& out, const std::vector<std::string>& cells)
{
  WriteRow(out, cells);
  WriteRow(out, std::vector<std::string>(cells.size(), "---"));
}

/** function(set) for each set: smallest, mean and largest. */
struct Summary
{
  double Lowest;
  double Mean;
  double Highest;
};
template <typename Function>
Summary Summarise(const std::vector<PaperResults>& sets, const Function& function)
{
  std::vector<double> values;
  values.reserve(sets.size());
  for (const PaperResults& set : sets)
  {
    values.push_back(function(set));
  }
  return { *std::min_element(values.begin(), values.end()),
    std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
    *std::max_element(values.begin(), values.end()) };
}

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
      << " repetitions, structures in turns; the spread is the width of the middle half over the "
         "median, the largest of all sets\n- Trees: one point per leaf to depth 21, empty leaves "
         "are nodes; all "
         "structures have the same leaves\n- Point sets: made by Data/make_point_sets.py as "
         "stand-ins for the paper's, see Data/README.md; the points are in random order there\n";
  std::size_t checked = 0;
  std::size_t different = 0;
  for (const PaperResults& set : sets)
  {
    checked += set.CheckedAnswers;
    different += set.DifferentAnswers;
  }
  out
    << "- Answers: " << different << " of " << checked
    << " that were compared with ours differ\n\nThe trees with pointers come from a pool, "
       "siblings side by side; pointers have 8 bytes (the paper's 4). \"Paper\" is its own "
       "layout: every node in a table of 2^21 slots with chains, hashed by the 21 low bits of its "
       "key; \"mixing hash\" is the same with a multiplicative hash and a slot for each node.\n";
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
}

void WriteModels(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Start-depth models\n\nMean number of nodes that a direct search examines when every "
         "leaf is searched for once. The decision tree goes from depth to depth by decisions "
         "instead of child by child; no search through single depths can go below the entropy "
         "bound.\n\n";
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

std::string FormatSummary(const Summary& summary)
{
  return FormatRange(summary.Lowest, summary.Highest) + ", mean " + Format(summary.Mean);
}

/** Rows of Table 3 in which the column of the same model is the fastest. */
int CountWonRows(const std::vector<PaperResults>& sets, WorkloadTimes PaperResults::*times)
{
  int won = 0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    std::array<double, 3> means{};
    for (std::size_t model = 0; model < 3; ++model)
    {
      means[model] = Summarise(sets,
        [=](const PaperResults& set) {
          return (set.*times)[row][model].Median;
        }).Mean;
    }
    won += means[row] == *std::min_element(means.begin(), means.end()) ? 1 : 0;
  }
  return won;
}

/** The claims of the paper's text (#56). */
void WriteClaims(std::ostream& out, const std::vector<PaperResults>& sets)
{
  const auto timeRatio = [](std::size_t a, std::size_t b)
  {
    return [=](const PaperResults& set)
    { return set.Times[Direct][a].Median / set.Times[Direct][b].Median; };
  };
  const auto buildRatio = [](std::size_t a, std::size_t b)
  { return [=](const PaperResults& set) { return set.Builds[a].Median / set.Builds[b].Median; }; };
  const auto bytesRatio = [](std::size_t a, std::size_t b)
  {
    return [=](const PaperResults& set)
    { return static_cast<double>(set.Bytes[a]) / static_cast<double>(set.Bytes[b]); };
  };
  const auto countSets = [&sets](const auto& isSo)
  {
    return std::to_string(std::count_if(sets.begin(), sets.end(), isSo)) + " of " +
      std::to_string(sets.size()) + " sets";
  };
  const PaperResults& steady = *std::min_element(sets.begin(), sets.end(),
    [](const auto& a, const auto& b) { return a.DepthDeviation < b.DepthDeviation; });
  const PaperResults& spread = *std::max_element(sets.begin(), sets.end(),
    [](const auto& a, const auto& b) { return a.DepthDeviation < b.DepthDeviation; });
  const auto gain = [](const PaperResults& set)
  {
    return set.Set.Name + " (depth +- " + Format(set.DepthDeviation) + "): x " +
      Format(set.Costs.Root / set.Costs.Median) + " fewer nodes";
  };
  out << "\n## The paper's claims\n\n";
  WriteHead(out, { "claim", "in the paper's layout", "in ours" });
  WriteRow(out,
    { "no more nodes than from the root (leaves)",
      countSets([](const auto& set) { return set.Costs.Median <= set.Costs.Root; }), "the same" });
  WriteRow(out,
    { "direct searches not slower than from the root",
      countSets([&](const auto& set) { return timeRatio(PaperStart, PaperRoot)(set) <= 1.0; }),
      countSets([&](const auto& set) { return timeRatio(OursMedian, OursRoot)(set) <= 1.0; }) });
  WriteRow(out,
    { "direct: time of 8 pointers over time",
      FormatSummary(Summarise(sets, timeRatio(Pointers, PaperStart))),
      FormatSummary(Summarise(sets, timeRatio(Pointers, OursMedian))) });
  WriteRow(out,
    { "build no slower: time over that of 8 pointers",
      FormatSummary(Summarise(sets, buildRatio(PaperBuilt, PointersBuilt))),
      FormatSummary(Summarise(sets, buildRatio(OursBuilt, PointersBuilt))) });
  WriteRow(out,
    { "memory as brother/child on big sets: bytes over its",
      FormatSummary(Summarise(sets, bytesRatio(PaperBuilt, BrotherChildBuilt))) +
        "; largest set: " + Format(bytesRatio(PaperBuilt, BrotherChildBuilt)(sets.back())),
      FormatSummary(Summarise(sets, bytesRatio(OursBuilt, BrotherChildBuilt))) +
        "; largest set: " + Format(bytesRatio(OursBuilt, BrotherChildBuilt)(sets.back())) });
  WriteRow(out,
    { "preprocessing below 1 % of the build: %",
      FormatSummary(Summarise(sets,
        [](const PaperResults& set)
        { return 100.0 * set.PaperOptimise.Median / set.Builds[PaperBuilt].Median; })),
      FormatSummary(Summarise(sets,
        [](const PaperResults& set)
        { return 100.0 * set.OurOptimise.Median / set.Builds[OursBuilt].Median; })) });
  WriteRow(
    out, { "little gain where depths vary much", gain(steady) + "; " + gain(spread), "the same" });
  WriteRow(out,
    { "the right model wins (Table 3, rows won by their own column)",
      std::to_string(CountWonRows(sets, &PaperResults::PaperWorkloads)) + " of 3",
      std::to_string(CountWonRows(sets, &PaperResults::OurWorkloads)) + " of 3" });
}
}

void WriteReport(const std::vector<PaperResults>& sets, int repetitions, std::ostream& markdown)
{
  WriteConditions(markdown, sets, repetitions);
  WriteTable1(markdown, sets);
  WriteTable2(markdown, sets);
  WriteTable3(markdown, sets);
  WriteModels(markdown, sets);
  WriteClaims(markdown, sets);
}
}
