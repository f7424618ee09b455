// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_ScarceMemory_h
#define Testing_Support_ScarceMemory_h

#include <cstddef>
#include <cstdlib>
#include <new>

/** How many more times `new` of this thread has memory; none is left at 0. To be included by one
 * file of a program. */
inline thread_local std::size_t AllocationsLeft = ~std::size_t(0);

// Replacing these is what the standard provides for; all other forms end here. Not inline, or GCC
// takes new and free() for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  if (AllocationsLeft == 0)
  {
    throw std::bad_alloc();
  }
  --AllocationsLeft;
  if (void* memory = std::malloc(size > 0 ? size : 1))
  {
    return memory;
  }
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

/** Calls change() with memory for one allocation more each time, until it has enough, and after
 * each failure afterFailure(), with all memory. Returns the number of failures. */
template <typename Change, typename AfterFailure>
std::size_t TryUntilDone(const Change& change, const AfterFailure& afterFailure)
{
  for (std::size_t allocations = 0;; ++allocations)
  {
    AllocationsLeft = allocations;
    try
    {
      change();
      AllocationsLeft = ~std::size_t(0);
      return allocations;
    }
    catch (const std::bad_alloc&)
    {
      AllocationsLeft = ~std::size_t(0);
      afterFailure();
    }
  }
}

#endif
