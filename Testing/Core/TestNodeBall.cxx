// SPDX-License-Identifier: BSD-3-Clause
#include "NodeBall.h"

#include "Dimensions.h"
#include "NodeBox.h"

#include <limits>
#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestNodeBall : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  static MortonKey<Dim> MakeKey(std::mt19937_64& random, int depth)
  {
    return MortonKey<Dim>(random() >> (63 - Dim * depth) >> 1 | 1ULL << (Dim * depth));
  }

  /** Squared distance from the center of a box to the corner of another that is the nearest on each
   * axis or the farthest, or to the nearest point in between. */
  static double GetDist2(const NodeBox<Dim>& from, const NodeBox<Dim>& to, bool farthest)
  {
    double dist2 = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t center = from.Lower[axis] + from.Upper[axis];
      const auto toLower = static_cast<double>(center - 2 * to.Lower[axis]);
      const auto toUpper = static_cast<double>(2 * to.Upper[axis] - center);
      const double distance = farthest   ? std::fmax(toLower, toUpper)
        : toLower < 0.0 || toUpper < 0.0 ? std::fmin(std::abs(toLower), std::abs(toUpper))
                                         : 0.0;
      dist2 += distance * distance;
    }
    return dist2;
  }
};
TYPED_TEST_SUITE(TestNodeBall, Dimensions);

TYPED_TEST(TestNodeBall, CellsLieAsTheirNearestAndFarthestPoints)
{
  constexpr int dim = TestFixture::Dim;
  using Key = MortonKey<dim>;
  std::mt19937_64 random(701);
  Position<dim> upper;
  upper.fill(4.0); // A power of two, so that radii are exact.
  const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
  int sides[3] = {};
  for (int trial = 0; trial < 20000; ++trial)
  {
    const int depth = static_cast<int>(random() % 6 + 1);
    const Key node = this->MakeKey(random, depth);
    const Key other = this->MakeKey(random, static_cast<int>(random() % 7) + 1);
    // Whole cells often, so that balls touch cells and no more.
    const double radius =
      std::ldexp(static_cast<double>(random() % 32), -static_cast<int>(random() % 5) - 2);
    const double inHalfCells = std::ldexp(radius / 4.0, Key::MaxDepth + 1);
    const double radius2 = inHalfCells * inHalfCells;
    const NodeBall<dim> ball(grid, node, radius);
    const double nearest2 = this->GetDist2(NodeBox<dim>(node), NodeBox<dim>(other), false);
    const double farthest2 = this->GetDist2(NodeBox<dim>(node), NodeBox<dim>(other), true);
    const BallSide expected = nearest2 > radius2 ? BallSide::Outside
      : farthest2 > radius2                      ? BallSide::Across
                                                 : BallSide::Inside;
    ASSERT_EQ(ball.GetSide(other.GetCell(), other.GetDepth()), expected);
    ASSERT_EQ(ball.ReachesBorder(), radius >= std::ldexp(2.0, -depth));
    const BallSides children =
      ball.GetSidesOfChildren(other.GetParent().GetCell(), other.GetDepth() - 1);
    ASSERT_EQ(children.Meeting >> other.GetOctant() & 1U, expected != BallSide::Outside ? 1U : 0U);
    ASSERT_EQ(children.Inside >> other.GetOctant() & 1U, expected == BallSide::Inside ? 1U : 0U);
    ++sides[static_cast<int>(expected)];
  }
  EXPECT_GT(std::min({ sides[0], sides[1], sides[2] }), 500);
}

TYPED_TEST(TestNodeBall, TheCoverHoldsWhatMeetsTheBallInCellsAboveTheNode)
{
  constexpr int dim = TestFixture::Dim;
  using Key = MortonKey<dim>;
  std::mt19937_64 random(702);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Grid<dim> grid; // Of side 1.
  for (int trial = 0; trial < 20000; ++trial)
  {
    const int depth = static_cast<int>(random() % Key::MaxDepth) + 1;
    const Key node = this->MakeKey(random, depth);
    const double radius = trial % 50 == 0
      ? std::numeric_limits<double>::infinity()
      : std::ldexp(0.5 + uniform(random), -static_cast<int>(random() % depth));
    const NodeBall<dim> ball(grid, node, radius);
    ASSERT_TRUE(ball.ReachesBorder());
    const NeighborCells<dim> cover = ball.GetCover();
    ASSERT_GE(cover.Depth, 0);
    ASSERT_LT(cover.Depth, depth);
    // Cells at most four times as wide as the ball's part in the root, and its rounding.
    ASSERT_LE(grid.GetSide(cover.Depth), 4.0 * radius + 8.0 * grid.GetSide(Key::MaxDepth));
    const Key cell = this->MakeKey(random, Key::MaxDepth);
    const bool meets = ball.GetSide(cell.GetCell(), Key::MaxDepth) != BallSide::Outside;
    for (int axis = 0; axis < dim; ++axis)
    {
      ASSERT_LE(cover.Upper[axis] - cover.Lower[axis], 1U);
      const std::uint32_t place = cell.GetCell()[axis] >> (Key::MaxDepth - cover.Depth);
      ASSERT_TRUE(!meets || (cover.Lower[axis] <= place && place <= cover.Upper[axis]));
    }
  }
}
