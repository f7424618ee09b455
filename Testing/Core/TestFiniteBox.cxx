// SPDX-License-Identifier: BSD-3-Clause
#include "FiniteBox.h"

#include "Dimensions.h"
#include "PointSamples.h"

#include <cmath>
#include <limits>
#include <utility>

using namespace hashedoctree;

template <typename Dimension>
class TestFiniteBox : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  template <typename Real>
  static void ExpectBox(const std::vector<Real>& coordinates)
  {
    Box<Dim> expected;
    for (std::size_t i = 0; i < coordinates.size(); ++i)
    {
      const auto x = static_cast<double>(coordinates[i]);
      expected.Lower[i % Dim] = std::min(expected.Lower[i % Dim], x);
      expected.Upper[i % Dim] = std::max(expected.Upper[i % Dim], x);
    }
    const auto box = FindFiniteBox<Dim>(coordinates.data(), coordinates.size() / Dim);
    ASSERT_TRUE(box.has_value());
    ASSERT_EQ(box->Lower, expected.Lower);
    ASSERT_EQ(box->Upper, expected.Upper);
  }

  /** Puts a value at each place of some coordinates in turn. */
  template <typename Real>
  static void ExpectNoBoxWith(Real odd)
  {
    for (const std::size_t count : { 1U, 3U, 4U, 11U })
    {
      std::vector<Real> coordinates(Dim * count, Real(0.5));
      for (Real& coordinate : coordinates)
      {
        const Real before = std::exchange(coordinate, odd);
        ASSERT_FALSE(FindFiniteBox<Dim>(coordinates.data(), count).has_value()) << odd;
        coordinate = before;
      }
    }
  }
};
TYPED_TEST_SUITE(TestFiniteBox, Dimensions);

TYPED_TEST(TestFiniteBox, IsTheBoxAroundAnyNumberOfPoints)
{
  constexpr int dim = TypeParam::value;
  for (std::size_t count = 1; count < 30; ++count)
  {
    TestFixture::ExpectBox(MakeUniformPoints<dim, float>(count, 31, -3.0F, -1.0F));
    TestFixture::ExpectBox(MakeUniformPoints<dim, double>(count, 32, 7.0, 9.0));
  }
  TestFixture::ExpectBox(MakeUniformPoints<dim, float>(10000, 33, -1.0F, 1.0F));
}

TYPED_TEST(TestFiniteBox, DoesNotExistWhereACoordinateIsNotFinite)
{
  constexpr double most = Grid<TypeParam::value>::MaxCoordinate;
  for (const double odd : { double(NAN), double(INFINITY), -double(INFINITY),
         std::nextafter(most, INFINITY), -std::nextafter(most, INFINITY) })
  {
    TestFixture::ExpectNoBoxWith(odd);
  }
  for (const float odd : { NAN, INFINITY, -INFINITY })
  {
    TestFixture::ExpectNoBoxWith(odd);
  }
}

TYPED_TEST(TestFiniteBox, ReachesToTheGreatestCoordinates)
{
  constexpr int dim = TypeParam::value;
  constexpr double most = Grid<dim>::MaxCoordinate;
  std::vector<double> wide(dim * std::size_t(9), most);
  wide[0] = -most;
  TestFixture::ExpectBox(wide);
  TestFixture::ExpectBox(
    std::vector<float>(dim * std::size_t(9), std::numeric_limits<float>::max()));
}
