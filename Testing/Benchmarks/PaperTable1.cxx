// SPDX-License-Identifier: BSD-3-Clause
#include "PaperTable1.h"

#include "PaperSummary.h"

#include <cmath>
#include <functional>
#include <ostream>

namespace paper_benchmark
{
namespace
{
using Sets = std::vector<PaperResults>;
using Number = std::function<double(const PaperResults&)>;

const std::vector<std::string> StructureNames{ "8 pointers", "br./child", "br./child, parents",
  "paper's layout", "mixing hash", "ours" };

/** The column of the paper's Table 1 that a structure has there, or StartDepthColumn. */
std::size_t GetColumnOfStructure(std::size_t structure)
{
  return structure == PointersBuilt  ? PointersColumn
    : structure == BrotherChildBuilt ? BrotherChildColumn
    : structure == PaperBuilt        ? HashedColumn
                                     : StartDepthColumn;
}

/** Means over the sets, weighted by their nodes as the paper's are: of our trees, and of the
 * paper's. */
double GetMeanByOurNodes(const Sets& sets, const Number& number)
{
  return GetWeightedMean(GetOfEach(sets, number),
    GetOfEach(sets, [](const PaperResults& set) { return static_cast<double>(set.Nodes); }));
}
double GetMeanByPaperNodes(const Sets& sets, const Number& number)
{
  return GetWeightedMean(GetOfEach(sets, number),
    GetOfEach(sets, [](const PaperResults& set) { return set.Set.Paper.ThousandNodes; }));
}

/** One column for each structure, with the paper's number beside it where it has one. */
std::vector<std::string> NameStructures(const std::string& first)
{
  std::vector<std::string> head{ first };
  for (std::size_t structure = 0; structure < NumberOfStructures; ++structure)
  {
    head.push_back(StructureNames[structure] +
      (GetColumnOfStructure(structure) == StartDepthColumn ? "" : " (the paper's)"));
  }
  return head;
}

void WriteTrees(std::ostream& out, const Sets& sets)
{
  out
    << "\n### Trees\n\nIn parentheses the paper's numbers, here and in the other tables; where "
       "they are means, over the same sets. Start depths are the medians of f_leaves, here and in "
       "all that follows, and of f_points; the paper's column cannot be f_leaves alone (E19).\n\n";
  WriteHead(out,
    { "set", "stands for the paper's", "points x1000", "nodes x1000", "leaves x1000",
      "deepest depth", "start depth", "f_points" });
  const auto thousands = [](std::size_t ours, double paper)
  { return FormatBeside(Format(static_cast<double>(ours) / 1000.0), FormatPrinted(paper)); };
  for (const PaperResults& set : sets)
  {
    const PaperNumbers& paper = set.Set.Paper;
    WriteRow(out,
      { set.Set.Name, paper.Name, thousands(set.Points, paper.ThousandPoints),
        thousands(set.Nodes, paper.ThousandNodes), thousands(set.Leaves, paper.ThousandLeaves),
        FormatBeside(std::to_string(set.DeepestDepth), std::to_string(paper.DeepestDepth)),
        FormatBeside(std::to_string(set.StartDepth), std::to_string(paper.StartDepth)),
        std::to_string(set.Frequencies[0].StartDepth) });
  }
}

void WriteMemory(std::ostream& out, const Sets& sets)
{
  out << "\n### Memory, MB\n\nMB are 2^20 bytes of the nodes (ours: blocks, keys and table), "
         "without the points' order. The paper's table of fixed size is "
         "nearly all that its small trees take (E17).\n\n";
  WriteHead(out, NameStructures("set"));
  const auto writeRow = [&out](const std::string& name, const auto& getOurs, const auto& getPapers)
  {
    std::vector<std::string> row{ name };
    for (std::size_t structure = 0; structure < NumberOfStructures; ++structure)
    {
      const std::string ours = Format(getOurs(structure));
      const std::size_t column = GetColumnOfStructure(structure);
      row.push_back(column == StartDepthColumn ? ours : FormatBeside(ours, getPapers(column)));
    }
    WriteRow(out, row);
  };
  const auto getMegabytes = [](const PaperResults& set, std::size_t structure)
  { return std::ldexp(static_cast<double>(set.Bytes[structure]), -20); };
  for (const PaperResults& set : sets)
  {
    writeRow(
      set.Set.Name, [&](std::size_t structure) { return getMegabytes(set, structure); },
      [&](std::size_t column) { return FormatPrinted(set.Set.Paper.Megabytes[column]); });
  }
  writeRow(
    "mean by nodes",
    [&](std::size_t structure)
    {
      return GetMeanByOurNodes(
        sets, [=](const PaperResults& set) { return getMegabytes(set, structure); });
    },
    [&](std::size_t column)
    {
      return Format(GetMeanByPaperNodes(
        sets, [=](const PaperResults& set) { return set.Set.Paper.Megabytes[column]; }));
    });
}

void WriteBuilds(std::ostream& out, const Sets& sets)
{
  out << "\n### Builds, ms\n\nThe sorting of the points included. The last two columns are times "
         "over that of 8 pointers: what the paper calls slightly faster (E18).\n\n";
  std::vector<std::string> head = NameStructures("set");
  head.insert(head.end(), { "paper's layout / 8 pointers", "ours / 8 pointers" });
  WriteHead(out, head);
  for (const PaperResults& set : sets)
  {
    const PaperTable1Columns& paper = set.Set.Paper.BuildMilliseconds;
    std::vector<std::string> row{ set.Set.Name };
    for (std::size_t structure = 0; structure < NumberOfStructures; ++structure)
    {
      const std::string ours = FormatTime(set.Builds[structure], 1e3);
      const std::size_t column = GetColumnOfStructure(structure);
      row.push_back(
        column == StartDepthColumn ? ours : FormatBeside(ours, FormatPrinted(paper[column])));
    }
    const double pointers = set.Builds[PointersBuilt].Median;
    row.push_back(FormatBeside(Format(set.Builds[PaperBuilt].Median / pointers),
      Format(paper[HashedColumn] / paper[PointersColumn])));
    row.push_back(Format(set.Builds[OursBuilt].Median / pointers));
    WriteRow(out, row);
  }
  std::vector<std::string> means{ "mean by nodes" };
  for (std::size_t structure = 0; structure < NumberOfStructures; ++structure)
  {
    const std::string ours = Format(GetMeanByOurNodes(
      sets, [=](const PaperResults& set) { return 1e3 * set.Builds[structure].Median; }));
    const std::size_t column = GetColumnOfStructure(structure);
    means.push_back(column == StartDepthColumn
        ? ours
        : FormatBeside(ours,
            Format(GetMeanByPaperNodes(sets,
              [=](const PaperResults& set) { return set.Set.Paper.BuildMilliseconds[column]; }))));
  }
  means.insert(means.end(), { "", "" });
  WriteRow(out, means);
}

double GetPaperPercent(const PaperNumbers& paper)
{
  return 100.0 * paper.OptimiseMilliseconds / paper.BuildMilliseconds[HashedColumn];
}

void WriteOptimisation(std::ostream& out, const Sets& sets)
{
  out << "\n### Choosing the start depth, us\n\nIn the paper's layout by counting the leaves in "
         "the table, in ours from the counts that the build keeps, each timed by itself. The paper "
         "calls it less than one percent of the build, which none of its rows has (E16).\n\n";
  WriteHead(out,
    { "set", "paper's layout (the paper's)", "% of its build (the paper's)", "ours",
      "% of its build" });
  const auto getPercent = [](const Spread& optimise, const Spread& build)
  { return FormatSmall(100.0 * optimise.Median / build.Median); };
  for (const PaperResults& set : sets)
  {
    const PaperNumbers& paper = set.Set.Paper;
    WriteRow(out,
      { set.Set.Name,
        FormatBeside(
          FormatTime(set.PaperOptimise, 1e6), FormatPrinted(1e3 * paper.OptimiseMilliseconds)),
        FormatBeside(
          getPercent(set.PaperOptimise, set.Builds[PaperBuilt]), Format(GetPaperPercent(paper), 1)),
        FormatTime(set.OurOptimise, 1e6), getPercent(set.OurOptimise, set.Builds[OursBuilt]) });
  }
}

/** What the paper prints below its Table 1, and what follows from the rows above it. */
void WritePaperAverages(std::ostream& out)
{
  out << "\n### The paper's averages\n\nWhat the paper prints as the averages of its 17 sets, "
         "weighted by nodes, and what follows from its own rows. Choosing the start depth is out "
         "of line (E16).\n\n";
  WriteHead(out,
    { "", "MB 8 pointers", "MB br./child", "MB hashed", "ms 8 pointers", "ms br./child",
      "ms hashed", "ms choosing the start depth", "% of the hashed build" });
  const auto getMean = [](const auto& number)
  {
    std::vector<double> values;
    std::vector<double> nodes;
    for (const PaperSet& set : GetPaperSets())
    {
      values.push_back(number(set.Paper));
      nodes.push_back(set.Paper.ThousandNodes);
    }
    return GetWeightedMean(values, nodes);
  };
  const PaperAverages& averages = GetPaperAverages();
  std::vector<std::string> printed{ "printed" };
  std::vector<std::string> follows{ "from its rows" };
  for (const auto columns : { &PaperNumbers::Megabytes, &PaperNumbers::BuildMilliseconds })
  {
    const auto& average =
      columns == &PaperNumbers::Megabytes ? averages.Megabytes : averages.BuildMilliseconds;
    for (std::size_t column = 0; column < average.size(); ++column)
    {
      printed.push_back(FormatPrinted(average[column]));
      follows.push_back(
        Format(getMean([=](const PaperNumbers& paper) { return (paper.*columns)[column]; })));
    }
  }
  const double optimise =
    getMean([](const PaperNumbers& paper) { return paper.OptimiseMilliseconds; });
  const double build =
    getMean([](const PaperNumbers& paper) { return paper.BuildMilliseconds[HashedColumn]; });
  printed.push_back(FormatPrinted(averages.OptimiseMilliseconds));
  printed.push_back(
    Format(100.0 * averages.OptimiseMilliseconds / averages.BuildMilliseconds[HashedColumn]));
  follows.push_back(Format(optimise));
  follows.push_back(Format(100.0 * optimise / build));
  WriteRow(out, printed);
  WriteRow(out, follows);
}
}

void WriteTable1(std::ostream& out, const Sets& sets)
{
  out << "\n## Table 1: building and preprocessing\n";
  WriteTrees(out, sets);
  WriteMemory(out, sets);
  WriteBuilds(out, sets);
  WriteOptimisation(out, sets);
  WritePaperAverages(out);
}
}
