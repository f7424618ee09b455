// SPDX-License-Identifier: BSD-3-Clause
#include "PaperBatch.h"

#include "DirectBatch.h"
#include "PaperFormat.h"

#include <ostream>

namespace paper_benchmark
{
using hashedoctree::FoundLeaf;
using hashedoctree::MortonKey;

void MeasureBatch(const hashedoctree::Octree<3>& tree, const std::vector<float>& points,
  int repetitions, PaperResults& results)
{
  const hashedoctree::PointSpan<3, float> positions{ points.data(), points.size() / 3 };
  const int startDepth = results.StartDepth;
  std::uint64_t marks[2] = {};
  const auto findSingly = [&]
  {
    marks[0] = 0;
    for (std::size_t i = 0; i < positions.Count; ++i)
    {
      const MortonKey<3> key = tree.GetGrid().GetKey(positions[i]);
      marks[0] += FindLeaf(tree, key, startDepth).Key.GetValue() * (i + 1);
    }
  };
  const auto findAtOnce = [&]
  {
    marks[1] = 0;
    FindLeaves(tree, positions, 0, positions.Count, startDepth,
      [&marks](std::size_t i, const FoundLeaf<3>& leaf)
      { marks[1] += leaf.Key.GetValue() * (i + 1); });
  };
  const std::vector<Spread> times =
    TimeInTurns({ [&] { return GetSeconds(findSingly); }, [&] { return GetSeconds(findAtOnce); } },
      positions.Count, repetitions);
  results.SingleSearches = times[0];
  results.BatchSearches = times[1];
  ++results.CheckedAnswers;
  results.DifferentAnswers += marks[0] == marks[1] ? 0 : 1;
}

void WriteBatch(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n### Direct search for many positions at once\n\nFor every point from its coordinates "
         "on, ours from the median, one after the other; and at once, which has the memory where "
         "searches begin loaded ahead, 16 searches at a time. In us for each, timed in turns of "
         "their own.\n\n";
  WriteHead(out, { "set", "nodes x1000", "one at a time", "at once", "one at a time / at once" });
  for (const PaperResults& set : sets)
  {
    WriteRow(out,
      { set.Set.Name, Format(static_cast<double>(set.Nodes) / 1000.0),
        FormatTime(set.SingleSearches, 1e6), FormatTime(set.BatchSearches, 1e6),
        "x " + Format(set.SingleSearches.Median / set.BatchSearches.Median) });
  }
}
}
