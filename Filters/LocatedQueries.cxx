// SPDX-License-Identifier: BSD-3-Clause
#include "LocatedQueries.h"

#include "QueryArrays.h"
#include "QueryDepths.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

namespace hashedoctree
{
namespace
{
constexpr std::size_t ChunkOfQueries = 1024; // That a thread does at a time.

/** `sums` and `costs` have a number for each search. */
template <typename Costs>
void Add(Costs& sums, const Costs& costs)
{
  std::transform(sums.begin(), sums.end(), costs.begin(), sums.begin(), std::plus<>());
}

/** Those that are not 0. */
template <typename Key>
std::vector<Key> TakeFinite(const std::vector<Key>& keys)
{
  std::vector<Key> finite;
  std::copy_if(
    keys.begin(), keys.end(), std::back_inserter(finite), [](Key key) { return key != Key(0); });
  return finite;
}

/** What is found for one query as it is sent: the leaf's number and key, and a byte for the cost of
 * each search. */
template <int Dim>
struct SentQuery
{
  static constexpr std::size_t Words = 3;
  using Costs = typename SearchComparison<Dim>::Costs;
  static_assert(SearchComparison<Dim>::NumberOfSearches <= sizeof(std::uint64_t));
  static_assert(2 * (MortonKey<Dim>::MaxDepth + 1) <= 255, "a search examines no more nodes");

  static void Write(const FoundQuery<Dim>& found, std::uint64_t* words)
  {
    words[0] = static_cast<std::uint64_t>(found.LeafId);
    words[1] = found.LeafKey.GetValue();
    words[2] = 0;
    for (const std::uint64_t cost : found.Costs)
    {
      words[2] = words[2] << 8 | cost;
    }
  }

  static FoundQuery<Dim> Read(const std::uint64_t* words)
  {
    FoundQuery<Dim> found;
    found.LeafId = static_cast<vtkIdType>(words[0]);
    found.LeafKey = MortonKey<Dim>(words[1]);
    std::uint64_t costs = words[2];
    for (auto cost = found.Costs.rbegin(); cost != found.Costs.rend(); ++cost)
    {
      *cost = costs & 0xffU;
      costs >>= 8;
    }
    return found;
  }
};
}

template <int Dim>
LocatedQueries<Dim>::LocatedQueries(
  vtkDataSet* queries, const PointsOctree<Dim>& octree, const Execution& execution)
  : Tree(octree)
{
  vtkNew<vtkPolyData> nothing;
  const PointsAdaptor points(
    queries != nullptr ? queries : nothing.Get(), execution.Part(0.0, 0.5));
  points.Visit(
    [&](auto span)
    {
      this->Own =
        GetQueryKeys(octree.Tree.GetGrid(), Project(span, octree.Frame), execution.Part(0.5, 1.0));
    });
  this->Finite = this->Own.size() -
    static_cast<std::size_t>(std::count(this->Own.begin(), this->Own.end(), MortonKey<Dim>(0)));
  if (octree.Processes.AreSeveral())
  {
    this->Taken = octree.Processes.Exchange(octree.Division.Deal(TakeFinite(this->Own)));
  }
}

template <int Dim>
DepthHistogram LocatedQueries<Dim>::MeasureDepths(const Execution& execution) const
{
  const bool isAlone = !this->Tree.Processes.AreSeveral();
  DepthHistogram depths =
    MeasureQueryDepths(this->Tree.Tree, isAlone ? this->Own : this->Taken.Values, execution);
  depths.resize(this->Tree.Counts.Leaves.size());
  this->Tree.Processes.Sum(depths);
  return depths;
}

template <int Dim>
auto LocatedQueries<Dim>::Search(
  const QuerySearch<Dim>& search, vtkDataSet* output, const Execution& execution) const -> Costs
{
  if (this->Tree.Processes.AreSeveral())
  {
    return this->SearchWithOthers(search, output, execution);
  }
  const QueryArrays<Dim> arrays(output);
  return SearchAll(this->Own, search, execution,
    [&arrays](std::size_t i, const FoundQuery<Dim>& found)
    { arrays.Set(static_cast<vtkIdType>(i), found); });
}

/** Searches for the keys, and calls onFound(i, found) for each, on any thread. */
template <int Dim>
template <typename OnFound>
auto LocatedQueries<Dim>::SearchAll(const Keys& keys, const QuerySearch<Dim>& search,
  const Execution& execution, const OnFound& onFound) -> Costs
{
  const auto chunks = execution.MapChunks(keys.size(), ChunkOfQueries,
    [&](std::size_t first, std::size_t last)
    {
      Costs costs{};
      for (std::size_t i = first; i < last; ++i)
      {
        const bool isFinite = keys[i] != MortonKey<Dim>(0);
        const FoundQuery<Dim> found = isFinite ? search.Find(keys[i]) : FoundQuery<Dim>();
        onFound(i, found);
        Add(costs, found.Costs);
      }
      return costs;
    });
  Costs all{};
  for (const Costs& costs : chunks)
  {
    Add(all, costs);
  }
  return all;
}

template <int Dim>
auto LocatedQueries<Dim>::SearchWithOthers(
  const QuerySearch<Dim>& search, vtkDataSet* output, const Execution& execution) const -> Costs
{
  constexpr std::size_t words = SentQuery<Dim>::Words;
  const Keys& taken = this->Taken.Values;
  Parted<std::uint64_t> answers{ std::vector<std::uint64_t>(words * taken.size()),
    this->Taken.Counts };
  for (std::size_t& count : answers.Counts)
  {
    count *= words;
  }
  const Costs costs = SearchAll(taken, search, execution,
    [&answers](std::size_t i, const FoundQuery<Dim>& found)
    { SentQuery<Dim>::Write(found, &answers.Values[words * i]); });
  answers = this->Tree.Processes.Exchange(answers);

  const QueryArrays<Dim> arrays(output);
  std::vector<std::size_t> next = answers.GetBegins(); // Each comes in the order of the keys.
  for (std::size_t i = 0; i < this->Own.size(); ++i)
  {
    FoundQuery<Dim> found;
    if (this->Own[i] != MortonKey<Dim>(0))
    {
      const std::size_t part = this->Tree.Division.FindPart(this->Own[i]);
      found = SentQuery<Dim>::Read(&answers.Values[next[part]]);
      next[part] += words;
    }
    arrays.Set(static_cast<vtkIdType>(i), found);
  }
  std::vector<std::uint64_t> all(costs.begin(), costs.end());
  this->Tree.Processes.Sum(all);
  Costs ofAll;
  std::copy(all.begin(), all.end(), ofAll.begin());
  return ofAll;
}

template class LocatedQueries<2>;
template class LocatedQueries<3>;
}
