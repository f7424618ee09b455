// SPDX-License-Identifier: BSD-3-Clause
#include "PaperClaims.h"

#include "PaperSummary.h"

#include <ostream>

namespace paper_benchmark
{
namespace
{
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
}

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
