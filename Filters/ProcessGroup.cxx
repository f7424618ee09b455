// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessGroup.h"

#include "vtkCommunicator.h"

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

/** Where the values of each process begin when they stand one after the other. */
std::vector<vtkIdType> GetOffsets(const std::vector<vtkIdType>& lengths)
{
  std::vector<vtkIdType> offsets(lengths.size(), 0);
  std::partial_sum(lengths.begin(), lengths.end() - 1, offsets.begin() + 1);
  return offsets;
}

template <typename Word>
std::vector<std::vector<Word>> Split(
  const std::vector<Word>& all, const std::vector<vtkIdType>& lengths)
{
  std::vector<std::vector<Word>> parts;
  auto begin = all.begin();
  for (const vtkIdType length : lengths)
  {
    parts.emplace_back(begin, begin + length);
    begin += length;
  }
  return parts;
}
}

std::size_t ProcessGroup::GetNumber() const
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
  Words words = ToWords(values);
  this->Reduce(words.data(), words.size(), vtkCommunicator::SUM_OP);
  values.assign(words.begin(), words.end());
}

std::uint64_t ProcessGroup::Sum(std::uint64_t value) const
{
  std::vector<std::uint64_t> values{ value };
  this->Sum(values);
  return values.front();
}

bool ProcessGroup::IsTrueInAll(bool here, const char* problem) const
{
  const std::uint64_t number = this->Sum(here ? 1 : 0);
  if (number > 0 && number < this->GetNumber())
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

std::vector<ProcessGroup::Words> ProcessGroup::GatherWords(const Words& words) const
{
  if (this->Controller == nullptr)
  {
    return { words };
  }
  std::vector<vtkIdType> lengths(this->GetNumber());
  const auto own = static_cast<vtkIdType>(words.size());
  this->Agree(false);
  Require(this->Controller->AllGather(&own, lengths.data(), 1));
  std::vector<vtkIdType> offsets = GetOffsets(lengths);
  Words all(static_cast<std::size_t>(offsets.back() + lengths.back()));
  this->Agree(false);
  Require(
    this->Controller->AllGatherV(words.data(), all.data(), own, lengths.data(), offsets.data()));
  return Split(all, lengths);
}

std::vector<ProcessGroup::Words> ProcessGroup::ExchangeWords(const std::vector<Words>& words) const
{
  if (this->Controller == nullptr)
  {
    return words;
  }
  std::vector<vtkIdType> ownLengths(words.size());
  std::transform(words.begin(), words.end(), ownLengths.begin(),
    [](const Words& ofProcess) { return static_cast<vtkIdType>(ofProcess.size()); });
  const auto number = static_cast<vtkIdType>(words.size());
  std::vector<vtkIdType> allLengths(words.size() * words.size()); // By giver, then by taker.
  this->Agree(false);
  Require(this->Controller->AllGather(ownLengths.data(), allLengths.data(), number));

  std::vector<vtkIdType> lengths;
  for (std::size_t giver = 0; giver < words.size(); ++giver)
  {
    lengths.push_back(allLengths[giver * words.size() + this->GetRank()]);
  }
  std::vector<vtkIdType> offsets = GetOffsets(lengths);
  Words all(static_cast<std::size_t>(offsets.back() + lengths.back()));
  this->Agree(false);
  for (std::size_t taker = 0; taker < words.size(); ++taker)
  {
    Require(this->Controller->GatherV(words[taker].data(), all.data(), ownLengths[taker],
      lengths.data(), offsets.data(), static_cast<int>(taker)));
  }
  return Split(all, lengths);
}
}
