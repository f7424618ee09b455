// SPDX-License-Identifier: BSD-3-Clause
#include "PaperKeys.h"

#include "Interleaving.h"
#include "PaperFormat.h"

#include <algorithm>
#include <ostream>

namespace paper_benchmark
{
namespace
{
using hashedoctree::Octree;

void MeasureInterleaving(
  const Octree<3>& tree, const std::vector<float>& points, int repetitions, PaperResults& results)
{
  std::vector<hashedoctree::Cell<3>> cells;
  cells.reserve(points.size() / 3);
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    cells.push_back(tree.GetGrid().GetCell(&points[i]));
  }
  std::vector<Key> dilated(cells.size());
  std::vector<Key> deposited(cells.size());
  const auto time = [&cells](std::vector<Key>& keys, const auto& interleave)
  {
    return GetSeconds(
      [&] { std::transform(cells.begin(), cells.end(), keys.begin(), interleave); });
  };
  std::vector<std::function<double()>> runs{ [&]
    {
      return time(dilated,
        [](const hashedoctree::Cell<3>& cell) { return Key::FromCell(cell, Key::MaxDepth); });
    } };
  if (hashedoctree::HasPdep())
  {
    runs.emplace_back(
      [&]
      {
        return time(deposited,
          [](const hashedoctree::Cell<3>& cell)
          { return hashedoctree::DepositCell<3>(cell, Key::MaxDepth); });
      });
  }
  const std::vector<Spread> times = TimeInTurns(runs, cells.size(), repetitions);
  results.Keys.Dilation = times.front();
  if (hashedoctree::HasPdep())
  {
    results.Keys.Pdep = times.back();
    ++results.CheckedAnswers;
    results.DifferentAnswers += dilated == deposited ? 0 : 1;
  }
}

template <typename Hash>
HashProbes CountProbes(const Octree<3>& tree)
{
  hashedoctree::NodeTable<std::uint64_t, Hash> table(tree.GetNumberOfInternalNodes());
  for (std::size_t block = 0; block < tree.GetNumberOfInternalNodes(); ++block)
  {
    table.Insert(tree.GetBlockKey(block).GetValue(), block);
  }
  const std::vector<std::size_t> lengths = table.GetProbeLengths();
  double sum = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    sum += static_cast<double>(lengths[i] * (i + 1));
  }
  const auto keys = static_cast<double>(table.GetNumberOfKeys());
  return { table.GetLoadFactor(), static_cast<double>(lengths.front()) / keys, sum / keys,
    lengths.size() };
}

std::string FormatNanoseconds(const Spread& time)
{
  return time.Median == 0.0 ? "-" : FormatTime(time, 1e9);
}
}

void MeasureKeys(
  const Octree<3>& tree, const std::vector<float>& points, int repetitions, PaperResults& results)
{
  MeasureInterleaving(tree, points, repetitions, results);
  results.Keys.LowBits = CountProbes<hashedoctree::LowBitsHash>(tree);
  results.Keys.Mixing = CountProbes<hashedoctree::MixingHash>(tree);
}

void WriteKeys(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Keys and their hashing\n\nTime for the key of one point, given its cell, by integer "
         "dilation and by the machine's bit deposit (- where it has none). Then our table with the "
         "keys of the internal nodes, by the paper's hash (the low bits of the key) and by the "
         "mixing hash: share of slots taken, share of keys found in the first bucket of "
      << hashedoctree::SlotsOfBucket
      << " slots that is looked at, mean and greatest number of buckets.\n\n";
  WriteHead(out,
    { "set", "ns dilation", "ns bit deposit", "low bits: load", "in the first", "mean", "greatest",
      "mixing: load", "in the first", "mean", "greatest" });
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name, FormatNanoseconds(set.Keys.Dilation),
      FormatNanoseconds(set.Keys.Pdep) };
    for (const HashProbes& probes : { set.Keys.LowBits, set.Keys.Mixing })
    {
      row.push_back(Format(probes.Load));
      row.push_back(Format(probes.First));
      row.push_back(Format(probes.Mean));
      row.push_back(std::to_string(probes.Greatest));
    }
    WriteRow(out, row);
  }
}
}
