// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include "BruteForceSearch.h"
#include "Dimensions.h"
#include "MakePointTree.h"
#include "PointSamples.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

template <typename Dimension>
class TestFreeSpace : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Tree = PointTree<Dim, double>;

  static Tree MakeTree(const std::vector<double>& coordinates, std::size_t maxPointsPerLeaf)
  {
    return MakePointTree(
      PointSpan<Dim, double>{ coordinates.data(), coordinates.size() / Dim }, maxPointsPerLeaf);
  }

  static bool HoldsHomeOf(const Tree& tree, const Position<Dim>& center)
  {
    return tree.GetFreeSpace().HoldsHomeOf(BallInGrid<Dim>(tree.GetOctree().GetGrid(), center));
  }
  static bool Holds(const Tree& tree, const Position<Dim>& center, double radius)
  {
    const BallInGrid<Dim> ball(tree.GetOctree().GetGrid(), center);
    return tree.GetFreeSpace().Holds(ball, ball.GetReach(radius * radius));
  }
};
TYPED_TEST_SUITE(TestFreeSpace, Dimensions);

TYPED_TEST(TestFreeSpace, HoldsTheBallsThatReachNoCellWithPoints)
{
  constexpr int dim = TypeParam::value;
  constexpr int size = 1 << FreeSpace<dim>::MaxCoarseDepth;
  // A dense spot, and a single point in two corners of the unit cube.
  std::vector<double> coordinates = MakeUniformPoints<dim, double>(1U << 16, 181, 0.3, 0.3 + 1e-6);
  coordinates.insert(coordinates.end(), dim, 0.0);
  coordinates.insert(coordinates.end(), dim, 1.0);
  const auto tree = TestFixture::MakeTree(coordinates, 48);
  ASSERT_EQ(
    tree.GetFreeSpace().GetBytes(), std::size_t(1) << (dim * FreeSpace<dim>::MaxCoarseDepth));

  for (std::size_t number = 0; number < tree.GetFreeSpace().GetBytes(); ++number)
  {
    Position<dim> center;
    int cells[3] = { 0, 0, 0 };
    for (int axis = 0; axis < dim; ++axis)
    {
      const int cell = static_cast<int>(number >> (axis * FreeSpace<dim>::MaxCoarseDepth)) % size;
      center[axis] = (cell + 0.5) / size;
      cells[0] = std::max(cells[0], cell);
      cells[1] = std::max(cells[1], size - 1 - cell);
      cells[2] = std::max(cells[2], std::abs(cell - static_cast<int>(0.3 * size)));
    }
    const int toPoints = *std::min_element(cells, cells + 3);
    ASSERT_EQ(TestFixture::HoldsHomeOf(tree, center), toPoints > 0) << number;
    ASSERT_FALSE(TestFixture::Holds(tree, center, (toPoints + 0.49) / size)) << number;
    ASSERT_EQ(TestFixture::Holds(tree, center, (toPoints - 1 + 0.49) / size), toPoints > 0);
    // Off the middle of the cell the ball comes to a face sooner.
    for (const double side : { -1.0, 1.0 })
    {
      Position<dim> place = center;
      place[number % dim] += side * 0.3 / size;
      ASSERT_FALSE(TestFixture::Holds(tree, place, (std::max(toPoints - 1, 0) + 0.21) / size));
      ASSERT_EQ(TestFixture::Holds(tree, place, (toPoints - 1 + 0.19) / size), toPoints > 0);
    }
    // Beside the root it has the room of the nearest place in it, to half a cell of MaxDepth.
    if (number % size == 0)
    {
      Position<dim> place = center;
      place[0] = -3.0 / size;
      const double half = 0.5 * size / MortonKey<dim>::CellsPerSide;
      ASSERT_FALSE(TestFixture::Holds(tree, place, (std::max(toPoints - 1, 0) + half) / size));
      ASSERT_EQ(TestFixture::Holds(tree, place, (toPoints - 1 - half) / size), toPoints > 1);
    }
  }
}

TYPED_TEST(TestFreeSpace, HoldsNoPoint)
{
  constexpr int dim = TypeParam::value;
  std::mt19937_64 random(182);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int held = 0;
  auto samples = MakePointSamples<dim, double>();
  samples.push_back({ "many", MakeClusteredPoints<dim, double>(20000, 183) });
  for (const auto& sample : samples)
  {
    const BruteForceSearch<dim, double> oracle(sample.GetSpan());
    for (const std::size_t maxPointsPerLeaf : { 1U, 48U })
    {
      SCOPED_TRACE(sample.Name);
      const auto tree = TestFixture::MakeTree(sample.Coordinates, maxPointsPerLeaf);
      if (!tree.GetOctree().IsRootInternal())
      {
        continue;
      }
      EXPECT_LE(tree.GetFreeSpace().GetBytes(), tree.GetNumberOfPoints());
      const Grid<dim>& grid = tree.GetOctree().GetGrid();
      for (int trial = 0; trial < 20; ++trial)
      {
        // In the root and beside it.
        Position<dim> center;
        for (int axis = 0; axis < dim; ++axis)
        {
          center[axis] = grid.GetLower()[axis] + grid.GetSide() * (1.5 * uniform(random) - 0.25);
        }
        const double radius = grid.GetSide() * std::pow(uniform(random), 3.0);
        if (TestFixture::Holds(tree, center, radius))
        {
          ++held;
          ASSERT_EQ(CountWithin(oracle.FindAll(center), radius), 0U);
        }
      }
    }
  }
  EXPECT_GT(held, 50);
}

TYPED_TEST(TestFreeSpace, IsNowhereAroundFewPoints)
{
  constexpr int dim = TypeParam::value;
  std::vector<double> coordinates(dim, 0.0);
  coordinates.insert(coordinates.end(), dim, 1.0);
  Position<dim> center;
  center.fill(0.4);
  // (On a line even two points would get two cells, were they not in one leaf.)
  const auto tree = TestFixture::MakeTree(coordinates, dim == 1 ? 2 : 1);
  EXPECT_EQ(tree.GetFreeSpace().GetBytes(), 1U);
  EXPECT_FALSE(TestFixture::Holds(tree, center, 0.0));
  EXPECT_FALSE(TestFixture::Holds(tree, center, INFINITY));
}
