// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_LargePages_h
#define hashedoctree_LargePages_h

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace hashedoctree
{
constexpr std::size_t SmallPageSize = 4096;
constexpr std::size_t LargePageSize = std::size_t(2) << 20;
/** From here on large pages pay: a page fault takes longer than filling a small page. */
constexpr std::size_t FirstLargeSize = LargePageSize / 2;

/** Asks for large pages where they pay, for memory that nothing has been written to yet: far fewer
 * page faults while it is filled, fewer misses when it is read at random, and less to give back
 * when it is freed. Only a hint, and nothing on systems that know none. */
inline void UseLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
  if (bytes >= FirstLargeSize)
  {
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (address + SmallPageSize - 1) / SmallPageSize * SmallPageSize;
    madvise(reinterpret_cast<void*>(first), address + bytes - first, MADV_HUGEPAGE);
  }
#endif
}

constexpr std::size_t RoundToLargePages(std::size_t bytes)
{
  return (bytes + LargePageSize - 1) / LargePageSize * LargePageSize;
}

/** As std::malloc(), with large pages where they pay: then it takes up whole ones. */
inline void* AllocateInLargePages(std::size_t bytes)
{
#ifdef __linux__
  if (bytes >= FirstLargeSize)
  {
    const std::size_t rounded = RoundToLargePages(bytes);
    void* memory = std::aligned_alloc(LargePageSize, rounded);
    if (memory != nullptr)
    {
      UseLargePages(memory, rounded);
    }
    return memory;
  }
#endif
  return std::malloc(bytes);
}

/** As std::calloc(), with large pages where they pay: then they come from the system, which has
 * them zeroed, as they are touched, and go back to it at once. To be freed by FreeZeroed(). */
inline void* AllocateZeroedInLargePages(std::size_t bytes)
{
#ifdef __linux__
  if (bytes >= FirstLargeSize)
  {
    // One page more than wanted, for a whole number of pages in it.
    const std::size_t rounded = RoundToLargePages(bytes);
    void* mapped = mmap(
      nullptr, rounded + LargePageSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED)
    {
      return nullptr;
    }
    char* const begin = static_cast<char*>(mapped);
    const std::size_t before = RoundToLargePages(reinterpret_cast<std::uintptr_t>(mapped)) -
      reinterpret_cast<std::uintptr_t>(mapped);
    if (before > 0)
    {
      munmap(begin, before);
    }
    munmap(begin + before + rounded, LargePageSize - before);
    UseLargePages(begin + before, rounded);
    return begin + before;
  }
#endif
  return std::calloc(bytes, 1);
}

inline void FreeZeroed(void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
  if (bytes >= FirstLargeSize)
  {
    munmap(memory, RoundToLargePages(bytes));
    return;
  }
#endif
  std::free(memory);
}
}

#endif
