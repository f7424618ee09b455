// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProcessGroup_h
#define ProcessGroup_h

#include "vtkMultiProcessController.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace hashedoctree
{
/**
 * The processes that hold the pieces of one data set and work on it together; often one alone. All
 * of them have to call the same members in the same order, and each then waits for the others: all
 * of that within Together(), so that what fails in one process is the end for all. Private to the
 * module.
 */
class ProcessGroup
{
public:
  /** One alone. */
  ProcessGroup() = default;
  /** Those of a controller, null for one alone. */
  explicit ProcessGroup(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  std::size_t GetNumber() const;
  /** Which of them this one is. */
  std::size_t GetRank() const;
  bool AreSeveral() const { return this->GetNumber() > 1; }
  bool IsFirst() const { return this->GetRank() == 0; }

  /** Runs what the processes do together. Where that throws in one process, it throws
   * std::runtime_error in the others, at the next time that they wait for each other. */
  template <typename Work>
  void Together(const Work& work) const
  {
    try
    {
      work();
    }
    catch (const FailedElsewhere&)
    {
      throw;
    }
    catch (...)
    {
      this->Agree(true);
      throw;
    }
    this->Agree(false);
  }

  ///@{
  /** Each value by those of all processes: their sum, the smallest, the largest. */
  void Sum(std::vector<std::uint64_t>& values) const;
  std::uint64_t Sum(std::uint64_t value) const;
  /** Whether something is true in all processes; throws std::invalid_argument, with this problem,
   * where it is in some of them only. */
  bool IsTrueInAll(bool here, const char* problem) const;
  void Min(double* values, std::size_t count) const;
  void Max(double* values, std::size_t count) const;
  ///@}

  /** The values that each of the processes has; `T` is a plain value of eight bytes. */
  template <typename T>
  std::vector<std::vector<T>> Gather(const std::vector<T>& values) const
  {
    return FromWords<T>(this->GatherWords(ToWords(values)));
  }
  /** Gives the values at index i to process i, and returns those that the processes have given to
   * this one, one process after the other. */
  template <typename T>
  std::vector<std::vector<T>> Exchange(const std::vector<std::vector<T>>& values) const
  {
    std::vector<Words> words(values.size());
    std::transform(values.begin(), values.end(), words.begin(), ToWords<T>);
    return FromWords<T>(this->ExchangeWords(words));
  }

private:
  /** What all processes know of. */
  struct FailedElsewhere : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };
  using Words = std::vector<unsigned long long>;

  template <typename T>
  static Words ToWords(const std::vector<T>& values)
  {
    static_assert(sizeof(T) == sizeof(unsigned long long) && std::is_trivially_copyable_v<T>);
    Words words(values.size());
    std::memcpy(words.data(), values.data(), values.size() * sizeof(T));
    return words;
  }
  template <typename T>
  static std::vector<std::vector<T>> FromWords(const std::vector<Words>& words)
  {
    std::vector<std::vector<T>> values;
    for (const Words& ofProcess : words)
    {
      values.emplace_back(ofProcess.size());
      std::memcpy(
        static_cast<void*>(values.back().data()), ofProcess.data(), ofProcess.size() * sizeof(T));
    }
    return values;
  }

  /** Waits for all, and throws FailedElsewhere if another one has failed and this one has not. */
  void Agree(bool hasFailed) const;
  template <typename Value>
  void Reduce(Value* values, std::size_t count, int operation) const;
  std::vector<Words> GatherWords(const Words& words) const;
  std::vector<Words> ExchangeWords(const std::vector<Words>& words) const;

  vtkMultiProcessController* Controller = nullptr;
};
}

#endif
