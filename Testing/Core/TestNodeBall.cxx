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

  /** Squared distance from the center of a box to the nearest point of another. */
  static double GetNearest2(const NodeBox<Dim>& from, const NodeBox<Dim>& to)
  {
    double dist2 = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t center = from.Lower[axis] + from.Upper[axis];
      const auto toLower = static_cast<double>(center - 2 * to.Lower[axis]);
      const auto toUpper = static_cast<double>(2 * to.Upper[axis] - center);
      const double distance =
        toLower < 0.0 || toUpper < 0.0 ? std::fmin(std::abs(toLower), std::abs(toUpper)) : 0.0;
      dist2 += distance * distance;
    }
    return dist2;
  }
};
TYPED_TEST_SUITE(TestNodeBall, Dimensions);

TYPED_TEST(TestNodeBall, CellsMeetTheBallWithTheirNearestPoints)
{
  constexpr int dim = TestFixture::Dim;
  using Key = MortonKey<dim>;
  std::mt19937_64 random(701);
  Position<dim> upper;
  upper.fill(4.0); // A power of two, so that radii are exact.
  const Grid<dim> grid(Box<dim>(Position<dim>{}, upper));
  int numberOfMeeting = 0;
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
    const bool expected = this->GetNearest2(NodeBox<dim>(node), NodeBox<dim>(other)) <= radius2;
    ASSERT_EQ(ball.Meets(other.GetCell(), other.GetDepth()), expected);
    ASSERT_EQ(ball.ReachesBorder(), radius >= std::ldexp(2.0, -depth));
    typename NodeBall<dim>::Corner parent;
    ball.GetLower(other.GetParent().GetCell(), other.GetDepth() - 1, parent);
    const double side = NodeBall<dim>::GetSide(other.GetDepth());
    const std::uint32_t octants = ball.GetMeetingOctants(PlainMachine(), parent, side);
    ASSERT_EQ((octants >> other.GetOctant() & 1U) != 0, expected);
#if defined(__x86_64__)
    if (HasAvx2())
    {
      ASSERT_EQ(ball.GetMeetingOctants(Avx2Machine(), parent, side), octants);
    }
#endif
    typename NodeBall<dim>::Corner lower;
    ball.GetLower(other.GetCell(), other.GetDepth(), lower);
    typename NodeBall<dim>::Corner lowerOfOctant;
    NodeBall<dim>::GetLowerOfOctant(parent, side, other.GetOctant(), lowerOfOctant);
    for (int axis = 0; axis < 4; ++axis)
    {
      ASSERT_EQ(lowerOfOctant[axis], lower[axis]);
    }
    numberOfMeeting += expected ? 1 : 0;
  }
  EXPECT_GT(numberOfMeeting, 500);
  EXPECT_LT(numberOfMeeting, 19500);
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
    const bool meets = ball.Meets(cell.GetCell(), Key::MaxDepth);
    for (int axis = 0; axis < dim; ++axis)
    {
      ASSERT_LE(cover.Upper[axis] - cover.Lower[axis], 1U);
      const std::uint32_t place = cell.GetCell()[axis] >> (Key::MaxDepth - cover.Depth);
      ASSERT_TRUE(!meets || (cover.Lower[axis] <= place && place <= cover.Upper[axis]));
    }
  }
}
