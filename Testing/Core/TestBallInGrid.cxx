// SPDX-License-Identifier: BSD-3-Clause
#include "BallInGrid.h"

#include "Dimensions.h"

#include <limits>
#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestBallInGrid : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestBallInGrid, Dimensions);

TYPED_TEST(TestBallInGrid, EveryPointInTheBallIsBetweenItsCorners)
{
  constexpr int dim = TypeParam::value;
  using Key = MortonKey<dim>;
  std::mt19937_64 random(171);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const double side : { 1e-300, 1e-9, 1.0, 1e30 })
  {
    Position<dim> lower;
    Position<dim> upper;
    lower.fill(-0.3 * side);
    upper.fill(0.7 * side);
    const Grid<dim> grid(Box<dim>(lower, upper));
    for (int trial = 0; trial < 500; ++trial)
    {
      // Centers in the root and beside it, balls of all sizes.
      Position<dim> center;
      Position<dim> point;
      double dist2 = 0.0;
      for (int axis = 0; axis < dim; ++axis)
      {
        center[axis] = side * (3.0 * uniform(random) - 1.5);
        point[axis] = side * (uniform(random) - 0.3);
        dist2 += (point[axis] - center[axis]) * (point[axis] - center[axis]);
      }
      BallInGrid<dim> ball(grid, center);
      ball.SetRadius2(dist2);
      const Cell<dim> cell = grid.GetCell(point.data());
      const Key key = Key::FromCell(cell, Key::MaxDepth);
      const Key home = Key::FromCell(ball.GetHome(), Key::MaxDepth);
      ASSERT_EQ(key.AtDepth(ball.GetDepth()), home.AtDepth(ball.GetDepth()));
      const int shift = Key::MaxDepth - ball.GetCoverDepth();
      ASSERT_LE(ball.GetDepth(), ball.GetCoverDepth());
      for (int axis = 0; axis < dim; ++axis)
      {
        ASSERT_GE(cell[axis], ball.GetLower()[axis]);
        ASSERT_LE(cell[axis], ball.GetUpper()[axis]);
        ASSERT_LE((ball.GetUpper()[axis] >> shift) - (ball.GetLower()[axis] >> shift), 1U);
      }
    }
  }
}

TYPED_TEST(TestBallInGrid, RoundingOfPlacesLeavesNoPointOut)
{
  constexpr int dim = TypeParam::value;
  using Key = MortonKey<dim>;
  Position<dim> lower;
  Position<dim> upper;
  lower.fill(-0.1);
  upper.fill(0.6);
  const Grid<dim> grid(Box<dim>(lower, upper));
  std::mt19937_64 random(173);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial)
  {
    // Beside a face of a cell of the deepest depth; a point that is one step of a double away.
    const int axis = trial % dim;
    Position<dim> center{};
    const double cells = std::floor(uniform(random) * Key::CellsPerSide);
    center[axis] = lower[axis] + cells * grid.GetSide(Key::MaxDepth);
    Position<dim> point = center;
    point[axis] = std::nextafter(center[axis], trial / dim % 2 == 0 ? lower[axis] : upper[axis]);
    const double distance = point[axis] - center[axis];
    BallInGrid<dim> ball(grid, center);
    ball.SetRadius2(distance * distance);
    const Cell<dim> cell = grid.GetCell(point.data());
    ASSERT_GE(cell[axis], ball.GetLower()[axis]);
    ASSERT_LE(cell[axis], ball.GetUpper()[axis]);
  }
}

TYPED_TEST(TestBallInGrid, DepthsAreTheDeepest)
{
  constexpr int dim = TypeParam::value;
  using Key = MortonKey<dim>;
  Position<dim> upper;
  upper.fill(1.0);
  const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
  // Around the middle of a cell of depth 3.
  Position<dim> center;
  center.fill(5.0 / 16.0);
  BallInGrid<dim> ball(grid, center);
  for (int axis = 0; axis < dim; ++axis)
  {
    EXPECT_EQ(ball.GetHome()[axis], 5U << (Key::MaxDepth - 4));
  }
  const auto expectDepths = [&ball](double radius, int depth, int coverDepth)
  {
    ball.SetRadius2(radius * radius);
    EXPECT_EQ(ball.GetDepth(), depth) << radius;
    EXPECT_EQ(ball.GetCoverDepth(), coverDepth) << radius;
  };
  expectDepths(0.99 / 16.0, 3, 3);
  expectDepths(1.01 / 16.0, 1, 2);
  expectDepths(3.01 / 16.0, 0, 1);
  expectDepths(0.49 / 16.0, 3, 4);
  expectDepths(INFINITY, 0, 0);
}

