// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LargePagesAllocator_h
#define Testing_Benchmarks_LargePagesAllocator_h

#include "LargePages.h"

#include <cstdlib>
#include <new>

/** For standard containers of what is compared with our trees: memory from where their Buffers have
 * it, in large pages where these pay, so that the structures differ and not the pages. */
template <typename T>
class LargePagesAllocator
{
public:
  using value_type = T;

  LargePagesAllocator() = default;
  template <typename Other>
  LargePagesAllocator(const LargePagesAllocator<Other>&)
  {
  }

  T* allocate(std::size_t count)
  {
    void* memory = hashedoctree::AllocateInLargePages(count * sizeof(T));
    if (memory == nullptr)
    {
      throw std::bad_alloc();
    }
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend bool operator==(const LargePagesAllocator&, const LargePagesAllocator&) { return true; }
  friend bool operator!=(const LargePagesAllocator&, const LargePagesAllocator&) { return false; }
};

#endif
