// SPDX-License-Identifier: BSD-3-Clause
#include "PointBatch.h"

#include "PointSamples.h"
#include "Threads.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

namespace
{
/** A tree of uniform points, and positions to ask for, two of them nowhere. */
struct Batch
{
  std::vector<float> Coordinates = MakeUniformPoints<3, float>(4000, 221);
  std::vector<double> Positions = MakeUniformPoints<3, double>(1500, 222, -0.2, 1.2);
  PointTree<3, float> Tree;

  Batch()
  {
    this->Positions[3 * 7] = NAN;
    this->Positions[3 * 700 + 2] = INFINITY;
    const PointSpan<3, float> points{ this->Coordinates.data(), 4000 };
    this->Tree = PointTree<3, float>(
      points, PointSelection<3>(points, {}, Execution()), { 16, 21 }, Execution());
  }
  PointSpan<3, double> GetSpan() const { return { this->Positions.data(), 1500 }; }
  Position<3> GetPosition(std::size_t i) const
  {
    return { this->GetSpan()[i][0], this->GetSpan()[i][1], this->GetSpan()[i][2] };
  }
};
}

TEST(TestPointBatch, FindsTheClosestThatSingleSearchesFind)
{
  const Batch batch;
  const PointSearch<3, float> search(batch.Tree);
  for (const unsigned threads : { 1U, 3U })
  {
    const Execution execution(OnThreads(threads));
    for (const std::size_t count : { 1U, 5U, 80U })
    {
      std::vector<long long> ids(1500 * count, 77);
      std::vector<double> dist2(1500 * count, 77.0);
      PointBatch(batch.Tree, execution)
        .FindClosest(batch.GetSpan(), count, ids.data(), dist2.data());
      for (std::size_t i = 0; i < 1500; ++i)
      {
        std::vector<FoundPoint> found;
        search.FindClosest(batch.GetPosition(i), count, found);
        EXPECT_EQ(found.empty(), i == 7 || i == 700);
        for (std::size_t j = 0; j < count; ++j)
        {
          ASSERT_EQ(ids[i * count + j], found.empty() ? -1LL : found[j].Id);
          ASSERT_EQ(dist2[i * count + j], found.empty() ? INFINITY : found[j].Dist2);
        }
      }
    }
  }
}

TEST(TestPointBatch, FindsWithinWhatSingleSearchesFind)
{
  const Batch batch;
  const PointSearch<3, float> search(batch.Tree);
  for (const unsigned threads : { 1U, 3U })
  {
    const Execution execution(OnThreads(threads));
    const auto lists = PointBatch(batch.Tree, execution).FindWithin(batch.GetSpan(), 0.1);
    std::vector<long long> offsets(1501);
    std::vector<long long> ids(lists.GetNumberOfPoints());
    std::vector<double> dist2(lists.GetNumberOfPoints());
    lists.CopyTo(offsets.data(), ids.data(), dist2.data());
    EXPECT_EQ(offsets[0], 0);
    EXPECT_EQ(static_cast<std::size_t>(offsets[1500]), ids.size());
    for (std::size_t i = 0; i < 1500; ++i)
    {
      std::vector<FoundPoint> found;
      search.FindWithin(batch.GetPosition(i), 0.1, found);
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

TEST(TestPointBatch, CanBeInterrupted)
{
  const Batch batch;
  const Execution execution(OnThreads(1), [](double) { return false; });
  const PointBatch search(batch.Tree, execution);
  std::vector<long long> ids(1500);
  std::vector<double> dist2(1500);
  EXPECT_THROW(search.FindClosest(batch.GetSpan(), 1, ids.data(), dist2.data()), Interrupted);
  EXPECT_THROW(search.FindWithin(batch.GetSpan(), 0.1), Interrupted);
}
