// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Execution_h
#define hashedoctree_Execution_h

#include "StopSign.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace hashedoctree
{
/** Thrown out of a long computation when its caller asked it to stop. */
struct Interrupted
{
};

/**
 * What a long computation borrows from its caller: threads, a place to report progress, and a sign
 * to stop.
 *
 * The library has no threads of its own. A ParallelFor calls body(first, last) on parts of the
 * range that it is given, of about `grain` items each or more, from any threads it likes, and
 * returns when all parts are done. What a body throws, the first of it if there is
 * more, comes out of the call when no part runs any more; parts not yet begun may be left out.
 *
 * Progress is told a fraction in [0, 1] that never falls, always on the thread that called For(),
 * and answers whether to go on; when it answers no, For() throws Interrupted. For() runs
 * a batch between two reports, so that a stop is heeded soon: GrainsPerThread for each thread, and
 * at least LeastBatchGrains; without reports, all.
 * Bodies with items that may take long by themselves call HeedStop() between them.
 */
class Execution
{
public:
  using Body = std::function<void(std::size_t first, std::size_t last)>;
  using ParallelFor =
    std::function<void(std::size_t first, std::size_t last, std::size_t grain, const Body& body)>;
  using Progress = std::function<bool(double fraction)>;

  /** Enough to share a range out evenly. More would cost: each may be a job that wakes a thread. */
  static constexpr std::size_t GrainsPerThread = 8;
  static constexpr std::size_t LeastBatchGrains = 32;

  /** One thread, no reports. */
  Execution()
    : Execution([](std::size_t first, std::size_t last, std::size_t, const Body& body)
        { body(first, last); })
  {
  }
  /** `numberOfThreads`: as many as parallelFor uses. */
  explicit Execution(ParallelFor parallelFor, Progress progress = {}, StopSign stop = {},
    std::size_t numberOfThreads = 1)
    : Threads(std::move(parallelFor))
    , Report(std::move(progress))
    , Stop(stop)
    , BatchGrains(std::max(LeastBatchGrains, GrainsPerThread * numberOfThreads))
  {
  }

  /** The same threads for a part of the run: its [0, 1] is [from, to] of this one. */
  Execution Part(double from, double to) const
  {
    Execution part = *this;
    if (this->Report)
    {
      part.Report = [report = this->Report, from, to](double fraction)
      { return report(std::min(to, from + (to - from) * fraction)); }; // Rounding may go beyond.
    }
    return part;
  }

  /** The same on the calling thread alone. */
  Execution OnOneThread() const { return Execution(Execution().Threads, this->Report, this->Stop); }

  /** Calls body on parts of [0, count), batch by batch, with progress after each. */
  void For(std::size_t count, std::size_t grain, const Body& body) const
  {
    // A call may start and join threads, which only reports make worth while.
    const std::size_t batch = this->Report ? grain * this->BatchGrains : count;
    for (std::size_t first = 0; first < count; first += batch)
    {
      const std::size_t last = std::min(count, first + batch);
      this->Threads(first, last, grain, body);
      this->Tell(static_cast<double>(last) / static_cast<double>(count));
    }
  }

  /** Calls function(i) for each i in [0, count), `grain` of them at a time. */
  template <typename Function>
  void ForEach(std::size_t count, std::size_t grain, const Function& function) const
  {
    this->For(count, grain,
      [&function](std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          function(i);
        }
      });
  }

  /** How many chunks of `chunkSize` items `count` items are; the last may be shorter. */
  static constexpr std::size_t GetNumberOfChunks(std::size_t count, std::size_t chunkSize)
  {
    return (count + chunkSize - 1) / chunkSize;
  }

  /** Calls function(chunk, first, last) for each chunk of [0, count), a chunk being a grain. */
  template <typename Function>
  void ForChunks(std::size_t count, std::size_t chunkSize, const Function& function) const
  {
    this->ForEach(GetNumberOfChunks(count, chunkSize), 1,
      [&](std::size_t chunk)
      { function(chunk, chunk * chunkSize, std::min(count, (chunk + 1) * chunkSize)); });
  }

  /** What function(first, last) returns for each chunk of [0, count), in their order. */
  template <typename Function>
  auto MapChunks(std::size_t count, std::size_t chunkSize, const Function& function) const
  {
    std::vector<decltype(function(count, count))> results(GetNumberOfChunks(count, chunkSize));
    this->ForChunks(count, chunkSize,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      { results[chunk] = function(first, last); });
    return results;
  }

  /** Reports progress; throws Interrupted when the caller wants no more. */
  void Tell(double fraction) const
  {
    if (this->Report && !this->Report(fraction))
    {
      throw Interrupted();
    }
  }

  /** Throws Interrupted when the sign to stop is up. For any thread, at any time. */
  void HeedStop() const
  {
    if (this->Stop.IsUp())
    {
      throw Interrupted();
    }
  }

private:
  ParallelFor Threads;
  Progress Report;
  StopSign Stop;
  std::size_t BatchGrains; ///< Between two reports of progress.
};
}

#endif
