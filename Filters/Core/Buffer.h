// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Buffer_h
#define hashedoctree_Buffer_h

#include "LargePages.h"

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace hashedoctree
{
/** How the memory of a Buffer starts. */
enum class Memory
{
  Uninitialised,
  Zeroed
};

/**
 * An array of plain values whose size is fixed, for arrays so large that writing them counts: its
 * pages are first touched by the threads that fill it, and zeroed ones come from the system as they
 * are touched. It can be moved, not copied. Throws std::bad_alloc. Use std::vector for anything
 * small.
 */
template <typename T>
class Buffer
{
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>,
    "a Buffer runs no constructors");

public:
  Buffer() = default;
  explicit Buffer(std::size_t size, Memory memory = Memory::Uninitialised)
    : Size(size)
  {
    // Half of all addresses: the bytes below, and whole large pages of them, can be counted.
    constexpr std::size_t most = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T);
    if (size > most)
    {
      throw std::bad_alloc();
    }
    if (size > 0)
    {
      // (What is allocated fits any type but those that ask for more.)
      constexpr std::size_t slack = alignof(T) > alignof(std::max_align_t) ? alignof(T) - 1 : 0;
      const std::size_t bytes = size * sizeof(T) + slack;
      this->Allocation = memory == Memory::Zeroed
        ? std::unique_ptr<void, Free>(AllocateZeroedInLargePages(bytes), Free{ bytes })
        : std::unique_ptr<void, Free>(AllocateInLargePages(bytes));
      if (!this->Allocation)
      {
        throw std::bad_alloc();
      }
      void* aligned = this->Allocation.get();
      std::size_t space = bytes;
      this->Values = static_cast<T*>(std::align(alignof(T), size * sizeof(T), aligned, space));
    }
  }
  Buffer(Buffer&& other) noexcept
    : Allocation(std::move(other.Allocation))
    , Values(std::exchange(other.Values, nullptr))
    , Size(std::exchange(other.Size, 0))
  {
  }
  Buffer& operator=(Buffer&& other) noexcept
  {
    this->Allocation = std::move(other.Allocation);
    this->Values = std::exchange(other.Values, nullptr);
    this->Size = std::exchange(other.Size, 0);
    return *this;
  }

  T& operator[](std::size_t i) { return this->Values[i]; }
  const T& operator[](std::size_t i) const { return this->Values[i]; }
  T* GetData() { return this->Values; }
  const T* GetData() const { return this->Values; }
  std::size_t GetSize() const { return this->Size; }
  std::size_t GetBytes() const { return this->Size * sizeof(T); }

private:
  struct Free
  {
    std::size_t ZeroedBytes = 0; ///< 0 where memory did not start zeroed.

    void operator()(void* memory) const
    {
      if (this->ZeroedBytes > 0)
      {
        FreeZeroed(memory, this->ZeroedBytes);
      }
      else
      {
        std::free(memory);
      }
    }
  };
  std::unique_ptr<void, Free> Allocation;
  T* Values = nullptr; ///< The first aligned place in it.
  std::size_t Size = 0;
};
}

#endif
