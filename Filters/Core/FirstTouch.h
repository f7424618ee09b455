// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_FirstTouch_h
#define hashedoctree_FirstTouch_h

#include "Buffer.h"
#include "Execution.h"
#include "LargePages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/**
 * Has the system hand out the pages of an array that nothing was written to yet: in order, each to
 * one thread, with looks at progress, which stays at 0, in between. For memory that is filled at
 * random: otherwise the first values wait for all pages, and several threads at once clear the same
 * ones. On virtual machines a large page can take milliseconds. Zeroed memory stays so. Small
 * arrays, which have no large pages, are left as they are. O(pages).
 */
template <typename T>
void TouchPages(T* values, std::size_t size, const Execution& execution)
{
  constexpr std::size_t slice = 4 * LargePageSize; // Between two looks at progress.
  if (size * sizeof(T) < FirstLargeSize)
  {
    return;
  }
  char* const memory = reinterpret_cast<char*>(values);
  // Where it begins in its first large page, from which bytes are counted.
  const std::size_t begin = reinterpret_cast<std::uintptr_t>(memory) % LargePageSize;
  const std::size_t end = begin + size * sizeof(T);
  const Execution still = execution.Part(0.0, 0.0);
  for (std::size_t done = 0; done < end; done += slice)
  {
    still.ForChunks(std::min(slice, end - done), LargePageSize,
      [memory, begin, done](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t page = done + first; page < done + last; page += SmallPageSize)
        {
          memory[std::max(begin, page) - begin] = 0;
        }
      });
  }
}
template <typename T>
void TouchPages(Buffer<T>& buffer, const Execution& execution)
{
  TouchPages(buffer.GetData(), buffer.GetSize(), execution);
}
}

#endif
