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
  return SummariseProbes(table.GetLoadFactor(), table.GetProbeLengths());
}

std::string FormatNanoseconds(const Spread& time)
{
  return time.Median == 0.0 ? "-" : FormatTime(time, 1e9);
}

void WriteInterleaving(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Keys and their hashing\n\nTime for the key of one point, given its cell, by integer "
         "dilation and by the machine's bit deposit (- where it has none).\n\n";
  WriteHead(out, { "set", "ns dilation", "ns bit deposit" });
  for (const PaperResults& set : sets)
  {
    WriteRow(out,
      { set.Set.Name, FormatNanoseconds(set.Keys.Dilation), FormatNanoseconds(set.Keys.Pdep) });
  }
}

void AppendProbes(std::vector<std::string>& row, const HashProbes& probes)
{
  row.push_back(Format(probes.Load));
  for (const double share : probes.Shares)
  {
    row.push_back(Format(100.0 * share));
  }
  row.push_back(Format(probes.Mean));
  row.push_back(std::to_string(probes.Greatest));
}

void WriteChains(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\n### Chains in the paper's table\n\nAll nodes are in it, leaves too, by its hash (the 21 "
       "low bits of the key), those of one slot in a chain: nodes over slots, percent of the "
       "nodes for which so many are looked at, mean and greatest number, and what the mean would "
       "be if all slots were equally likely.\n\n";
  WriteHead(out,
    { "set", "load", "% 1 node", "2", "3 to 4", "5 to 8", "9 to 16", "more", "mean", "greatest",
      "mean if even" });
  for (const PaperResults& set : sets)
  {
    std::vector<std::string> row{ set.Set.Name };
    AppendProbes(row, set.Keys.Chains);
    row.push_back(Format(1.0 + set.Keys.Chains.Load / 2.0));
    WriteRow(out, row);
  }
}

void WriteBuckets(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out
    << "\n### Buckets of ours\n\nOur table with the keys of the internal nodes, by the paper's "
       "hash "
       "and by the mixing hash: share of slots taken, percent of the keys for which so many "
       "buckets of "
    << hashedoctree::SlotsOfBucket
    << " slots are looked at, mean and greatest number of buckets. Where a bucket is full the next "
       "one is taken, so that keys that follow each other in full buckets make long runs.\n\n";
  WriteHead(out,
    { "set", "hash", "load", "% 1 bucket", "2", "3 to 4", "5 to 8", "9 to 16", "more", "mean",
      "greatest" });
  for (const PaperResults& set : sets)
  {
    for (const HashProbes* probes : { &set.Keys.LowBits, &set.Keys.Mixing })
    {
      std::vector<std::string> row{ set.Set.Name,
        probes == &set.Keys.LowBits ? "low bits" : "mixing" };
      AppendProbes(row, *probes);
      WriteRow(out, row);
    }
  }
}
}

HashProbes SummariseProbes(double load, const std::vector<std::size_t>& lengths)
{
  HashProbes probes;
  probes.Load = load;
  probes.Greatest = lengths.size();
  double keys = 0.0;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    const auto number = static_cast<double>(lengths[i]);
    std::size_t place = 0;
    while (place + 1 < probes.Shares.size() && i >= std::size_t(1) << place)
    {
      ++place;
    }
    probes.Shares[place] += number;
    probes.Mean += number * static_cast<double>(i + 1);
    keys += number;
  }
  probes.Mean /= keys;
  for (double& share : probes.Shares)
  {
    share /= keys;
  }
  return probes;
}

void MeasureKeys(
  const PaperTrees& trees, const std::vector<float>& points, int repetitions, PaperResults& results)
{
  MeasureInterleaving(trees.Ours, points, repetitions, results);
  const auto slots = static_cast<double>(GetPaperHash().GetNumberOfSlots());
  results.Keys.Chains = SummariseProbes(
    static_cast<double>(trees.Ours.GetNumberOfNodes()) / slots, trees.Paper->GetProbeLengths());
  results.Keys.LowBits = CountProbes<hashedoctree::LowBitsHash>(trees.Ours);
  results.Keys.Mixing = CountProbes<hashedoctree::MixingHash>(trees.Ours);
}

void WriteKeys(std::ostream& out, const std::vector<PaperResults>& sets)
{
  WriteInterleaving(out, sets);
  WriteChains(out, sets);
  WriteBuckets(out, sets);
}
}
