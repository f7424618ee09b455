// SPDX-License-Identifier: BSD-3-Clause
#include "PaperWorkloads.h"

#include "DirectSearch.h"
#include "ForEachNode.h"
#include "PaperMeasurement.h"

#include <algorithm>
#include <array>

namespace paper_benchmark
{
namespace
{
using hashedoctree::Octree;

std::vector<Key> MakePointKeys(const Octree<3>& tree, const std::vector<float>& points)
{
  std::vector<Key> keys;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    keys.push_back(tree.GetGrid().GetKey(&points[i]));
  }
  return keys;
}

std::vector<Key> MakeLeafKeys(const Octree<3>& tree)
{
  const std::size_t step = (tree.GetNumberOfLeaves() - 1) / MaxLeafSearches + 1;
  std::size_t number = 0;
  std::vector<Key> keys;
  ForEachLeaf(tree,
    [&](const Octree<3>::Node& leaf)
    {
      if (number++ % step == 0)
      {
        keys.push_back(leaf.NodeKey.GetFirstAtMaxDepth());
      }
    });
  return keys;
}

/** Row after row, as a loop over a grid goes. */
std::vector<Key> MakeGridKeys()
{
  constexpr std::uint32_t size = 1U << GridDepth;
  std::vector<Key> keys;
  for (std::uint32_t i = 0; i < size * size * size; ++i)
  {
    const hashedoctree::Cell<3> cell{ i % size, i / size % size, i / size / size };
    keys.push_back(Key::FromCell(cell, GridDepth).GetFirstAtMaxDepth());
  }
  return keys;
}

/** `sumOfFound` is set to the sum of what find() returns. */
template <typename Find>
double TimeKeys(const std::vector<Key>& keys, const Find& find, std::uint64_t& sumOfFound)
{
  std::uint64_t sum = 0;
  const double seconds = GetSeconds(
    [&]
    {
      for (const Key key : keys)
      {
        sum += find(key);
      }
    });
  sumOfFound = sum;
  return seconds;
}
}

void MeasureWorkloads(
  const PaperTrees& trees, const std::vector<float>& points, int repetitions, PaperResults& results)
{
  for (std::size_t row = 0; row < NumberOfModels; ++row)
  {
    const std::vector<Key> keys = row == 0 ? MakePointKeys(trees.Ours, points)
      : row == 1                           ? MakeLeafKeys(trees.Ours)
                                           : MakeGridKeys();
    std::vector<std::function<double()>> runs;
    std::array<std::uint64_t, 2 * NumberOfModels> sums{};
    const auto addRun = [&](const auto& find)
    {
      std::uint64_t& sum = sums[runs.size()];
      runs.emplace_back([&keys, &sum, find] { return TimeKeys(keys, find, sum); });
    };
    for (const FrequencyCosts& model : results.Frequencies)
    {
      addRun([&trees, startDepth = model.StartDepth](Key key)
        { return trees.Paper->FindLeaf(key, startDepth)->Key; });
      addRun([&trees, startDepth = model.StartDepth](Key key)
        { return hashedoctree::FindLeaf(trees.Ours, key, startDepth).Key.GetValue(); });
    }
    const std::vector<Spread> times = TimeInTurns(runs, keys.size(), repetitions);
    ++results.CheckedAnswers;
    const bool agree = std::equal(sums.begin() + 1, sums.end(), sums.begin());
    results.DifferentAnswers += agree ? 0 : 1;
    for (std::size_t model = 0; model < NumberOfModels; ++model)
    {
      results.PaperWorkloads[row][model] = times[2 * model];
      results.OurWorkloads[row][model] = times[2 * model + 1];
    }
  }
}
}
