// SPDX-License-Identifier: BSD-3-Clause
#include "Dilation.h"

#include "Dimensions.h"
#include "MortonKey.h"

#include <gtest/gtest.h>

#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestDilation : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestDilation, Dimensions);

TYPED_TEST(TestDilation, MovesEachBitAndBack)
{
  constexpr int dim = TypeParam::value;
  constexpr int bits = MortonKey<dim>::MaxDepth;
  std::mt19937 random(11);
  for (std::uint32_t trial = 0; trial < (1U << 17); ++trial)
  {
    // All 16-bit integers, then any that fit.
    const std::uint32_t x =
      (trial < (1U << 16) ? trial : random()) & ((std::uint64_t(1) << bits) - 1);
    std::uint64_t expected = 0;
    for (int bit = 0; bit < bits; ++bit)
    {
      expected |= std::uint64_t(x >> bit & 1U) << (dim * bit);
    }
    ASSERT_EQ(Dilation<dim>::Spread(x), expected) << x;
    ASSERT_EQ(Dilation<dim>::Contract(expected), x);
    // Bits of the other axes must not disturb.
    ASSERT_EQ(Dilation<dim>::Contract(expected | ~Dilation<dim>::Mask(1)), x);
  }
}
