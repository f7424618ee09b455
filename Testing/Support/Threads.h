// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_Threads_h
#define Testing_Support_Threads_h

#include "Execution.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

/** A parallel-for on plain threads, so that sanitizers see all of it. The first thing that a body
 * throws ends it. */
inline hashedoctree::Execution::ParallelFor OnThreads(unsigned numberOfThreads)
{
  return [numberOfThreads](std::size_t first, std::size_t last, std::size_t grain,
           const hashedoctree::Execution::Body& body)
  {
    std::atomic<std::size_t> next{ first };
    std::exception_ptr thrown;
    std::once_flag isFirst;
    const auto work = [&]
    {
      try
      {
        for (std::size_t from = next.fetch_add(grain); from < last; from = next.fetch_add(grain))
        {
          body(from, std::min(last, from + grain));
        }
      }
      catch (...)
      {
        std::call_once(isFirst, [&] { thrown = std::current_exception(); });
        next = last;
      }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < numberOfThreads; ++i)
    {
      threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}

#endif
