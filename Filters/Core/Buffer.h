// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Buffer_h
#define hashedoctree_Buffer_h

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace hashedoctree
{
/** How the memory of a Buffer starts. */
enum class Memory
{
  Uninitialised,
  Zeroed
};

/**
 * An array of plain values whose size is fixed, for arrays too large to be written twice: its pages
 * are first touched by the threads that fill it, and zeroed ones come from the system as they are
 * touched. It can be moved, not copied. Throws std::bad_alloc. Use std::vector for anything small.
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
    if (size > 0)
    {
      this->Values.reset(static_cast<T*>(
        memory == Memory::Zeroed ? std::calloc(size, sizeof(T)) : std::malloc(size * sizeof(T))));
      if (!this->Values)
      {
        throw std::bad_alloc();
      }
      UseLargePages(this->Values.get(), this->GetBytes());
    }
  }
  Buffer(Buffer&& other) noexcept
    : Values(std::move(other.Values))
    , Size(std::exchange(other.Size, 0))
  {
  }
  Buffer& operator=(Buffer&& other) noexcept
  {
    this->Values = std::move(other.Values);
    this->Size = std::exchange(other.Size, 0);
    return *this;
  }

  T& operator[](std::size_t i) { return this->Values.get()[i]; }
  const T& operator[](std::size_t i) const { return this->Values.get()[i]; }
  T* GetData() { return this->Values.get(); }
  const T* GetData() const { return this->Values.get(); }
  std::size_t GetSize() const { return this->Size; }
  std::size_t GetBytes() const { return this->Size * sizeof(T); }

private:
  /** Asks for large pages where they pay: far fewer page faults while an array is filled, and fewer
   * misses when it is read at random. Only a hint. */
  static void UseLargePages(void* memory, std::size_t bytes)
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

  struct Free
  {
    void operator()(T* values) const { std::free(values); }
  };
  std::unique_ptr<T, Free> Values;
  std::size_t Size = 0;
};
}

#endif
