// SPDX-License-Identifier: BSD-3-Clause
#include "CornerCode.h"

#include "Dimensions.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestCornerCode : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestCornerCode, Dimensions);

TYPED_TEST(TestCornerCode, NamesEachCornerAndNoneZero)
{
  constexpr int dim = TypeParam::value;
  constexpr std::uint32_t last = 1U << MortonKey<dim>::MaxDepth;
  std::set<Cell<dim>> corners;
  std::mt19937 random(127);
  std::uniform_int_distribution<std::uint32_t> coordinates(0, last);
  const std::array<std::uint32_t, 4> ends{ 0, 1, last - 1, last };
  for (unsigned i = 0; i < 2000; ++i)
  {
    Cell<dim> corner;
    for (int axis = 0; axis < dim; ++axis)
    {
      // All ends of all axes, then any places.
      corner[axis] = i < 256 ? ends[i >> (2 * axis) & 3U] : coordinates(random);
    }
    corners.insert(corner);
  }
  std::set<std::uint64_t> codes;
  for (const Cell<dim>& corner : corners)
  {
    const std::uint64_t code = EncodeCorner<dim>(corner);
    EXPECT_NE(code, 0U);
    EXPECT_EQ(DecodeCorner<dim>(code), corner);
    codes.insert(code);
  }
  EXPECT_EQ(codes.size(), corners.size());
}
