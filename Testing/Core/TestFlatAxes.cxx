// SPDX-License-Identifier: BSD-3-Clause
#include "FlatAxes.h"

#include "Dimensions.h"

using namespace hashedoctree;

template <typename Dimension>
class TestFlatAxes : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Of a box with side 1 along the last axis, and `extent` cells along the others. */
  static FlatAxes<Dim> MakeOfExtent(double cells)
  {
    Position<Dim> lower;
    lower.fill(-3.0);
    Position<Dim> upper = lower;
    for (double& x : upper)
    {
      x += std::ldexp(cells, -MortonKey<Dim>::MaxDepth);
    }
    upper[Dim - 1] = lower[Dim - 1] + 1.0;
    const Box<Dim> box(lower, upper);
    return FlatAxes<Dim>(box, Grid<Dim>(box));
  }
};
TYPED_TEST_SUITE(TestFlatAxes, Dimensions);

TYPED_TEST(TestFlatAxes, AreThoseOfLessThanHalfACell)
{
  constexpr int dim = TestFixture::Dim;
  constexpr unsigned allButTheLast = (1U << (dim - 1)) - 1U;
  EXPECT_EQ(FlatAxes<dim>().GetMask(), 0U);
  EXPECT_EQ(TestFixture::MakeOfExtent(0.0).GetMask(), allButTheLast);
  EXPECT_EQ(TestFixture::MakeOfExtent(0.25).GetMask(), allButTheLast);
  EXPECT_EQ(TestFixture::MakeOfExtent(0.75).GetMask(), 0U);
}

TYPED_TEST(TestFlatAxes, AreAllOfPointsAtOnePlaceAndNoneOfNoPoints)
{
  constexpr int dim = TestFixture::Dim;
  const Box<dim> place(Position<dim>{}, Position<dim>{});
  EXPECT_EQ(FlatAxes<dim>(place, Grid<dim>(place)).GetMask(), (1U << dim) - 1U);
  EXPECT_EQ(FlatAxes<dim>(Box<dim>(), Grid<dim>()).GetMask(), 0U);
}

TYPED_TEST(TestFlatAxes, PlacesComeToTheLowerSideAsFarAway)
{
  constexpr int dim = TestFixture::Dim;
  const FlatAxes<dim> flat = TestFixture::MakeOfExtent(0.25);
  const double place = 1000.75;
  EXPECT_EQ(flat.Fold(place, dim - 1), place);
  EXPECT_EQ(FlatAxes<dim>().Fold(place, 0), place);
  for (int axis = 0; axis + 1 < dim; ++axis)
  {
    EXPECT_NEAR(flat.Fold(place, axis), -1000.5, 1e-6);
    EXPECT_EQ(flat.Fold(-place, axis), -place);
    EXPECT_EQ(flat.Fold(0.125, axis), 0.0);
    EXPECT_EQ(flat.Fold(0.0, axis), 0.0);
  }
}
