// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_SpareMemory_h
#define hashedoctree_SpareMemory_h

#include "Buffer.h"

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/**
 * Memory in which its owner has nothing while a function runs, lent to that to write to at will:
 * fresh pages cost more than what most loops do with them.
 */
struct SpareMemory
{
  void* Data = nullptr;
  std::size_t Bytes = 0;
};

/** Room for `size` values, uninitialised: in the spare memory if that is large enough and aligned
 * for them, else in `own`, which is made for it. */
template <typename T>
T* FindRoom(std::size_t size, SpareMemory spare, Buffer<T>& own)
{
  const bool isAligned = reinterpret_cast<std::uintptr_t>(spare.Data) % alignof(T) == 0;
  if (isAligned && spare.Bytes >= size * sizeof(T))
  {
    return static_cast<T*>(spare.Data);
  }
  own = Buffer<T>(size);
  return own.GetData();
}
}

#endif
