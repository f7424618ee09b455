// SPDX-License-Identifier: BSD-3-Clause
#include "GridCells.h"

#include "Dimensions.h"
#include "PointSamples.h"
#include "Rounding.h"
#include "SmallNumbersAreZero.h"

#include <cmath>
#include <limits>

using namespace hashedoctree;

template <typename Dimension>
class TestGridCells : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Compares the first 0, 1, 2, ... of the positions, and those from the second one on. */
  template <typename Real>
  static void ExpectCellsOfTheGrid(const Grid<Dim>& grid, const std::vector<Real>& coordinates)
  {
    const std::size_t all = coordinates.size() / Dim;
    for (const auto get : { GetCells<Dim, Real>, GetCellsPlainly<Dim, Real> })
    {
      for (std::size_t count = 0; count <= std::min<std::size_t>(all, 9); ++count)
      {
        ExpectCells(grid, coordinates.data(), count, get);
      }
      ExpectCells(grid, coordinates.data() + Dim, all - 1, get);
    }
  }

  /** Of a cube with a corner in the origin. */
  static Grid<Dim> MakeGrid(double side)
  {
    Position<Dim> upper;
    upper.fill(side);
    return Grid<Dim>(Box<Dim>({}, upper));
  }

  /** Compares positions on the borders of cells, and as close to them as can be. */
  static void ExpectBorders(const Grid<Dim>& grid)
  {
    constexpr double size = MortonKey<Dim>::CellsPerSide;
    std::vector<double> coordinates;
    for (const double share : MakeUniformPoints<1, double>(200 * Dim, 25))
    {
      const double border = std::floor(share * size) / size * grid.GetSide();
      coordinates.push_back(std::nextafter(border, -1.0));
      coordinates.push_back(border);
      coordinates.push_back(std::nextafter(border, std::numeric_limits<double>::max()));
    }
    ExpectCellsOfTheGrid(grid, coordinates);
  }

private:
  template <typename Real, typename Function>
  static void ExpectCells(
    const Grid<Dim>& grid, const Real* coordinates, std::size_t count, const Function& get)
  {
    Cell<Dim> untouched;
    untouched.fill(12345);
    std::vector<Cell<Dim>> cells(count + 1, untouched);
    get(grid, coordinates, count, cells.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      ASSERT_EQ(cells[i], grid.GetCell(coordinates + Dim * i)) << i << " of " << count;
    }
    ASSERT_EQ(cells[count], untouched) << "behind the last of " << count;
  }
};
TYPED_TEST_SUITE(TestGridCells, Dimensions);

TYPED_TEST(TestGridCells, AreThoseOfTheGrid)
{
  constexpr int dim = TypeParam::value;
  Position<dim> lower;
  Position<dim> upper;
  for (int axis = 0; axis < dim; ++axis)
  {
    lower[axis] = 0.1 * axis - 3.0;
    upper[axis] = 0.3 * axis + 4.0;
  }
  const Grid<dim> grid(Box<dim>(lower, upper));
  // Beyond the faces on all sides.
  TestFixture::ExpectCellsOfTheGrid(grid, MakeUniformPoints<dim, float>(20001, 21, -5.0F, 6.0F));
  TestFixture::ExpectCellsOfTheGrid(grid, MakeUniformPoints<dim, double>(20001, 22, -5.0, 6.0));
}

TYPED_TEST(TestGridCells, BordersOfCellsAreWhereTheGridHasThem)
{
  std::vector<double> sides{ 1.0, 3.0, 0.1, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0),
    8000.0, std::nextafter(8000.0, 0.0), 0x1p-799, 0x1.8p-801, 1e-310, 0x1.fp+799, 0x1.1p+801,
    8e307 };
  for (const double mantissa : MakeUniformPoints<1, double>(20, 24, 1.0, 2.0))
  {
    sides.push_back(mantissa);
    sides.push_back(std::nextafter(static_cast<double>(static_cast<float>(mantissa)), 2.0));
  }
  for (const double side : sides)
  {
    TestFixture::ExpectBorders(TestFixture::MakeGrid(side));
  }
}

#if defined(__SSE2__)
TYPED_TEST(TestGridCells, NumbersThatAreTakenForZeroChangeNoCell)
{
  for (const double side : { 1e-310, 1e-300, 1.0, 8e307 })
  {
    const auto grid = TestFixture::MakeGrid(side);
    const SmallNumbersAreZero mode;
    TestFixture::ExpectBorders(grid);
  }
}
#endif

TYPED_TEST(TestGridCells, ProcessorsMayRoundOtherwise)
{
  for (const int mode : { FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO })
  {
    const Rounding rounding(mode);
    for (const double side : { 1.0, 3.0, 0.1, 8000.0 })
    {
      TestFixture::ExpectBorders(TestFixture::MakeGrid(side));
    }
  }
}

TYPED_TEST(TestGridCells, CoordinatesThatAreNoPlaceGetCellsToo)
{
  constexpr int dim = TypeParam::value;
  Position<dim> lower{};
  Position<dim> upper;
  upper.fill(1.0);
  const Grid<dim> grid(Box<dim>(lower, upper));
  constexpr double most = std::numeric_limits<double>::max();
  std::vector<double> coordinates = MakeUniformPoints<dim, double>(64, 23);
  std::size_t place = 0;
  for (const double odd : { double(NAN), double(INFINITY), -double(INFINITY), most, -most, 0.0,
         -0.0, 1.0, std::nextafter(1.0, 0.0), 0.5 })
  {
    coordinates[place] = odd;
    place += 5; // On each axis, and in each lane of a vector.
  }
  TestFixture::ExpectCellsOfTheGrid(grid, coordinates);
  TestFixture::ExpectCellsOfTheGrid(
    grid, std::vector<float>(coordinates.begin(), coordinates.end()));
}
