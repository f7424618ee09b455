// SPDX-License-Identifier: BSD-3-Clause
#include "Execution.h"

#include "OnThisThread.h"
#include "Threads.h"
#include "ToldProgress.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

using namespace hashedoctree;

TEST(TestExecution, ForCoversTheRangeOnce)
{
  for (const std::size_t count : { 0U, 1U, 99U, 64000U, 64001U })
  {
    std::vector<std::atomic<int>> visits(count);
    Execution(OnThreads(3))
      .For(count, 100,
        [&](std::size_t first, std::size_t last)
        {
          for (std::size_t i = first; i < last; ++i)
          {
            ++visits[i];
          }
        });
    for (const std::atomic<int>& visit : visits)
    {
      ASSERT_EQ(visit, 1);
    }
  }
}

TEST(TestExecution, ForEachCallsForEachOnce)
{
  for (const std::size_t count : { 0U, 1U, 99U, 64000U, 64001U })
  {
    std::vector<std::atomic<int>> visits(count);
    Execution(OnThreads(3)).ForEach(count, 100, [&](std::size_t i) { ++visits.at(i); });
    for (const std::atomic<int>& visit : visits)
    {
      ASSERT_EQ(visit, 1);
    }
  }
}

TEST(TestExecution, ForChunksCallsForEachChunkOnce)
{
  EXPECT_EQ(Execution::GetNumberOfChunks(0, 100), 0U);
  EXPECT_EQ(Execution::GetNumberOfChunks(100, 100), 1U);
  EXPECT_EQ(Execution::GetNumberOfChunks(101, 100), 2U);
  for (const std::size_t count : { 0U, 1U, 99U, 64000U, 64001U })
  {
    std::vector<std::pair<std::size_t, std::size_t>> chunks(
      Execution::GetNumberOfChunks(count, 100));
    std::atomic<std::size_t> calls = 0;
    double told = 0.0;
    const Execution execution(OnThreads(3),
      [&told](double fraction)
      {
        told = fraction;
        return true;
      });
    execution.ForChunks(count, 100,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      {
        ++calls;
        chunks.at(chunk) = { first, last };
      });
    EXPECT_EQ(calls, chunks.size());
    EXPECT_EQ(told, count == 0 ? 0.0 : 1.0);
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
    {
      ASSERT_EQ(chunks[chunk].first, chunk * 100);
      ASSERT_EQ(chunks[chunk].second, std::min<std::size_t>(count, chunk * 100 + 100));
    }
  }
}

TEST(TestExecution, WhatChunksReturnIsInTheirOrder)
{
  for (const unsigned threads : { 1U, 8U })
  {
    const Execution execution(OnThreads(threads));
    EXPECT_TRUE(execution.MapChunks(0, 7, [](std::size_t, std::size_t) { return 1; }).empty());
    const auto counts = execution.MapChunks(
      1000, 7, [](std::size_t first, std::size_t last) { return last - first; });
    ASSERT_EQ(counts.size(), 143U);
    EXPECT_TRUE(
      std::all_of(counts.begin(), counts.end() - 1, [](std::size_t count) { return count == 7; }));
    EXPECT_EQ(counts.back(), 6U);
    const auto firsts =
      execution.MapChunks(1000, 7, [](std::size_t first, std::size_t) { return first; });
    EXPECT_TRUE(std::is_sorted(firsts.begin(), firsts.end()));
    EXPECT_EQ(firsts.back(), 994U);
  }
}

TEST(TestExecution, OneThreadAsksForNoOthers)
{
  const Execution execution([](std::size_t, std::size_t, std::size_t, const Execution::Body&)
    { ADD_FAILURE() << "other threads were asked for"; });
  std::size_t calls = 0;
  execution.OnOneThread().ForEach(1000, 1, [&calls](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 1000U);
}

TEST(TestExecution, WhatAnyThreadThrowsComesOut)
{
  // The calling thread waits for another one to throw.
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> thrown{ false };
  EXPECT_THROW(Execution(OnThreads(2))
                 .ForEach(2, 1,
                   [&](std::size_t)
                   {
                     while (std::this_thread::get_id() == caller && !thrown)
                     {
                       std::this_thread::yield();
                     }
                     if (!thrown.exchange(true))
                     {
                       throw std::length_error("of the other thread");
                     }
                   }),
    std::length_error);
}

TEST(TestExecution, ProgressRisesFromPartToPart)
{
  ToldProgress progress;
  const Execution execution = progress.MakeExecution();
  const auto nothing = [](std::size_t, std::size_t) {};
  execution.Part(0.0, 0.25).For(10000, 10, nothing);
  execution.Part(0.25, 1.0).Part(0.5, 1.0).For(10000, 10, nothing);
  progress.ExpectToRise(21);
  const std::vector<double>& told = progress.GetFractions();
  EXPECT_NEAR(*std::lower_bound(told.begin(), told.end(), 0.25), 0.25, 1e-12);
  EXPECT_GT(*std::upper_bound(told.begin(), told.end(), 0.26), 0.625) << "the 0.5 of the second";
  EXPECT_NEAR(told.back(), 1.0, 1e-12);
}

TEST(TestExecution, StopsWithinABatch)
{
  for (const std::size_t threads : { 1U, 2U, 64U })
  {
    int answers = 0;
    std::size_t done = 0;
    const Execution execution(
      OnThisThread, [&answers](double) { return ++answers < 3; }, {}, threads);
    for (const Execution& part : { execution, execution.Part(0.0, 0.5) })
    {
      answers = 0;
      done = 0;
      EXPECT_THROW(part.For(1000000, 10,
                     [&done](std::size_t first, std::size_t last) { done += last - first; }),
        Interrupted);
      EXPECT_EQ(done, 3 * 10 * (threads == 64 ? 512 : 32)) << "enough for all threads";
    }
  }
}

TEST(TestExecution, WithoutProgressNothingStops)
{
  EXPECT_NO_THROW(Execution().Part(0.5, 1.0).Tell(0.3));
}

TEST(TestExecution, APartEndsWhereTheNextOneBegins)
{
  ToldProgress told;
  const Execution execution = told.MakeExecution();
  // In doubles 0.3 + (0.9 - 0.3) is more than 0.9.
  execution.Part(0.3, 0.9).Tell(1.0);
  execution.Part(0.9, 1.0).Tell(0.0);
  told.ExpectToRise(1);
}

TEST(TestExecution, AllPartsHeedTheSignToStop)
{
  StopSign::Count stops{ 5 };
  const Execution execution(OnThisThread, {}, StopSign(stops));
  const Execution reporting(
    OnThisThread, [](double) { return true; }, StopSign(stops));
  const Execution parts[] = { execution, execution.Part(0.0, 0.5), reporting.Part(0.5, 1.0),
    reporting.OnOneThread() };
  for (const Execution& part : parts)
  {
    EXPECT_NO_THROW(part.HeedStop());
  }
  ++stops;
  for (const Execution& part : parts)
  {
    EXPECT_THROW(part.HeedStop(), Interrupted);
  }
  EXPECT_NO_THROW(Execution(OnThisThread, {}, StopSign(stops)).HeedStop()) << "begins after it";
  EXPECT_NO_THROW(Execution().HeedStop());
}
