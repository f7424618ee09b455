// SPDX-License-Identifier: BSD-3-Clause
#ifndef FoundOfThread_h
#define FoundOfThread_h

#include "vtkIdList.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hashedoctree
{
/** The calling thread's own memory for what one query finds, so that most queries allocate none.
 * One at a time of each T in a thread. Who asks after that memory has ended, from destructors of
 * static or other thread-local objects, gets some for this query alone. Private to the module. */
template <typename T>
class FoundOfThread
{
public:
  FoundOfThread() { this->Values.clear(); }
  ~FoundOfThread()
  {
    if (this->Values.capacity() > MostToKeep)
    {
      std::vector<T>().swap(this->Values);
    }
  }
  FoundOfThread(const FoundOfThread&) = delete;
  void operator=(const FoundOfThread&) = delete;

  std::vector<T>& Get() { return this->Values; }

  /** Replaces the ids of a list by those of the values. */
  template <typename ToId>
  void CopyTo(vtkIdList* list, const ToId& toId) const
  {
    if (this->Values.empty())
    {
      list->Reset(); // Which is inlined.
      return;
    }
    list->SetNumberOfIds(static_cast<vtkIdType>(this->Values.size()));
    std::transform(this->Values.begin(), this->Values.end(), list->GetPointer(0),
      [&toId](const T& value) { return static_cast<vtkIdType>(toId(value)); });
  }

private:
  static constexpr std::size_t MostToKeep = 65536;

  struct Kept
  {
    std::vector<T> Values;
    bool& HasEnded;
    ~Kept() { this->HasEnded = true; }
  };

  /** Another one when it has ended. (Where this is inlined, compilers look for the thread's memory
   * at every use.) */
  [[gnu::noinline]] static std::vector<T>& GetOfThread(std::vector<T>& other)
  {
    thread_local bool hasEnded = false; // Has no destructor, after which it would be gone, too.
    thread_local Kept kept{ {}, hasEnded };
    return hasEnded ? other : kept.Values;
  }

  std::vector<T> Own;
  std::vector<T>& Values = GetOfThread(this->Own);
};
}

#endif
