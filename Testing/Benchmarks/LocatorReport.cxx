// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorReport.h"

#include "LocatorFigures.h"
#include "LocatorFormat.h"
#include "LocatorPeers.h"

#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace locator_benchmark
{
namespace
{
/** One benchmark of the first peer for each row. */
std::vector<LocatorCase> MakeRows(const LocatorOptions& options)
{
  std::vector<LocatorCase> rows;
  for (const std::string& data : options.Data)
  {
    for (const std::size_t size : options.Sizes)
    {
      for (const LocatorCase& which : options.MakeCases(data, size))
      {
        if (which.Peer == options.Peers[0])
        {
          rows.push_back(which);
        }
      }
    }
  }
  return rows;
}

std::vector<std::string> GetOthers(const LocatorOptions& options)
{
  return { options.Peers.begin() + 1, options.Peers.end() };
}

void WriteHeads(std::ostream& out, std::vector<std::string> first, const LocatorOptions& options)
{
  const std::vector<std::string> others = GetOthers(options);
  first.insert(first.end(), others.begin(), others.end());
  WriteHead(out, first);
}

void WriteTimes(std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
{
  out << "# Point locators\n\n"
         "Times for one query or one build of the locator \""
      << options.Peers[0]
      << "\", medians of the repetitions, then how many times as long the others take. Each "
         "repetition of builds begins with one that does not count. Hits are the mean of the "
         "positions whose answers are checked. VTK is "
      << vtkVersion::GetVTKVersion() << ".\n\n";
  for (const std::string& peer : options.Peers)
  {
    out << "- " << peer << ": " << GetPeerKind(peer).Description << "\n";
  }
  out << "\n";
  WriteHeads(out, { "data", "points", "queries", "operation", "threads", "hits", options.Peers[0] },
    options);
  for (const LocatorCase& row : MakeRows(options))
  {
    const double hits = row.What == Operation::Radius ? results.GetCounter(row, "mean_hits") : NAN;
    std::vector<std::string> cells{ row.Data, std::to_string(row.NumberOfPoints), row.Queries,
      GetOperationNames()[static_cast<std::size_t>(row.What)], std::to_string(row.Threads),
      FormatNumber(hits), FormatTime(results.GetSeconds(row)) };
    for (const std::string& peer : GetOthers(options))
    {
      cells.push_back(FormatNumber(GetRatio(results, row.WithPeer(peer), row)));
    }
    WriteRow(out, cells);
  }
}

/** The smallest and the geometric mean of the ratios of each peer in some of the rows. */
template <typename Predicate>
void WriteSummaryRows(std::ostream& out, const LocatorOptions& options,
  const LocatorResults& results, const std::string& title, const Predicate& takesPart)
{
  std::vector<std::string> smallest{ title, "minimum" };
  std::vector<std::string> mean{ title, "geometric mean" };
  for (const std::string& peer : GetOthers(options))
  {
    double least = INFINITY;
    double logarithms = 0.0;
    double count = 0.0;
    for (const LocatorCase& row : MakeRows(options))
    {
      const double ratio = GetRatio(results, row.WithPeer(peer), row);
      if (takesPart(row) && !std::isnan(ratio))
      {
        least = std::min(least, ratio);
        logarithms += std::log(ratio);
        ++count;
      }
    }
    smallest.push_back(FormatNumber(count > 0 ? least : NAN));
    mean.push_back(FormatNumber(std::exp(logarithms / count)));
  }
  WriteRow(out, smallest);
  WriteRow(out, mean);
}

void WriteSummary(std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
{
  out << "\n## Ratios\n\n";
  WriteHeads(out, { "rows", "" }, options);
  WriteSummaryRows(out, options, results, "all", [](const LocatorCase&) { return true; });
  for (const Operation operation : options.Operations)
  {
    WriteSummaryRows(out, options, results,
      GetOperationNames()[static_cast<std::size_t>(operation)],
      [=](const LocatorCase& row) { return row.What == operation; });
  }
  for (const std::string& data : options.Data)
  {
    WriteSummaryRows(
      out, options, results, data, [&](const LocatorCase& row) { return row.Data == data; });
  }
}

/** Peers that are not exact, and errors. */
void WriteDifferences(
  std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
{
  out << "\n## Answers\n\nAt some positions of each benchmark the distances were compared with "
         "ours, and a few of ours "
         "with those to every point.\n\n";
  for (const std::string& peer : options.Peers)
  {
    double differences = 0.0;
    double checked = 0.0;
    for (const LocatorCase& row : MakeRows(options))
    {
      const double counted = results.GetCounter(row.WithPeer(peer), "different_answers");
      differences += std::isnan(counted) ? 0.0 : counted;
      checked +=
        std::isnan(counted) ? 0.0 : results.GetCounter(row.WithPeer(peer), "checked_answers");
    }
    out << "- " << peer << ": " << differences << " of " << static_cast<std::size_t>(checked)
        << " answers differ\n";
  }
  for (const auto& error : results.GetErrors())
  {
    out << "- error: " << error.first << ": " << error.second << "\n";
  }
}
}

void WriteReport(
  const LocatorOptions& options, const LocatorResults& results, std::ostream& markdown)
{
  WriteTimes(markdown, options, results);
  WriteSummary(markdown, options, results);
  WriteFigures(markdown, options, results);
  WriteDifferences(markdown, options, results);
}
}
