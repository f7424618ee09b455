// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborDirection.h"

#include "Dimensions.h"
#include "NodeBox.h"

#include <map>

using namespace hashedoctree;

template <typename Dimension>
class TestNeighborDirection : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNeighborDirection, Dimensions);

TYPED_TEST(TestNeighborDirection, TouchingOctantsAreThoseThatTouch)
{
  constexpr int dim = TypeParam::value;
  using Key = MortonKey<dim>;
  const Cell<dim> cell = []
  {
    Cell<dim> middle;
    middle.fill(1);
    return middle;
  }();
  const NodeBox<dim> node(Key::FromCell(cell, 2));
  std::map<int, int> directionsOfAxes;
  for (unsigned axes = 0; axes < Key::NumberOfOctants; ++axes)
  {
    for (unsigned upper = 0; upper < Key::NumberOfOctants; ++upper)
    {
      if ((upper & ~axes) != 0)
      {
        continue;
      }
      Cell<dim> there = cell;
      for (int axis = 0; axis < dim; ++axis)
      {
        const unsigned bit = 1U << (dim - 1 - axis);
        there[axis] += (axes & bit) == 0 ? 0U : (upper & bit) != 0 ? 1U : ~0U;
      }
      const auto neighbor = Key::FromCell(there, 2);
      unsigned expected = 0;
      for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
      {
        const bool touches = NodeBox<dim>(neighbor.GetChild(octant)).Touches(node);
        expected |= (touches ? 1U : 0U) << octant;
      }
      const unsigned touching = NeighborDirection<dim>{ axes, upper }.GetTouchingOctants();
      EXPECT_EQ(touching, expected) << axes << ' ' << upper;
      const auto numberOfAxes = static_cast<int>(CountOctants(axes));
      EXPECT_EQ(CountOctants(touching), 1U << (dim - numberOfAxes));
      ++directionsOfAxes[numberOfAxes];
    }
  }
  // Faces, edges, corners: 2^k times the ways to choose k of the axes.
  int binomial = 1;
  for (int k = 0; k <= dim; ++k)
  {
    EXPECT_EQ(directionsOfAxes[k], binomial << k);
    binomial = binomial * (dim - k) / (k + 1);
  }
}

TEST(TestNeighborDirectionFacts, TheTableInTheOctantsOfThePaper)
{
  // In 2D the octants 0 to 3 are bottom-left, top-left, bottom-right, top-right; x is the high bit.
  constexpr unsigned bottomLeft = 1;
  constexpr unsigned topLeft = 2;
  constexpr unsigned bottomRight = 4;
  constexpr unsigned topRight = 8;
  constexpr unsigned x = 2;
  constexpr unsigned y = 1;
  const auto touching = [](unsigned axes, unsigned upper) {
    return static_cast<unsigned>(NeighborDirection<2>{ axes, upper }.GetTouchingOctants());
  };
  EXPECT_EQ(touching(x, 0), topRight | bottomRight);
  EXPECT_EQ(touching(x, x), topLeft | bottomLeft);
  EXPECT_EQ(touching(y, 0), topLeft | topRight);
  EXPECT_EQ(touching(y, y), bottomLeft | bottomRight);
  EXPECT_EQ(touching(x | y, 0), topRight);
  EXPECT_EQ(touching(x | y, x), topLeft);
  EXPECT_EQ(touching(x | y, y), bottomRight);
  EXPECT_EQ(touching(x | y, x | y), bottomLeft);
  // In 3D: left, front, and the corner below all.
  EXPECT_EQ((NeighborDirection<3>{ 4, 0 }.GetTouchingOctants()), 0b11110000);
  EXPECT_EQ((NeighborDirection<3>{ 1, 1 }.GetTouchingOctants()), 0b01010101);
  EXPECT_EQ((NeighborDirection<3>{ 7, 0 }.GetTouchingOctants()), 0b10000000);
  static_assert(NeighborDirection<3>{ 0, 0 }.GetTouchingOctants() == 0xff, "all, at compile time");
}
