// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadTeam.h"

#include <algorithm>
#include <utility>

namespace hashedoctree
{
void ThreadTeam::Run(
  const Execution& threads, std::size_t numberOfThreads, const Computation& computation)
{
  ThreadTeam team;
  threads.For(numberOfThreads, 1, [&](std::size_t, std::size_t) { team.Join(computation); });
  if (team.Error)
  {
    std::rethrow_exception(team.Error);
  }
}

void ThreadTeam::Join(const Computation& computation)
{
  bool leads = false;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    leads = !this->HasLeader;
    this->HasLeader = true;
  }
  leads ? this->Lead(computation) : this->Follow();
}

void ThreadTeam::Lead(const Computation& computation)
{
  std::exception_ptr error;
  try
  {
    computation(Execution(
      [this](std::size_t first, std::size_t last, std::size_t grain, const Execution::Body& body)
      { this->DoLoop(first, last, grain, body); }));
  }
  catch (...)
  {
    error = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Error = error;
  this->IsDone = true;
  this->Changed.notify_all();
}

void ThreadTeam::Follow()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->IsDone)
  {
    if (this->Next < this->Last)
    {
      ++this->Busy;
      this->DoParts(lock);
      --this->Busy;
      this->Changed.notify_all();
    }
    else
    {
      this->Changed.wait(lock);
    }
  }
}

void ThreadTeam::DoLoop(
  std::size_t first, std::size_t last, std::size_t grain, const Execution::Body& body)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Next = first;
  this->Last = last;
  this->Grain = grain;
  this->Body = &body;
  if (last - first > grain)
  {
    this->Changed.notify_all();
  }
  this->DoParts(lock);
  this->Changed.wait(lock, [this] { return this->Busy == 0; });
  if (this->Error)
  {
    std::rethrow_exception(std::exchange(this->Error, nullptr));
  }
}

void ThreadTeam::DoParts(std::unique_lock<std::mutex>& lock)
{
  while (this->Next < this->Last)
  {
    const std::size_t from = this->Next;
    const std::size_t to = std::min(this->Last, from + this->Grain);
    this->Next = to;
    lock.unlock();
    std::exception_ptr error;
    try
    {
      (*this->Body)(from, to);
    }
    catch (...)
    {
      error = std::current_exception();
    }
    lock.lock();
    if (error)
    {
      this->Error = this->Error ? this->Error : error;
      this->Next = this->Last; // The rest is of no use.
    }
  }
}
}
