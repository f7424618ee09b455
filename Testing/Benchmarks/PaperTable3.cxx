// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTable3.h"

#include "ModelComparison.h"
#include "PaperMeasurement.h"
#include "PaperSummary.h"

#include <ostream>

namespace paper_benchmark
{
namespace
{
constexpr std::size_t GridSide = std::size_t(1) << GridDepth;
const std::vector<std::string> WorkloadNames{ "all points", "all leaves",
  "a grid of " + std::to_string(GridSide) + "^3" };

std::string FormatComparison(const ModelComparison& comparison)
{
  if (comparison.Outcome == ModelOutcome::Alike)
  {
    return "all alike";
  }
  return (comparison.Outcome == ModelOutcome::Wins      ? "wins, x "
             : comparison.Outcome == ModelOutcome::Ties ? "ties, x "
                                                        : "loses, x ") +
    Format(comparison.BestOther) + " ~" + FormatPercent(comparison.Width);
}

void WriteTable3BySet(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\nSet by set: whether the start depth of the row's own model is the fastest, beside those "
       "of the other models that differ from it, the time of the best of these over its own, and "
       "after ~ the largest spread of the times compared. It wins or loses where the middle halves "
       "of the repetitions lie apart, else it ties.\n\n";
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

}

void WriteTable3(std::ostream& out, const std::vector<PaperResults>& sets)
{
  constexpr double paper[3][3] = { { 1.30, 1.33, 2.45 }, { 0.95, 0.93, 1.52 },
    { 1.70, 1.66, 0.89 } };
  out << "\n## Table 3: direct searches by frequency model, us each\n\nMeans over the sets, from "
         "start depths that are medians by the three models. Leaves: at most "
      << MaxLeafSearches << " of a set, every k-th. The grid has " << GridSide << "^3 cells, "
      << GridSide * GridSide * GridSide / 1000
      << " thousand searches; the paper's has 2097 thousand in its Table 1, and its text calls it "
         "127^3 (E12). The paper's 1.33 is also the mean of its Table 2 (E19). Searches begin with "
         "keys, not with coordinates. After ~ the largest spread of a set.\n\n";
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
        const auto getTime = [=](const PaperResults& set) -> const Spread&
        { return (set.*times)[row][model]; };
        const auto mean =
          Summarise(sets, [=](const auto& set) { return getTime(set).Median; }).Mean;
        const auto width = Summarise(sets, [=](const auto& set) { return GetWidth(getTime(set)); });
        cells.push_back(FormatSmall(1e6 * mean) + " ~" + FormatPercent(width.Highest));
      }
    }
    WriteRow(out, cells);
  }
  WriteTable3BySet(out, sets);
}
}
