// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_CurveBuilders_h
#define Testing_Support_CurveBuilders_h

#include "CurveDivision.h"
#include "SampleTree.h"
#include "Sanitized.h"
#include "TreePart.h"

#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

template <int Dim>
using CurveKeys = std::vector<hashedoctree::MortonKey<Dim>>;

/** Keys all over the root. */
template <int Dim>
CurveKeys<Dim> MakeRandomKeys(std::size_t count, unsigned seed)
{
  constexpr std::uint64_t first =
    hashedoctree::MortonKey<Dim>::Root().GetFirstAtMaxDepth().GetValue();
  std::mt19937_64 random(seed);
  CurveKeys<Dim> keys;
  for (std::size_t i = 0; i < count; ++i)
  {
    keys.emplace_back(first | random() % first);
  }
  return keys;
}

/** Adds up values of several threads, each of which waits for the others. */
class AddingUp
{
public:
  explicit AddingUp(std::size_t numberOfThreads)
    : NumberOfThreads(numberOfThreads)
  {
  }

  void operator()(std::vector<std::uint64_t>& values)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Sums.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Sums[i] += values[i];
    }
    const std::size_t round = this->Rounds;
    if (++this->Arrived == this->NumberOfThreads)
    {
      this->Results = std::exchange(this->Sums, {});
      this->Arrived = 0;
      ++this->Rounds;
      this->NextRound.notify_all();
    }
    this->NextRound.wait(lock, [this, round] { return this->Rounds != round; });
    values = this->Results; // All have to come before the next round ends.
  }

private:
  const std::size_t NumberOfThreads;
  std::mutex Mutex;
  std::condition_variable NextRound;
  std::size_t Arrived = 0;
  std::size_t Rounds = 0;
  std::vector<std::uint64_t> Sums;
  std::vector<std::uint64_t> Results;
};

/** Appends to the keys of each part. */
template <int Dim>
void Append(const hashedoctree::Parted<hashedoctree::MortonKey<Dim>>& keys,
  std::vector<CurveKeys<Dim>>& ofParts)
{
  auto begin = keys.Values.begin();
  for (std::size_t part = 0; part < ofParts.size(); ++part)
  {
    const auto end = begin + static_cast<std::ptrdiff_t>(keys.Counts[part]);
    ofParts[part].insert(ofParts[part].end(), begin, end);
    begin = end;
  }
}

/** Builders with points at random, who divide the curve and each make a tree of one part. */
template <int Dim>
struct CurveBuilders
{
  using Division = hashedoctree::CurveDivision<Dim>;
  std::unique_ptr<Division> Divided;
  std::vector<std::unique_ptr<hashedoctree::Octree<Dim>>> Trees;
  std::vector<CurveKeys<Dim>> Own;

  CurveBuilders(const PointSample<Dim, double>& sample, const hashedoctree::Octree<Dim>& whole,
    std::size_t number)
  {
    const auto& options = whole.GetOptions();
    std::vector<CurveKeys<Dim>> given(number);
    std::mt19937 random(7);
    for (std::size_t i = 0; i < whole.GetNumberOfPoints(); ++i)
    {
      // Those that take part, in an order that is not that of the curve.
      const std::size_t point = whole.GetPointIds()[i];
      given[random() % number].push_back(
        whole.GetGrid().GetKey(hashedoctree::GetPosition<Dim>(sample.GetSpan(), point)));
    }
    CurveKeys<Dim> samples;
    for (const CurveKeys<Dim>& keys : given)
    {
      const CurveKeys<Dim> ofBuilder = Division::Sample(keys, whole.GetNumberOfPoints(), number);
      samples.insert(samples.end(), ofBuilder.begin(), ofBuilder.end());
    }
    this->Divided = std::make_unique<Division>(samples, number, options.MaxDepth);
    this->Own.resize(number);
    for (const CurveKeys<Dim>& keys : given)
    {
      Append(this->Divided->Deal(keys), this->Own);
    }
    this->Build(whole);
  }

  /** Calls function(part) for the part of each builder, in threads that work together. */
  template <typename Function>
  void RunTogether(const hashedoctree::Octree<Dim>& whole, const Function& function) const
  {
    AddingUp addUp(this->Trees.size());
    std::vector<std::thread> threads;
    for (std::size_t part = 0; part < this->Trees.size(); ++part)
    {
      threads.emplace_back(
        [&, part]
        {
          function(hashedoctree::TreePart<Dim>(*this->Trees[part], this->Divided->GetRange(part),
            whole.GetDepthCounts(), std::ref(addUp)));
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

private:
  void Build(const hashedoctree::Octree<Dim>& whole)
  {
    const std::size_t overlap = Division::GetOverlapSize(whole.GetOptions().MaxPointsPerLeaf);
    std::vector<std::uint64_t> points;
    for (const CurveKeys<Dim>& keys : this->Own)
    {
      points.push_back(keys.size());
    }
    std::vector<CurveKeys<Dim>> all = this->Own;
    for (std::size_t part = 0; part < this->Own.size(); ++part)
    {
      Append(Division::GetOverlaps(part, this->Own[part], points, overlap), all);
    }
    for (const CurveKeys<Dim>& keys : all)
    {
      this->Trees.push_back(std::make_unique<hashedoctree::Octree<Dim>>(
        whole.GetGrid(), keys, whole.GetOptions(), hashedoctree::Execution()));
    }
  }
};

template <int Dim>
std::vector<PointSample<Dim, double>> MakeDividedSamples()
{
  auto samples = MakePointSamples<Dim, double>();
  samples.push_back({ "uniform", MakeUniformPoints<Dim, double>(3000, 11) });
  samples.push_back({ "clustered", MakeClusteredPoints<Dim, double>(3000, 12) });
  return samples;
}

/** Calls function(whole tree, builders) for all samples, limits and numbers of builders; with a
 * sanitizer, where that takes minutes, the numbers take turns. */
template <int Dim, typename Function>
void ForEachDivision(const Function& function)
{
  constexpr std::array<std::size_t, 4> numbers{ 1, 2, 3, 8 };
  constexpr std::size_t step = Sanitized ? numbers.size() : 1;
  std::size_t turn = 0;
  for (const auto& sample : MakeDividedSamples<Dim>())
  {
    ++turn; // There are six limits: without this one, each would meet the same two numbers.
    for (const typename hashedoctree::Octree<Dim>::Options options :
      { typename hashedoctree::Octree<Dim>::Options{},
        { 3, hashedoctree::MortonKey<Dim>::MaxDepth }, { 1, 4 }, { 40, 2 }, { 1, 0 },
        { 5000, hashedoctree::MortonKey<Dim>::MaxDepth } })
    {
      const SampleTree<Dim, double> made(sample, options);
      if (made.Tree.GetNumberOfPoints() == 0)
      {
        continue; // Nothing to divide.
      }
      for (std::size_t i = turn++ % step; i < numbers.size(); i += step)
      {
        const std::size_t number = numbers[i];
        SCOPED_TRACE(::testing::Message()
          << sample.Name << ", " << number << " builders, at most " << options.MaxPointsPerLeaf
          << " points down to " << options.MaxDepth);
        function(made.Tree, CurveBuilders<Dim>(sample, made.Tree, number));
      }
    }
  }
}

#endif
