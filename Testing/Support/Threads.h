// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_Threads_h
#define Testing_Support_Threads_h

#include "Execution.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

/** A parallel-for on plain threads, so that sanitizers see all of it. */
inline hashedoctree::Execution::ParallelFor OnThreads(unsigned numberOfThreads)
{
  return [numberOfThreads](std::size_t first, std::size_t last, std::size_t grain,
           const hashedoctree::Execution::Body& body)
  {
    std::atomic<std::size_t> next{ first };
    const auto work = [&]
    {
      for (;;)
      {
        const std::size_t from = next.fetch_add(grain);
        if (from >= last)
        {
          return;
        }
        body(from, std::min(last, from + grain));
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
  };
}

#endif
