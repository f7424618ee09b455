// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorTiming.h"

#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <numeric>

namespace locator_benchmark
{
namespace
{
using Clock = std::chrono::steady_clock;

double GetSecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/** Eight multiplications each step, none of which waits for another. */
std::uint64_t DoArithmetic(std::size_t steps)
{
  std::array<std::uint64_t, 8> numbers{ 1, 2, 3, 4, 5, 6, 7, 8 };
  for (std::size_t step = 0; step < steps; ++step)
  {
    for (std::uint64_t& number : numbers)
    {
      number = number * 6364136223846793005U + 1442695040888963407U;
    }
  }
  return std::accumulate(numbers.begin(), numbers.end(), std::uint64_t(0));
}

void Ask(LocatorPeer& peer, const Question& question, const Position& x, Answer& answer)
{
  switch (question.What)
  {
    case Operation::Closest:
      answer.Closest = peer.FindClosest(x);
      break;
    case Operation::Closest8:
    case Operation::Closest32:
    case Operation::Closest100:
      peer.FindClosest(GetNumberOfClosest(question.What), x, answer);
      break;
    case Operation::Radius:
      peer.FindWithin(question.Radius, x, answer);
      break;
    case Operation::Build:
      break;
  }
}
}

void UseThreads(int threads)
{
  vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
  vtkSMPTools::Initialize(threads);
}

double MeasureGainOfThreads(int threads)
{
  constexpr std::size_t steps = 2000000; // Milliseconds, as builds take.
  const auto time = [](int shares)
  {
    const auto start = Clock::now();
    vtkSMPTools::For(0, shares, 1,
      [shares](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType share = first; share < last; ++share)
        {
          benchmark::DoNotOptimize(DoArithmetic(steps / static_cast<std::size_t>(shares)));
        }
      });
    return GetSecondsSince(start);
  };
  return time(1) / time(threads);
}

Answers GetAnswers(
  LocatorPeer& peer, const Question& question, std::size_t numberOfPositions, double seconds)
{
  Answers answers;
  std::mutex mutex;
  const auto start = Clock::now();
  const auto body = [&](vtkIdType first, vtkIdType last)
  {
    Answer answer;
    for (auto i = static_cast<std::size_t>(first);
         i < static_cast<std::size_t>(last) && GetSecondsSince(start) < seconds; ++i)
    {
      Ask(peer, question, (*question.Positions)[i], answer);
      const std::lock_guard<std::mutex> lock(mutex);
      answers[i] = question.What == Operation::Closest ? std::vector<vtkIdType>{ answer.Closest }
                                                       : peer.GetIds(answer);
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(numberOfPositions), 8, body);
  return answers;
}

Timing TimeQueries(LocatorPeer& peer, const Question& question, double seconds)
{
  // Few enough for two threads to finish together.
  constexpr vtkIdType share = 512;
  // Between looks at the clock: one at first, for a slow peer.
  constexpr std::size_t largestBatch = 8;
  std::atomic<std::size_t> count{ 0 };
  const auto start = Clock::now();
  const auto body = [&](vtkIdType first, vtkIdType last)
  {
    Answer answer;
    auto i = static_cast<std::size_t>(first);
    std::size_t batch = 1;
    // At the first position in any case, so that something is timed however late the threads come.
    while (i < static_cast<std::size_t>(last) && (i == 0 || GetSecondsSince(start) < seconds))
    {
      const std::size_t end = std::min(i + batch, static_cast<std::size_t>(last));
      batch = std::min(2 * batch, largestBatch);
      for (; i < end; ++i)
      {
        Ask(peer, question, (*question.Positions)[i], answer);
        benchmark::DoNotOptimize(answer.Closest);
      }
    }
    count += i - static_cast<std::size_t>(first);
  };
  do
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(question.Positions->size()), share, body);
  } while (GetSecondsSince(start) < seconds);
  return { GetSecondsSince(start), count };
}

Timing TimeBuilds(const PeerKind& kind, const LocatorData& data, double seconds)
{
  const auto build = [&]
  {
    const std::unique_ptr<LocatorPeer> peer = kind.Make();
    const auto start = Clock::now();
    peer->Build(data);
    return GetSecondsSince(start);
  };
  build();
  Timing timing;
  do
  {
    timing.Seconds += build();
    ++timing.Count;
  } while (timing.Seconds < seconds);
  return timing;
}
}
