// SPDX-License-Identifier: BSD-3-Clause
#include "BatchOrder.h"

#include "MakePointTree.h"
#include "OnThisThread.h"
#include "PointSamples.h"
#include "Threads.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace hashedoctree;

class TestBatchOrder : public ::testing::Test
{
protected:
  static PointTree<3, double> MakeTree(std::size_t numberOfPoints)
  {
    const std::vector<double> points = MakeUniformPoints<3, double>(numberOfPoints, 231);
    return MakePointTree(PointSpan<3, double>{ points.data(), numberOfPoints }, 64);
  }

  static std::vector<std::size_t> GetOrder(const PointTree<3, double>& tree,
    const std::vector<double>& positions, std::size_t first, std::size_t last,
    const Execution& execution = Execution())
  {
    const PointSpan<3, double> span{ positions.data(), positions.size() / 3 };
    const BatchOrder<3> order(tree, span, first, last, execution);
    std::vector<std::size_t> places(order.GetCount());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      places[i] = order[i];
    }
    return places;
  }

  static std::vector<std::size_t> GetAsTheyCome(std::size_t first, std::size_t last)
  {
    std::vector<std::size_t> places(last - first);
    std::iota(places.begin(), places.end(), first);
    return places;
  }

  static constexpr std::size_t Many = 100000;
  PointTree<3, double> Large = MakeTree(Many);
  std::vector<double> Positions = MakeUniformPoints<3, double>(20000, 232, -0.2, 1.2);
};

TEST_F(TestBatchOrder, GoesAlongTheMortonCurve)
{
  this->Positions[3 * 400] = NAN;
  this->Positions[3 * 401 + 1] = -INFINITY;
  for (const unsigned threads : { 1U, 3U })
  {
    std::vector<std::size_t> order =
      GetOrder(this->Large, this->Positions, 300, 19000, Execution(OnThreads(threads)));
    std::uint64_t before = 0;
    for (const std::size_t i : order)
    {
      // Some hundred positions share a cell at this depth.
      const std::uint64_t cell =
        this->Large.GetOctree().GetGrid().GetKey(&this->Positions[3 * i]).AtDepth(2).GetValue();
      EXPECT_LE(before, cell);
      before = cell;
    }
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, GetAsTheyCome(300, 19000));
  }
}

TEST_F(TestBatchOrder, LeavesPositionsAsTheyComeInASmallTree)
{
  EXPECT_EQ(GetOrder(MakeTree(5000), this->Positions, 300, 19000), GetAsTheyCome(300, 19000));
}

TEST_F(TestBatchOrder, LeavesPositionsAsTheyComeWhereTheyAreTogether)
{
  for (std::size_t i = 0; i < this->Positions.size(); ++i)
  {
    this->Positions[i] = static_cast<double>(i) / static_cast<double>(this->Positions.size());
  }
  EXPECT_EQ(GetOrder(this->Large, this->Positions, 0, 20000), GetAsTheyCome(0, 20000));
  EXPECT_EQ(GetOrder(this->Large, this->Positions, 5, 6), GetAsTheyCome(5, 6));
  EXPECT_TRUE(GetOrder(this->Large, this->Positions, 5, 5).empty());
}

TEST_F(TestBatchOrder, CanBeInterrupted)
{
  EXPECT_THROW(GetOrder(this->Large, this->Positions, 0, 20000, MakeInterrupted()), Interrupted);
}
