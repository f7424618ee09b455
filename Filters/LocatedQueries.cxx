// SPDX-License-Identifier: BSD-3-Clause
#include "LocatedQueries.h"

#include "PointsAdaptor.h"
#include "QueryArrays.h"
#include "QueryDepths.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace hashedoctree
{
namespace
{
constexpr std::size_t QueriesAtATime = 1024; // That a thread does.

/** `sums` and `costs` have a number for each search. */
template <typename Costs>
void Add(Costs& sums, const Costs& costs)
{
  std::transform(sums.begin(), sums.end(), costs.begin(), sums.begin(), std::plus<>());
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
  , Others(queries != nullptr ? DuplicatePoints(queries) : DuplicatePoints())
{
  vtkNew<vtkPolyData> nothing;
  const PointsAdaptor points(
    queries != nullptr ? queries : nothing.Get(), execution.Part(0.0, 0.5));
  points.Visit(
    [&](auto span)
    {
      this->Own =
        GetQueryKeys(octree.Tree.GetGrid(), Project(span, octree.Frame), execution.Part(0.5, 0.8));
    });
  this->Count(execution.Part(0.8, 0.9));
  if (octree.Processes.AreSeveral())
  {
    const Keys finite = this->TakeFinite(DuplicatePoints(), execution.Part(0.9, 1.0));
    this->Taken = octree.Processes.Exchange(octree.Division.Deal(finite));
  }
}

template <int Dim>
void LocatedQueries<Dim>::Count(const Execution& execution)
{
  struct Counts
  {
    std::size_t Counted = 0;
    std::size_t Skipped = 0;
  };
  const auto chunks = execution.MapChunks(this->Own.GetSize(), QueriesAtATime,
    [this](std::size_t first, std::size_t last)
    {
      Counts counts;
      for (std::size_t i = first; i < last; ++i)
      {
        const bool isCounted = !this->Others.Have(static_cast<vtkIdType>(i));
        counts.Counted += isCounted ? 1 : 0;
        counts.Skipped += isCounted && this->Own[i] == MortonKey<Dim>(0) ? 1 : 0;
      }
      return counts;
    });
  for (const Counts& counts : chunks)
  {
    this->Counted += counts.Counted;
    this->Skipped += counts.Skipped;
  }
}

/** The keys of the finite queries of this process, but for some. */
template <int Dim>
auto LocatedQueries<Dim>::TakeFinite(
  const DuplicatePoints& leftOut, const Execution& execution) const -> Keys
{
  Keys keys;
  keys.reserve(this->Own.GetSize());
  execution.OnOneThread().ForEach(this->Own.GetSize(), QueriesAtATime,
    [&](std::size_t i)
    {
      if (this->Own[i] != MortonKey<Dim>(0) && !leftOut.Have(static_cast<vtkIdType>(i)))
      {
        keys.push_back(this->Own[i]);
      }
    });
  return keys;
}

template <int Dim>
DepthHistogram LocatedQueries<Dim>::MeasureDepths(const Execution& execution) const
{
  const ProcessGroup& processes = this->Tree.Processes;
  const Execution taking = execution.Part(0.0, 0.3);
  const Execution measuring = execution.Part(0.3, 1.0);
  const auto measure = [&](const MortonKey<Dim>* keys, std::size_t count) {
    return MeasureQueryDepths(this->Tree.Tree, KeySpan<Dim>{ keys, count }, measuring);
  };
  DepthHistogram depths;
  if (processes.Sum(this->Others.AreThere() ? 1U : 0U) > 0)
  {
    Keys counted = this->TakeFinite(this->Others, taking);
    if (processes.AreSeveral())
    {
      counted = processes.Exchange(this->Tree.Division.Deal(counted)).Values;
    }
    depths = measure(counted.data(), counted.size());
  }
  else if (processes.AreSeveral())
  {
    depths = measure(this->Taken.Values.data(), this->Taken.Values.size());
  }
  else
  {
    depths = measure(this->Own.GetData(), this->Own.GetSize());
  }
  depths.resize(this->Tree.Counts.Leaves.size());
  processes.Sum(depths);
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
  const auto chunks = execution.MapChunks(this->Own.GetSize(), QueriesAtATime,
    [&](std::size_t first, std::size_t last)
    {
      Costs costs{};
      for (std::size_t i = first; i < last; ++i)
      {
        const bool isFinite = this->Own[i] != MortonKey<Dim>(0);
        this->Take(i, isFinite ? search.Find(this->Own[i]) : FoundQuery<Dim>(), arrays, costs);
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

/** Keeps what is found for a query of this process, and adds what that cost, unless the query is
 * another piece's. */
template <int Dim>
void LocatedQueries<Dim>::Take(std::size_t query, const FoundQuery<Dim>& found,
  const QueryArrays<Dim>& arrays, Costs& sums) const
{
  const auto id = static_cast<vtkIdType>(query);
  arrays.Set(id, found);
  if (!this->Others.Have(id))
  {
    Add(sums, found.Costs);
  }
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
  execution.ForEach(taken.size(), QueriesAtATime,
    [&](std::size_t i)
    { SentQuery<Dim>::Write(search.Find(taken[i]), &answers.Values[words * i]); });
  answers = this->Tree.Processes.Exchange(answers);

  const QueryArrays<Dim> arrays(output);
  Costs costs{};
  std::vector<std::size_t> next = answers.GetBegins(); // Each comes in the order of the keys.
  for (std::size_t i = 0; i < this->Own.GetSize(); ++i)
  {
    FoundQuery<Dim> found;
    if (this->Own[i] != MortonKey<Dim>(0))
    {
      const std::size_t part = this->Tree.Division.FindPart(this->Own[i]);
      found = SentQuery<Dim>::Read(&answers.Values[next[part]]);
      next[part] += words;
    }
    this->Take(i, found, arrays, costs);
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
