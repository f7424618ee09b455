// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_ScarceMemory_h
#define Testing_Support_ScarceMemory_h

#include <cstddef>
#include <cstdlib>
#include <new>

/** How many more times this thread gets memory, by `new` or, in what is linked into the program, by
 * malloc(), calloc() and aligned_alloc(); none is left at 0. Not counted are memory that is mapped
 * (Buffers of 1 MiB and more) and `new` with an alignment. To be included by one file of a program.
 */
inline thread_local std::size_t AllocationsLeft = ~std::size_t(0);

inline bool TakeAllocation()
{
  if (AllocationsLeft == 0)
  {
    return false;
  }
  --AllocationsLeft;
  return true;
}

// The linker makes of each call of malloc() one of __wrap_malloc(), and of the others likewise; see
// AddTests.cmake.
void* RealMalloc(std::size_t bytes) __asm__("__real_malloc");
void* RealCalloc(std::size_t count, std::size_t bytes) __asm__("__real_calloc");
void* RealAlignedAlloc(std::size_t alignment, std::size_t bytes) __asm__("__real_aligned_alloc");
void* WrapMalloc(std::size_t bytes) __asm__("__wrap_malloc");
void* WrapCalloc(std::size_t count, std::size_t bytes) __asm__("__wrap_calloc");
void* WrapAlignedAlloc(std::size_t alignment, std::size_t bytes) __asm__("__wrap_aligned_alloc");

void* WrapMalloc(std::size_t bytes)
{
  return TakeAllocation() ? RealMalloc(bytes) : nullptr;
}
void* WrapCalloc(std::size_t count, std::size_t bytes)
{
  return TakeAllocation() ? RealCalloc(count, bytes) : nullptr;
}
void* WrapAlignedAlloc(std::size_t alignment, std::size_t bytes)
{
  return TakeAllocation() ? RealAlignedAlloc(alignment, bytes) : nullptr;
}

// Replacing these is what the standard provides for. Not inline, or GCC takes new and free() for a
// mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
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
