// SPDX-License-Identifier: BSD-3-Clause
#include "PointBatch.h"

#include "MakePointTree.h"
#include "OnThisThread.h"
#include "PointSamples.h"
#include "Sanitized.h"
#include "Threads.h"
#include "ToldProgress.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

namespace
{
constexpr std::size_t Few = 4000;    // Positions are taken as they come,
constexpr std::size_t Many = 150000; // and along the Morton curve.

/** A tree of uniform points, and positions to ask for, two of them nowhere. */
struct Batch
{
  std::vector<float> Coordinates;
  std::vector<double> Positions;
  PointTree<3, float> Tree;

  explicit Batch(std::size_t numberOfPoints, std::size_t numberOfPositions = 1500)
    : Coordinates(MakeUniformPoints<3, float>(numberOfPoints, 221))
    , Positions(MakeUniformPoints<3, double>(numberOfPositions, 222, -0.2, 1.2))
  {
    this->Positions[3 * 7] = NAN;
    this->Positions[3 * 700 + 2] = INFINITY;
    this->MakeTree();
  }
  void MakeTree()
  {
    this->Tree = MakePointTree(
      PointSpan<3, float>{ this->Coordinates.data(), this->Coordinates.size() / 3 }, 16);
  }
  PointSpan<3, double> GetSpan() const
  {
    return { this->Positions.data(), this->Positions.size() / 3 };
  }
};

/** What a batch finds is what single searches find, which are run for every so many positions. */
void ExpectClosest(
  const Batch& batch, std::size_t count, const Execution& execution, std::size_t every = 1)
{
  const std::size_t numberOfPositions = batch.GetSpan().Count;
  std::vector<long long> ids(numberOfPositions * count, 77);
  std::vector<double> dist2(numberOfPositions * count, 77.0);
  PointBatch(batch.Tree, execution).FindClosest(batch.GetSpan(), count, ids.data(), dist2.data());
  const PointSearch<3, float> search(batch.Tree);
  for (std::size_t i = 0; i < numberOfPositions; i += every)
  {
    std::vector<FoundPoint> found;
    search.FindClosest(GetPosition<3>(batch.GetSpan(), i), count, found);
    ASSERT_EQ(found.empty(), i == 7 || i == 700);
    for (std::size_t j = 0; j < count; ++j)
    {
      ASSERT_EQ(ids[i * count + j], found.empty() ? -1LL : found[j].Id);
      ASSERT_EQ(dist2[i * count + j], found.empty() ? INFINITY : found[j].Dist2);
    }
  }
}

void ExpectWithin(
  const Batch& batch, double radius, const Execution& execution, std::size_t every = 1)
{
  const std::size_t numberOfPositions = batch.GetSpan().Count;
  const auto lists = PointBatch(batch.Tree, execution).FindWithin(batch.GetSpan(), radius);
  std::vector<long long> offsets(numberOfPositions + 1);
  std::vector<long long> ids(lists.GetNumberOfPoints());
  std::vector<double> dist2(lists.GetNumberOfPoints());
  lists.CopyTo(offsets.data(), ids.data(), dist2.data());
  EXPECT_EQ(offsets[0], 0);
  EXPECT_EQ(static_cast<std::size_t>(offsets[numberOfPositions]), ids.size());
  const PointSearch<3, float> search(batch.Tree);
  for (std::size_t i = 0; i < numberOfPositions; i += every)
  {
    std::vector<FoundPoint> found;
    search.FindWithin(GetPosition<3>(batch.GetSpan(), i), radius, found);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(static_cast<std::size_t>(offsets[i + 1] - offsets[i]), found.size());
    for (std::size_t j = 0; j < found.size(); ++j)
    {
      const std::size_t place = static_cast<std::size_t>(offsets[i]) + j;
      ASSERT_EQ(ids[place], found[j].Id);
      ASSERT_EQ(dist2[place], found[j].Dist2);
    }
  }
}
}

TEST(TestPointBatch, FindsTheClosestThatSingleSearchesFind)
{
  for (const std::size_t numberOfPoints : { Few, Many })
  {
    const Batch batch(numberOfPoints);
    for (const unsigned threads : { 1U, 3U })
    {
      for (const std::size_t count : { 1U, 5U, 80U })
      {
        ExpectClosest(batch, count, Execution(OnThreads(threads)));
      }
    }
  }
}

TEST(TestPointBatch, FindsWithinWhatSingleSearchesFind)
{
  for (const std::size_t numberOfPoints : { Few, Many })
  {
    const Batch batch(numberOfPoints);
    for (const unsigned threads : { 1U, 3U })
    {
      ExpectWithin(batch, numberOfPoints == Few ? 0.1 : 0.03, Execution(OnThreads(threads)));
    }
  }
}

