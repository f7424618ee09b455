// SPDX-License-Identifier: BSD-3-Clause
#include "PointKeys.h"

#include "Dimensions.h"
#include "PointSamples.h"

#include <limits>

using namespace hashedoctree;

namespace
{
/** Compares the keys of every range of the points. */
template <int Dim, typename Points>
void ExpectKeysOfTheGrid(const Points& points)
{
  Position<Dim> upper;
  upper.fill(1.0);
  const Grid<Dim> grid(Box<Dim>(Position<Dim>{}, upper));
  const MortonKey<Dim> untouched = MortonKey<Dim>::Root();
  for (std::size_t first = 0; first <= points.Count; ++first)
  {
    for (std::size_t count = 0; first + count <= points.Count; ++count)
    {
      std::vector<MortonKey<Dim>> keys(count + 1, untouched);
      GetKeys<Dim>(grid, points, first, count, keys.data());
      for (std::size_t i = 0; i < count; ++i)
      {
        ASSERT_EQ(keys[i], grid.GetKey(points[first + i])) << first << " + " << i;
      }
      ASSERT_EQ(keys[count], untouched);
    }
  }
}
}

template <typename Dimension>
class TestPointKeys : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestPointKeys, Dimensions);

TYPED_TEST(TestPointKeys, AreThoseOfTheGrid)
{
  constexpr int dim = TypeParam::value;
  // Beyond the root on all sides.
  PointSample<dim, float> sample{ "around",
    MakeUniformPoints<dim, float>(MostKeysAtOnce, 31, -0.2, 1.2) };
  sample.Coordinates[1] = std::numeric_limits<float>::quiet_NaN();
  sample.Coordinates[dim * 7] = -std::numeric_limits<float>::infinity();
  ExpectKeysOfTheGrid<dim>(sample.GetSpan());
}

TEST(TestPointKeys, OfPointsInAPlaneAreThoseOfTheGrid)
{
  const std::vector<double> coordinates =
    MakeUniformPoints<3, double>(MostKeysAtOnce, 32, -0.2, 1.2);
  PlaneSpan<double> plane;
  plane.Coordinates = coordinates.data();
  plane.Count = MostKeysAtOnce;
  plane.Axes = { 2, 0 };
  plane.Lower = 0.1; // Others have no place in the plane.
  ExpectKeysOfTheGrid<2>(plane);
}
