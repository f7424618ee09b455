// SPDX-License-Identifier: BSD-3-Clause
#include "Grid.h"

#include "Dimensions.h"
#include "PointSamples.h"

using namespace hashedoctree;

template <typename Dimension>
class TestGrid : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestGrid, Dimensions);

TEST(TestGridFacts, RootCubeHasTheLargestExtent)
{
  const Grid<3> grid(Box<3>({ -1.0, 2.0, 5.0 }, { 0.0, 6.0, 5.5 }));
  EXPECT_EQ(grid.GetLower(), (Position<3>{ -1.0, 2.0, 5.0 }));
  EXPECT_EQ(grid.GetSide(), 4.0);
  EXPECT_EQ(grid.GetSide(0), 4.0);
  EXPECT_EQ(grid.GetSide(3), 0.5);
}

TEST(TestGridFacts, BoxOfOnePointHasSideOne)
{
  const Grid<3> grid(Box<3>({ 4.0, 4.0, 4.0 }, { 4.0, 4.0, 4.0 }));
  EXPECT_EQ(grid.GetSide(), 1.0);
  const double x[3] = { 4.0, 4.0, 4.0 };
  EXPECT_EQ(grid.GetCell(x), (Cell<3>{ 0, 0, 0 }));
}

TYPED_TEST(TestGrid, CellsAreHalfOpen)
{
  constexpr int dim = TypeParam::value;
  constexpr int maxDepth = MortonKey<dim>::MaxDepth;
  Position<dim> upper;
  upper.fill(1.0);
  const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
  for (int axis = 0; axis < dim; ++axis)
  {
    EXPECT_EQ(grid.GetCellCoordinate(0.0, axis), 0U);
    EXPECT_EQ(grid.GetCellCoordinate(std::ldexp(1.0, -maxDepth), axis), 1U);
    EXPECT_EQ(grid.GetCellCoordinate(1.0, axis), (1U << maxDepth) - 1U);
    for (int depth = 1; depth <= maxDepth; ++depth)
    {
      // The face between the first two cells of a depth.
      const double face = std::ldexp(1.0, -depth);
      EXPECT_EQ(grid.GetCellCoordinate(face, axis) >> (maxDepth - depth), 1U);
      EXPECT_EQ(grid.GetCellCoordinate(std::nextafter(face, 0.0), axis) >> (maxDepth - depth), 0U);
    }
  }
}

TEST(TestGridFacts, PositionsOutsideGetTheNearestCell)
{
  const Grid<3> grid(Box<3>({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }));
  constexpr std::uint32_t last = (1U << 21) - 1;
  EXPECT_EQ(grid.GetCellCoordinate(1.0, 0), last) << "the upper face is inside";
  EXPECT_EQ(grid.GetCellCoordinate(std::nextafter(1.0, 0.0), 0), last);
  EXPECT_EQ(grid.GetCellCoordinate(1e9, 0), last);
  EXPECT_EQ(grid.GetCellCoordinate(-1e9, 0), 0U);
  EXPECT_EQ(grid.GetCellCoordinate(INFINITY, 0), last);
  EXPECT_EQ(grid.GetCellCoordinate(-INFINITY, 0), 0U);
  EXPECT_EQ(grid.GetCellCoordinate(NAN, 0), 0U);
}

TYPED_TEST(TestGrid, OneCoordinateMakesAPositionNotFinite)
{
  constexpr int dim = TypeParam::value;
  EXPECT_TRUE(IsFinite(Position<dim>{}));
  for (int axis = 0; axis < dim; ++axis)
  {
    for (const double coordinate : { double(INFINITY), -double(INFINITY), double(NAN) })
    {
      Position<dim> x{};
      x[axis] = coordinate;
      EXPECT_FALSE(IsFinite(x)) << axis << ' ' << coordinate;
    }
  }
}

TEST(TestGridFacts, WidestBoxHasFiniteSide)
{
  const double most = Grid<1>::MaxCoordinate;
  const Grid<1> grid(Box<1>({ -most }, { most }));
  EXPECT_TRUE(std::isfinite(grid.GetSide()));
  EXPECT_EQ(grid.GetCellCoordinate(0.0, 0), 1U << 30);
  EXPECT_EQ(grid.GetCellCoordinate(most, 0), (1U << 31) - 1);
}

TYPED_TEST(TestGrid, PositionsLieInTheirCells)
{
  constexpr int dim = TypeParam::value;
  const std::vector<double> points = MakeUniformPoints<dim, double>(2000, 21, -3.0, 5.0);
  Position<dim> lower;
  Position<dim> upper;
  lower.fill(-3.0);
  upper.fill(5.0);
  const Grid<dim> grid(Box<dim>(lower, upper));
  for (std::size_t i = 0; i < points.size() / dim; ++i)
  {
    const Cell<dim> cell = grid.GetCell(&points[dim * i]);
    EXPECT_EQ(grid.GetKey(&points[dim * i]).GetCell(), cell);
    for (int axis = 0; axis < dim; ++axis)
    {
      const double x = points[dim * i + axis];
      // -3, 5 and the powers of two make corners exact.
      ASSERT_LE(grid.GetCorner(cell[axis], axis), x);
      ASSERT_GT(grid.GetCorner(cell[axis] + 1, axis), x);
    }
  }
}

TYPED_TEST(TestGrid, CornersOfTheRoot)
{
  constexpr int dim = TypeParam::value;
  Position<dim> lower;
  Position<dim> upper;
  lower.fill(10.0);
  upper.fill(13.0);
  const Grid<dim> grid(Box<dim>(lower, upper));
  EXPECT_EQ(grid.GetCorner(0, 0), 10.0);
  EXPECT_EQ(grid.GetCorner(1U << MortonKey<dim>::MaxDepth, dim - 1), 13.0);
  EXPECT_EQ(grid.GetCorner(1U << (MortonKey<dim>::MaxDepth - 1), 0), 11.5);
}

TEST(TestGridFacts, BoxesGrow)
{
  Box<2> box;
  box.Add(Box<2>({ 1.0, 2.0 }, { 3.0, 4.0 }));
  box.Add(Box<2>({ 0.0, 3.0 }, { 2.0, 9.0 }));
  box.Add(Box<2>());
  EXPECT_EQ(box.Lower, (Position<2>{ 0.0, 2.0 }));
  EXPECT_EQ(box.Upper, (Position<2>{ 3.0, 9.0 }));
}
