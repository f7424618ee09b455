// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTable2.h"

#include "PaperMeasurement.h"
#include "PaperSummary.h"

#include <ostream>

namespace paper_benchmark
{
namespace
{
using Sets = std::vector<PaperResults>;

const std::vector<std::string> KindNames{ "Direct search", "Adjacent neighbours",
  "In-radius neighbours" };

/** The column of the paper's Table 2 that a peer has there, or NumberOfColumns. */
std::size_t GetColumnOfPeer(std::size_t peer)
{
  return peer == Pointers  ? PointersColumn
    : peer == BrotherChild ? BrotherChildColumn
    : peer == PaperRoot    ? HashedColumn
    : peer == PaperStart   ? StartDepthColumn
                           : NumberOfColumns;
}

/** Microseconds of each set: ours, and the paper's. */
std::vector<double> GetTimes(const Sets& sets, std::size_t kind, std::size_t peer)
{
  return GetOfEach(
    sets, [=](const PaperResults& set) { return 1e6 * set.Times[kind][peer].Median; });
}
std::vector<double> GetPaperTimes(const Sets& sets, std::size_t kind, std::size_t column)
{
  return GetOfEach(
    sets, [=](const PaperResults& set) { return set.Set.Paper.Microseconds[kind][column]; });
}

/** Gains over one peer, both ways (E15), beside what follows from the paper's times. */
void WriteGains(std::ostream& out, const Sets& sets, std::size_t kind, std::size_t base)
{
  std::vector<std::string> ratios{ "mean of ratios to " + GetPeerNames()[base] };
  std::vector<std::string> ratio{ "ratio of means to " + GetPeerNames()[base] };
  const bool inPaper = GetColumnOfPeer(base) != NumberOfColumns;
  for (std::size_t peer = 0; peer < NumberOfPeers; ++peer)
  {
    const Gain gain = GetGain(GetTimes(sets, kind, peer), GetTimes(sets, kind, base));
    ratios.push_back("x " + Format(gain.MeanOfRatios));
    ratio.push_back("x " + Format(gain.RatioOfMeans));
    if (inPaper && GetColumnOfPeer(peer) != NumberOfColumns)
    {
      const Gain paper = GetGain(GetPaperTimes(sets, kind, GetColumnOfPeer(peer)),
        GetPaperTimes(sets, kind, GetColumnOfPeer(base)));
      ratios.back() = FormatBeside(ratios.back(), Format(paper.MeanOfRatios));
      ratio.back() = FormatBeside(ratio.back(), Format(paper.RatioOfMeans));
    }
  }
  WriteRow(out, ratios);
  WriteRow(out, ratio);
}

void WriteTimes(std::ostream& out, const Sets& sets, std::size_t kind)
{
  std::vector<std::string> head{ "set" };
  head.insert(head.end(), GetPeerNames().begin(), GetPeerNames().end());
  WriteHead(out, head);
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name };
    for (std::size_t peer = 0; peer < NumberOfPeers; ++peer)
    {
      const std::string ours = FormatTime(set.Times[kind][peer], 1e6);
      const std::size_t column = GetColumnOfPeer(peer);
      row.push_back(column == NumberOfColumns
          ? ours
          : FormatBeside(ours, Format(set.Set.Paper.Microseconds[kind][column], 2)));
    }
    WriteRow(out, row);
  }
  std::vector<std::string> means{ "mean" };
  std::vector<std::string> spreads{ "largest spread" };
  for (std::size_t peer = 0; peer < NumberOfPeers; ++peer)
  {
    const std::string ours = FormatSmall(GetMean(GetTimes(sets, kind, peer)));
    const std::size_t column = GetColumnOfPeer(peer);
    means.push_back(column == NumberOfColumns
        ? ours
        : FormatBeside(ours, Format(GetMean(GetPaperTimes(sets, kind, column)), 2)));
    const auto width = [=](const PaperResults& set) { return GetWidth(set.Times[kind][peer]); };
    spreads.push_back("~" + FormatPercent(Summarise(sets, width).Highest));
  }
  WriteRow(out, means);
  WriteRow(out, spreads);
}

/** What the paper prints below its Table 2, and what follows from the rows above it. */
void WritePaperGains(std::ostream& out)
{
  out << "\n### The paper's gains\n\nHow many times as long as the paper's layout from its start "
         "depth the others take in the paper, over its 17 sets: as it prints them, and what "
         "follows from its own times. What it prints are means of ratios; the ratio of the means "
         "is less (E15). Its \"15 times\" is beside brother/child alone.\n\n";
  WriteHead(
    out, { "search", "", "8 pointers", "brother/child", "hashed, root", "hashed, start depth" });
  const auto getTimes = [](std::size_t kind, std::size_t column)
  {
    std::vector<double> times;
    for (const PaperSet& set : GetPaperSets())
    {
      times.push_back(set.Paper.Microseconds[kind][column]);
    }
    return times;
  };
  for (std::size_t kind = 0; kind < NumberOfKinds; ++kind)
  {
    std::vector<std::string> printed{ KindNames[kind], "printed" };
    std::vector<std::string> ratios{ "", "mean of ratios" };
    std::vector<std::string> ratio{ "", "ratio of means" };
    for (std::size_t column = 0; column < NumberOfColumns; ++column)
    {
      const Gain gain = GetGain(getTimes(kind, column), getTimes(kind, StartDepthColumn));
      printed.push_back("x " + FormatPrinted(GetPaperAverages().Gains[kind][column]));
      ratios.push_back("x " + Format(gain.MeanOfRatios));
      ratio.push_back("x " + Format(gain.RatioOfMeans));
    }
    WriteRow(out, printed);
    WriteRow(out, ratios);
    WriteRow(out, ratio);
  }
}
}

void WriteTable2(std::ostream& out, const Sets& sets)
{
  out
    << "\n## Table 2: searches, us each\n\nFor the points of the set, as in the paper. Direct: all "
       "of them, from their coordinates on. Neighbours: those of the leaves of "
    << NumberOfNeighborSearches
    << " points drawn from all, in random order. The radius, which the paper does not tell, is "
       "the side of the cells at the median depth. The start depth is the median of the leaves "
       "(f_leaves). Which it is in the paper cannot be told (E19): its mean of direct searches, "
       "1.33, is that of its Table 3 for points searched for by f_leaves, beside 1.30 by "
       "f_points; but Maracanã's, of its Table 1, can only be that of f_points. \"ours, local\" "
       "has the medians of 4096 coarse cells. From the root the paper's layout searches top-down, "
       "with geometric tests for neighbours, as the trees with pointers do; with parents, "
       "neighbours are searched from the smallest ancestor that holds them all. In parentheses the "
       "paper's times for the set that it has here, and the means "
       "and gains that follow from them for the same sets.\n";
  for (std::size_t kind = 0; kind < NumberOfKinds; ++kind)
  {
    out << "\n### " << KindNames[kind] << "\n\n";
    WriteTimes(out, sets, kind);
    WriteGains(out, sets, kind, PaperStart);
    WriteGains(out, sets, kind, OursMedian);
  }
  WritePaperGains(out);
}
}