TEST(TestPointBatch, EquallyNearPointsComeByTheirIds)
{
  Batch batch(Few);
  for (float& coordinate : batch.Coordinates)
  {
    coordinate = std::round(8.0F * coordinate) / 8.0F;
  }
  for (double& coordinate : batch.Positions)
  {
    coordinate = std::round(16.0 * coordinate) / 16.0; // On points, and in the middle of some.
  }
  batch.MakeTree();
  ExpectClosest(batch, 30, Execution());
  ExpectWithin(batch, 0.25, Execution());
}

TEST(TestPointBatch, TakesMorePositionsThanAreOrderedAtATime)
{
  const Batch batch(Many, BatchOrder<3>::MostPositions + 900);
  constexpr std::size_t every = Sanitized ? 7 : 1; // Positions 7 and 700 are nowhere.
  ExpectClosest(batch, 1, Execution(OnThreads(2)), every);
  ExpectWithin(batch, 0.004, Execution(OnThreads(2)), every);
}

TEST(TestPointBatch, ProgressRisesFromOneOrderToTheNext)
{
  const Batch batch(Many, BatchOrder<3>::MostPositions + 200000);
  ToldProgress told;
  std::vector<long long> ids(batch.GetSpan().Count);
  std::vector<double> dist2(batch.GetSpan().Count);
  PointBatch(batch.Tree, told.MakeExecution())
    .FindClosest(batch.GetSpan(), 1, ids.data(), dist2.data());
  told.ExpectToRise(10);
}

TEST(TestPointBatch, ProgressOfListsEndsWithTheirCopies)
{
  const Batch batch(Few, BatchOrder<3>::MostPositions + 200000);
  ToldProgress told;
  const auto lists = PointBatch(batch.Tree, told.MakeExecution()).FindWithin(batch.GetSpan(), 0.1);
  const std::size_t toldWhileSearching = told.GetFractions().size();
  EXPECT_LT(told.GetFractions().back(), 0.9);
  std::vector<long long> offsets(batch.GetSpan().Count + 1);
  std::vector<long long> ids(lists.GetNumberOfPoints());
  std::vector<double> dist2(lists.GetNumberOfPoints());
  lists.CopyTo(offsets.data(), ids.data(), dist2.data());
  told.ExpectToRise(toldWhileSearching + 10);
  EXPECT_GT(told.GetFractions().back(), 0.999);
}

TEST(TestPointBatch, OfNoPositionsIsEmpty)
{
  const Batch batch(Few);
  const Execution execution;
  const PointSpan<3, double> none{ nullptr, 0 };
  PointBatch(batch.Tree, execution).FindClosest<double, long long>(none, 5, nullptr, nullptr);
  long long offset = 77;
  const auto lists = PointBatch(batch.Tree, execution).FindWithin(none, 1.0);
  lists.CopyTo<long long>(&offset, nullptr, nullptr);
  EXPECT_EQ(lists.GetNumberOfPoints(), 0U);
  EXPECT_EQ(offset, 0);
}

TEST(TestPointBatch, CanBeInterrupted)
{
  const Batch batch(Few);
  const PointBatch search(batch.Tree, MakeInterrupted());
  std::vector<long long> ids(1500);
  std::vector<double> dist2(1500);
  EXPECT_THROW(search.FindClosest(batch.GetSpan(), 1, ids.data(), dist2.data()), Interrupted);
  EXPECT_THROW(search.FindWithin(batch.GetSpan(), 0.1), Interrupted);
}

TEST(TestPointBatch, HeedsTheSignToStopBeforeEachSearch)
{
  const Batch batch(1000);
  StopSign::Count stops{ 0 };
  const PointBatch stopped(batch.Tree, Execution(OnThreads(3), {}, StopSign(stops)));
  ++stops;
  std::vector<long long> ids(batch.GetSpan().Count, 77);
  std::vector<double> dist2(batch.GetSpan().Count, 77.0);
  EXPECT_THROW(stopped.FindClosest(batch.GetSpan(), 1, ids.data(), dist2.data()), Interrupted);
  EXPECT_EQ(ids, std::vector<long long>(ids.size(), 77)) << "no search was made";
  EXPECT_THROW(stopped.FindWithin(batch.GetSpan(), 0.1), Interrupted);
}

TEST(TestPointBatch, HeedsTheSignToStopWhileListsAreCopied)
{
  const Batch batch(1000);
  StopSign::Count stops{ 0 };
  const PointBatch search(batch.Tree, Execution(OnThisThread, {}, StopSign(stops)));
  const auto lists = search.FindWithin(batch.GetSpan(), 0.1);
  std::vector<long long> offsets(batch.GetSpan().Count + 1);
  std::vector<long long> ids(lists.GetNumberOfPoints(), 77);
  std::vector<double> dist2(lists.GetNumberOfPoints());
  ++stops;
  EXPECT_THROW(lists.CopyTo(offsets.data(), ids.data(), dist2.data()), Interrupted);
  EXPECT_EQ(ids, std::vector<long long>(ids.size(), 77));
}
