// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_LargePages_h
#define hashedoctree_LargePages_h

#include <cstddef>
#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace hashedoctree
{
/** Asks for large pages where they pay, for memory that nothing has been written to yet: far fewer
 * page faults while it is filled, fewer misses when it is read at random, and less to give back
 * when it is freed. Only a hint, and nothing on systems that know none. */
inline void UseLargePages(void* memory, std::size_t bytes)
{
#ifdef __linux__
  constexpr std::size_t pageSize = 4096;
  constexpr std::size_t worthwhile = std::size_t(4) << 20;
  if (bytes >= worthwhile)
  {
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (address + pageSize - 1) / pageSize * pageSize;
    madvise(reinterpret_cast<void*>(first), address + bytes - first, MADV_HUGEPAGE);
  }
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}
}

#endif
