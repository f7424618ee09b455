// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadTeam.h"

#include "OnThisThread.h"
#include "Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace hashedoctree;

namespace
{
constexpr std::size_t NumberOfLoops = 200;

/** Two, and eight, at a time, and one after the other in the calling thread. */
std::vector<Execution> MakeExecutions()
{
  return { Execution(), Execution(OnThisThread), Execution(OnThreads(2)), Execution(OnThreads(8)) };
}

/** Where two threads wait for each other; who comes again does not. */
class Meeting
{
public:
  void Come()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Threads.insert(std::this_thread::get_id());
    this->Changed.notify_all();
    this->Changed.wait_for(
      lock, std::chrono::seconds(20), [this] { return this->Threads.size() == 2; });
  }
  bool HasHappened() const { return this->Threads.size() == 2; }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::set<std::thread::id> Threads;
};
}

TEST(TestThreadTeam, LoopsDoEachPartOnceOneAfterTheOther)
{
  for (const Execution& threads : MakeExecutions())
  {
    for (std::size_t numberOfThreads = 1; numberOfThreads <= 8; ++numberOfThreads)
    {
      std::vector<std::size_t> values(97, 0);
      int runs = 0;
      ThreadTeam::Run(threads, numberOfThreads,
        [&](const Execution& execution)
        {
          ++runs;
          for (std::size_t loop = 0; loop < NumberOfLoops; ++loop)
          {
            execution.For(values.size(), 1 + loop % 7,
              [&values, loop](std::size_t first, std::size_t last)
              {
                ASSERT_EQ(last - first, std::min(1 + loop % 7, values.size() - first));
                for (std::size_t i = first; i < last; ++i)
                {
                  // Only in order: each loop must be over when the next one begins.
                  values[i] = values[i] == loop ? loop + 1 : NumberOfLoops + 1;
                }
              });
            execution.For(0, 1, [&runs](std::size_t, std::size_t) { ++runs; });
          }
        });
      EXPECT_EQ(runs, 1);
      EXPECT_EQ(values, std::vector<std::size_t>(values.size(), NumberOfLoops));
    }
  }
}

TEST(TestThreadTeam, OthersHelpTheLeader)
{
  ThreadTeam::Run(Execution(OnThreads(2)), 2,
    [&](const Execution& execution)
    {
      for (const char* loop : { "first", "second" })
      {
        Meeting meeting;
        execution.For(2, 1, [&meeting](std::size_t, std::size_t) { meeting.Come(); });
        EXPECT_TRUE(meeting.HasHappened()) << loop;
        // Now the other one waits for the next loop, and must be told of it.
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    });
}

TEST(TestThreadTeam, TheLeaderBeginsAtTheFrontTheOthersAtTheBack)
{
  using Parts = std::vector<std::pair<std::size_t, std::size_t>>;
  ThreadTeam::Run(Execution(OnThreads(2)), 2,
    [&](const Execution& execution)
    {
      const std::thread::id leader = std::this_thread::get_id();
      for (int loop = 0; loop < 3; ++loop)
      {
        Meeting meeting;
        Parts front;
        Parts back;
        execution.For(11, 2,
          [&](std::size_t first, std::size_t last)
          {
            meeting.Come();
            (std::this_thread::get_id() == leader ? front : back).emplace_back(first, last);
          });
        ASSERT_TRUE(meeting.HasHappened());
        EXPECT_EQ(front.front(), Parts::value_type(0, 2));
        EXPECT_EQ(back.front(), Parts::value_type(10, 11));
        EXPECT_TRUE(std::is_sorted(front.begin(), front.end()));
        EXPECT_TRUE(std::is_sorted(back.rbegin(), back.rend()));
        EXPECT_EQ(front.back().second, back.back().first);
      }
    });
}

TEST(TestThreadTeam, ALoopEndsWithTheLastOfItsParts)
{
  std::atomic<bool> hasBegun{ false };
  std::atomic<bool> hasEnded{ false };
  ThreadTeam::Run(Execution(OnThreads(2)), 2,
    [&](const Execution& execution)
    {
      const std::thread::id own = std::this_thread::get_id();
      execution.For(2, 1,
        [&](std::size_t, std::size_t)
        {
          if (std::this_thread::get_id() == own)
          {
            while (!hasBegun)
            {
              std::this_thread::yield();
            }
            return;
          }
          hasBegun = true;
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
          hasEnded = true;
        });
      EXPECT_TRUE(hasEnded);
    });
}

TEST(TestThreadTeam, WhatIsThrownComesBack)
{
  for (const Execution& threads : MakeExecutions())
  {
    for (std::size_t place = 0; place < 10; ++place)
    {
      bool goesOn = false;
      const auto run = [&]
      {
        ThreadTeam::Run(threads, 4,
          [&](const Execution& execution)
          {
            execution.For(10, 1,
              [place](std::size_t first, std::size_t last)
              {
                if (first <= place && place < last)
                {
                  throw std::runtime_error("part " + std::to_string(place));
                }
              });
            goesOn = true;
          });
      };
      EXPECT_THROW(run(), std::runtime_error);
      EXPECT_FALSE(goesOn);
    }
    EXPECT_THROW(ThreadTeam::Run(threads, 4,
                   [](const Execution&) { throw std::invalid_argument("computation"); }),
      std::invalid_argument);
  }
}

TEST(TestThreadTeam, AnErrorLeavesOutTheRestOfALoop)
{
  int parts = 0;
  const auto run = [&parts]
  {
    ThreadTeam::Run(Execution(), 1,
      [&parts](const Execution& execution)
      {
        execution.For(100, 1,
          [&parts](std::size_t, std::size_t)
          {
            ++parts;
            throw std::runtime_error("a part");
          });
      });
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_EQ(parts, 1);
}

TEST(TestThreadTeam, OfTwoErrorsTheFirstComesBack)
{
  std::atomic<int> begun{ 0 };
  const auto failInTurns = [&begun](std::size_t, std::size_t)
  {
    const bool isFirst = begun++ == 0;
    while (begun < 2)
    {
      std::this_thread::yield();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(isFirst ? 0 : 500));
    throw std::runtime_error(isFirst ? "first" : "second");
  };
  try
  {
    ThreadTeam::Run(Execution(OnThreads(2)), 2,
      [&failInTurns](const Execution& execution) { execution.For(2, 1, failInTurns); });
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), "first");
  }
}

TEST(TestThreadTeam, AComputationMayGoOnAfterAnError)
{
  std::atomic<int> parts{ 0 };
  ThreadTeam::Run(Execution(OnThreads(4)), 4,
    [&parts](const Execution& execution)
    {
      const auto fail = [](std::size_t, std::size_t) { throw std::runtime_error("no"); };
      EXPECT_THROW(execution.For(3, 1, fail), std::runtime_error);
      execution.For(
        5, 1, [&parts](std::size_t first, std::size_t last) { parts += int(last - first); });
    });
  EXPECT_EQ(parts, 5);
}

TEST(TestThreadTeam, TeamsWorkWithinLoopsOfOthers)
{
  std::atomic<std::size_t> sum{ 0 };
  Execution(OnThreads(3))
    .For(12, 1,
      [&sum](std::size_t, std::size_t)
      {
        ThreadTeam::Run(Execution(OnThreads(2)), 2,
          [&sum](const Execution& execution) {
            execution.For(
              100, 3, [&sum](std::size_t first, std::size_t last) { sum += last - first; });
          });
      });
  EXPECT_EQ(sum, 1200U);
}