TYPED_TEST(TestBallInGrid, FitsInTheCellsThatHoldIt)
{
  constexpr int dim = TypeParam::value;
  std::mt19937_64 random(172);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const double side : { 1e-300, 1e-150, 1.0, 1e30, 1e160, 1e300 })
  {
    Position<dim> upper;
    upper.fill(side);
    const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
    int fitting = 0;
    for (int trial = 0; trial < 500; ++trial)
    {
      Position<dim> center;
      for (double& x : center)
      {
        x = side * (1.2 * uniform(random) - 0.1);
      }
      BallInGrid<dim> ball(grid, center);
      const double radius = side * std::pow(0.1, 1.0 + 8.0 * uniform(random));
      ball.SetRadius2(radius * radius);
      const int depth = trial % 10;
      if (ball.FitsInCell(depth, radius * radius))
      {
        ++fitting;
        ASSERT_GE(ball.GetDepth(), depth);
      }
    }
    const bool isExact = side > 1e-130 && side < 1e140;
    EXPECT_EQ(fitting > 50, isExact) << side;
  }

  // Around the middle of a cell of depth 3, and near each of its faces.
  Position<dim> upper;
  upper.fill(1.0);
  const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
  Position<dim> center;
  center.fill(5.0 / 16.0);
  const auto fits = [&](double radius)
  { return BallInGrid<dim>(grid, center).FitsInCell(3, radius * radius); };
  EXPECT_TRUE(fits(0.99 / 16.0));
  EXPECT_FALSE(fits(1.01 / 16.0));
  EXPECT_FALSE(fits((1.0 - 1e-12) / 16.0)); // Rounding could take it outside.
  EXPECT_FALSE(fits(INFINITY));
  for (int axis = 0; axis < dim; ++axis)
  {
    for (const double offset : { -0.5, 0.5 })
    {
      center[axis] = (5.0 + offset) / 16.0;
      EXPECT_TRUE(fits(0.49 / 16.0));
      EXPECT_FALSE(fits(0.51 / 16.0));
    }
    center[axis] = 5.0 / 16.0;
  }

  // As nearly in cells as small as they get.
  constexpr int maxDepth = MortonKey<dim>::MaxDepth;
  center.fill(std::ldexp(11.0, -maxDepth));
  const double halfSide = std::ldexp(1.0, -maxDepth);
  const BallInGrid<dim> small(grid, center);
  EXPECT_TRUE(small.FitsInCell(maxDepth - 1, 0.99 * halfSide * halfSide));
  EXPECT_FALSE(small.FitsInCell(maxDepth - 1, 1.01 * halfSide * halfSide));
}

TYPED_TEST(TestBallInGrid, RoomForLostSquaresIsNoDenormalNumber)
{
  constexpr int dim = TypeParam::value;
  using Ball = BallInGrid<dim>;
  EXPECT_GT(Ball::Underflow, dim * std::numeric_limits<double>::min());
  for (const double side : { 1e-100, 1.0, 1e8 })
  {
    Position<dim> upper;
    upper.fill(side);
    const double cells = Grid<dim>(Box<dim>(Position<dim>{}, upper)).GetCellsPerLength();
    EXPECT_GE(Ball::Underflow * (cells * cells), std::numeric_limits<double>::min()) << side;
    EXPECT_LT(Ball::Underflow * (cells * cells), 1e-9) << side;
  }
}

TYPED_TEST(TestBallInGrid, NothingLimitsItAlongFlatAxes)
{
  constexpr int dim = TypeParam::value;
  Position<dim> upper{};
  upper[0] = 1.0;
  const Box<dim> box(Position<dim>{}, upper);
  const Grid<dim> grid(box);
  const FlatAxes<dim> flat(box, grid);
  // Above the middle of a cell of depth 3 of the first axis.
  Position<dim> center;
  center.fill(0.25);
  center[0] = 5.0 / 16.0;
  const BallInGrid<dim> ball(grid, center, flat);
  EXPECT_EQ(ball.GetRoom(3), MortonKey<dim>::CellsPerSide / 16.0);
  EXPECT_TRUE(ball.FitsInCell(3, 0.99 / 256.0));
  EXPECT_FALSE(ball.FitsInCell(3, 1.01 / 256.0));
  EXPECT_EQ(ball.GetLeastDistance(), dim > 1 ? 0.25 * MortonKey<dim>::CellsPerSide : 0.0);
  EXPECT_EQ(BallInGrid<dim>(grid, center).GetLeastDistance(), 0.0);
  for (int axis = 1; axis < dim; ++axis)
  {
    EXPECT_EQ(ball.GetHome()[axis], 0U);
    EXPECT_EQ(ball.GetPlace()[axis], -0.25 * MortonKey<dim>::CellsPerSide);
    EXPECT_LE(BallInGrid<dim>(grid, center).GetRoom(3), 0.0) << "from the face of a cell";
  }
}

TYPED_TEST(TestBallInGrid, WhatIsNoNumberReachesEverywhere)
{
  constexpr int dim = TypeParam::value;
  // Cells so small that nothing can be divided by them.
  Position<dim> upper{};
  upper[0] = 1e-320;
  const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
  BallInGrid<dim> ball(grid, upper);
  ball.SetRadius2(0.0);
  EXPECT_EQ(ball.GetDepth(), 0);
}
