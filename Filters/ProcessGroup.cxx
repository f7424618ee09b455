// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessGroup.h"

#include "vtkCommunicator.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace hashedoctree
{
namespace
{
void Require(int done)
{
  if (done == 0)
  {
    throw std::runtime_error("The processes cannot exchange data; see what MPI says.");
  }
}

std::vector<vtkIdType> ToIds(const std::vector<std::size_t>& counts)
{
  return { counts.begin(), counts.end() };
}

/** Where the values of each process begin when they stand one after the other. */
std::vector<vtkIdType> GetBegins(const std::vector<std::size_t>& counts)
{
  return ToIds(Parted<std::uint64_t>{ {}, counts }.GetBegins());
}
}

std::size_t ProcessGroup::GetNumberOfProcesses() const
{
  return this->Controller != nullptr
    ? static_cast<std::size_t>(this->Controller->GetNumberOfProcesses())
    : 1;
}

std::size_t ProcessGroup::GetRank() const
{
  return this->Controller != nullptr
    ? static_cast<std::size_t>(this->Controller->GetLocalProcessId())
    : 0;
}

void ProcessGroup::Agree(bool hasFailed) const
{
  if (this->Controller == nullptr)
  {
    return;
  }
  const int own = hasFailed ? 1 : 0;
  int failures = 0;
  Require(this->Controller->AllReduce(&own, &failures, 1, vtkCommunicator::MAX_OP));
  if (failures > 0 && !hasFailed)
  {
    throw FailedElsewhere("Another process has failed, or was stopped; see what it says.");
  }
}

template <typename Value>
void ProcessGroup::Reduce(Value* values, std::size_t count, int operation) const
{
  if (this->Controller != nullptr)
  {
    const std::vector<Value> own(values, values + count);
    this->Agree(false);
    Require(
      this->Controller->AllReduce(own.data(), values, static_cast<vtkIdType>(count), operation));
  }
}

void ProcessGroup::Sum(std::vector<std::uint64_t>& values) const
{
  this->Reduce(values.data(), values.size(), vtkCommunicator::SUM_OP);
}

std::uint64_t ProcessGroup::Sum(std::uint64_t value) const
{
  this->Reduce(&value, 1, vtkCommunicator::SUM_OP);
  return value;
}

std::uint64_t ProcessGroup::Max(std::uint64_t value) const
{
  this->Reduce(&value, 1, vtkCommunicator::MAX_OP);
  return value;
}

bool ProcessGroup::IsTrueInAll(bool here, const char* problem) const
{
  const std::uint64_t number = this->Sum(here ? 1 : 0);
  if (number > 0 && number < this->GetNumberOfProcesses())
  {
    throw std::invalid_argument(problem);
  }
  return here;
}

void ProcessGroup::Min(double* values, std::size_t count) const
{
  this->Reduce(values, count, vtkCommunicator::MIN_OP);
}

void ProcessGroup::Max(double* values, std::size_t count) const
{
  this->Reduce(values, count, vtkCommunicator::MAX_OP);
}

ProcessGroup::Counts ProcessGroup::GatherCounts(const Counts& counts) const
{
  if (this->Controller == nullptr)
  {
    return counts;
  }
  const std::vector<vtkIdType> own = ToIds(counts);
  std::vector<vtkIdType> all(counts.size() * this->GetNumberOfProcesses());
  this->Agree(false);
  Require(this->Controller->AllGather(own.data(), all.data(), static_cast<vtkIdType>(own.size())));
  return { all.begin(), all.end() };
}

ProcessGroup::Counts ProcessGroup::GetTaken(const Counts& ofAll) const
{
  Counts taken;
  for (std::size_t taker = this->GetRank(); taker < ofAll.size();
       taker += this->GetNumberOfProcesses())
  {
    taken.push_back(ofAll[taker]);
  }
  return taken;
}

std::size_t ProcessGroup::GetSendable(const Counts& counts)
{
  const std::size_t sum = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  if (sum > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw std::length_error("A process would get more than MPI can send at a time; run more "
                            "processes.");
  }
  return sum;
}

void ProcessGroup::GatherValues(
  const std::uint64_t* own, std::uint64_t* gathered, const Counts& gatheredCounts) const
{
  const std::size_t ownCount = gatheredCounts[this->GetRank()];
  if (this->Controller == nullptr)
  {
    std::copy_n(own, ownCount, gathered);
    return;
  }
  std::vector<vtkIdType> counts = ToIds(gatheredCounts);
  std::vector<vtkIdType> begins = GetBegins(gatheredCounts);
  this->Agree(false);
  Require(this->Controller->AllGatherV(
    own, gathered, static_cast<vtkIdType>(ownCount), counts.data(), begins.data()));
}

void ProcessGroup::ExchangeValues(const std::uint64_t* given, const Counts& givenCounts,
  std::uint64_t* taken, const Counts& takenCounts) const
{
  if (this->Controller == nullptr)
  {
    std::copy_n(given, givenCounts.front(), taken);
    return;
  }
  std::vector<vtkIdType> counts = ToIds(takenCounts);
  std::vector<vtkIdType> begins = GetBegins(takenCounts);
  this->Agree(false);
  for (std::size_t taker = 0; taker < givenCounts.size(); ++taker)
  {
    const auto count = static_cast<vtkIdType>(givenCounts[taker]);
    Require(this->Controller->GatherV(
      given, taken, count, counts.data(), begins.data(), static_cast<int>(taker)));
    given += count;
  }
}
}
