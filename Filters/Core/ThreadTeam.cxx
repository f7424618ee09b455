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
    if (this->First < this->Last)
    {
      ++this->Busy;
      this->DoParts(lock, Side::Back);
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
  this->First = first;
  this->Last = last;
  this->Grain = grain;
  this->Body = &body;
  if (last - first > grain)
  {
    this->Changed.notify_all();
  }
  this->DoParts(lock, Side::Front);
  this->Changed.wait(lock, [this] { return this->Busy == 0; });
  if (this->Error)
  {
    std::rethrow_exception(std::exchange(this->Error, nullptr));
  }
}

void ThreadTeam::DoParts(std::unique_lock<std::mutex>& lock, Side side)
{
  while (this->First < this->Last)
  {
    const Part part = this->TakePart(side);
    lock.unlock();
    std::exception_ptr error;
    try
    {
      (*this->Body)(part.First, part.Last);
    }
    catch (...)
    {
      error = std::current_exception();
    }
    lock.lock();
    if (error)
    {
      this->Error = this->Error ? this->Error : error;
      this->First = this->Last; // The rest is of no use.
    }
  }
}

ThreadTeam::Part ThreadTeam::TakePart(Side side)
{
  const std::size_t count = this->Last - this->First;
  if (side == Side::Front)
  {
    const std::size_t first = this->First;
    this->First += std::min(count, this->Grain);
    return { first, this->First };
  }
  const std::size_t last = this->Last;
  this->Last = this->First + (count - 1) / this->Grain * this->Grain; // The short part is the last.
  return { this->Last, last };
}
}
