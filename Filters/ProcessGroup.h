// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProcessGroup_h
#define ProcessGroup_h

#include "Parted.h"

#include "vtkMultiProcessController.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace hashedoctree
{
/**
 * The processes that hold the pieces of one data set and work on it together; often one alone. All
 * of them have to call the same members in the same order, each on the thread that updates the
 * filter, and each then waits for the others: all of that within Together(), so that what fails in
 * one process is the end for all. Private to the module.
 */
class ProcessGroup
{
public:
  /** One alone, with all of the data. */
  ProcessGroup() = default;
  /** Those of a controller, null for one alone. */
  explicit ProcessGroup(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  /** One alone with a part of the data: other processes, or other updates, have the rest. */
  static ProcessGroup OfPart()
  {
    ProcessGroup one;
    one.HasPart = true;
    return one;
  }

  /** Whether together they have all of the data. */
  bool HaveAll() const { return !this->HasPart; }
  std::size_t GetNumberOfProcesses() const;
  /** Which of them this one is. */
  std::size_t GetRank() const;
  bool AreSeveral() const { return this->GetNumberOfProcesses() > 1; }
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

  /** Whether something is true in all processes; throws std::invalid_argument, with this problem,
   * where it is in some of them only. */
  bool IsTrueInAll(bool here, const char* problem) const;

  ///@{
  /** Each value by those of all processes: their sum, the smallest, the largest. */
  void Sum(std::vector<std::uint64_t>& values) const;
  std::uint64_t Sum(std::uint64_t value) const;
  void Min(double* values, std::size_t count) const;
  void Max(double* values, std::size_t count) const;
  std::uint64_t Max(std::uint64_t value) const;
  ///@}

  /** The values that each of the processes has, by process. Throws std::length_error for more than
   * MPI can send at a time. */
  template <typename T>
  Parted<T> Gather(const std::vector<T>& values) const
  {
    Parted<T> gathered;
    gathered.Counts = this->GatherCounts({ values.size() });
    gathered.Values.resize(GetSendable(gathered.Counts));
    this->GatherValues(GetNumbers(values), GetNumbers(gathered.Values), gathered.Counts);
    return gathered;
  }

  /** Gives each process its part of the values, and returns those that the processes have given to
   * this one, by process. Throws as Gather(). */
  template <typename T>
  Parted<T> Exchange(const Parted<T>& values) const
  {
    const Counts ofAll = this->GatherCounts(values.Counts);
    Parted<T> taken;
    taken.Counts = this->GetTaken(ofAll);
    taken.Values.resize(GetSendable(taken.Counts));
    this->ExchangeValues(
      GetNumbers(values.Values), values.Counts, GetNumbers(taken.Values), taken.Counts);
    return taken;
  }

private:
  /** What all processes know of. */
  struct FailedElsewhere : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };
  using Counts = std::vector<std::size_t>;

  ///@{
  /** Values as the numbers that they consist of: VTK sends numbers. */
  template <typename T>
  static const std::uint64_t* GetNumbers(const std::vector<T>& values)
  {
    static_assert(sizeof(T) == sizeof(std::uint64_t) && std::is_standard_layout_v<T> &&
        std::is_trivially_copyable_v<T>,
      "a number with a name");
    return reinterpret_cast<const std::uint64_t*>(values.data());
  }
  template <typename T>
  static std::uint64_t* GetNumbers(std::vector<T>& values)
  {
    return const_cast<std::uint64_t*>(GetNumbers(std::as_const(values)));
  }
  ///@}

  /** Waits for all, and throws FailedElsewhere if another one has failed and this one has not. */
  void Agree(bool hasFailed) const;
  template <typename Value>
  void Reduce(Value* values, std::size_t count, int operation) const;

  /** The counts of all processes, one process after the other. */
  Counts GatherCounts(const Counts& counts) const;
  /** What each process gives to this one, given what each gives to each. */
  Counts GetTaken(const Counts& ofAll) const;
  /** The sum of the counts. Throws std::length_error where that is more than can be sent. */
  static std::size_t GetSendable(const Counts& counts);
  void GatherValues(
    const std::uint64_t* own, std::uint64_t* gathered, const Counts& gatheredCounts) const;
  void ExchangeValues(const std::uint64_t* given, const Counts& givenCounts, std::uint64_t* taken,
    const Counts& takenCounts) const;

  vtkMultiProcessController* Controller = nullptr;
  bool HasPart = false;
};
}

#endif
