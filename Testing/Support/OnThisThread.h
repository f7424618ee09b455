// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_OnThisThread_h
#define Testing_Support_OnThisThread_h

#include "Execution.h"

#include <algorithm>

/** A parallel-for of the calling thread alone, grain by grain. */
inline void OnThisThread(
  std::size_t first, std::size_t last, std::size_t grain, const hashedoctree::Execution::Body& body)
{
  for (; first < last; first += grain)
  {
    body(first, std::min(last, first + grain));
  }
}

/** Interrupted at its first look at progress. */
inline hashedoctree::Execution MakeInterrupted()
{
  return hashedoctree::Execution(OnThisThread, [](double) { return false; });
}

#endif
