// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LargePagesResource_h
#define Testing_Benchmarks_LargePagesResource_h

#include "LargePages.h"

#include <cstdlib>
#include <memory_resource>
#include <new>

/** For the containers of what is compared with our trees: memory from where their Buffers have it,
 * in large pages where these pay, so that the structures differ and not the pages. */
class LargePagesResource : public std::pmr::memory_resource
{
private:
  void* do_allocate(std::size_t bytes, std::size_t) override
  {
    void* memory = hashedoctree::AllocateInLargePages(bytes);
    if (memory == nullptr)
    {
      throw std::bad_alloc();
    }
    return memory;
  }
  void do_deallocate(void* memory, std::size_t, std::size_t) override { std::free(memory); }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override
  {
    return this == &other;
  }
};

/** The one of the program. */
inline std::pmr::memory_resource* GetLargePages()
{
  static LargePagesResource resource;
  return &resource;
}

#endif
