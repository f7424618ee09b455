// SPDX-License-Identifier: BSD-3-Clause
#include "PointBoxWalk.h"

#include "BruteForceSearch.h"
#include "Dimensions.h"
#include "MakePointTree.h"
#include "PointSamples.h"
#include "PointSearch.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestPointBoxWalk : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestPointBoxWalk, Dimensions);

TYPED_TEST(TestPointBoxWalk, FindsAsBruteForceWhereFacesAreThoseOfCells)
{
  constexpr int dim = TypeParam::value;
  std::mt19937_64 random(151);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double offset : { 0.0, -3.0, 1e6 })
  {
    SCOPED_TRACE(offset);
    // On a face, or as close to it as can be, but all in one cube.
    const auto pick = [&](double least, double most)
    {
      const double face = offset + static_cast<double>(random() % 9);
      const double beside[] = { face, std::nextafter(face, -infinity),
        std::nextafter(face, infinity) };
      return std::clamp(beside[random() % 3], offset + least, offset + most);
    };
    std::vector<double> coordinates(dim, offset);
    coordinates.insert(coordinates.end(), dim, offset + 8.0);
    std::generate_n(std::back_inserter(coordinates), 400 * dim, [&] { return pick(0.0, 8.0); });
    const PointSpan<dim, double> points{ coordinates.data(), 402 };
    const auto tree = MakePointTree(points, 2);
    const BruteForceSearch<dim, double> oracle(points);
    for (int i = 0; i < 600; ++i)
    {
      Box<dim> box;
      for (int axis = 0; axis < dim; ++axis)
      {
        const double a = pick(-1.0, 9.0);
        const double b = pick(-1.0, 9.0);
        box.Lower[axis] = std::min(a, b);
        box.Upper[axis] = std::max(a, b);
      }
      std::vector<PointIndex> within;
      PointSearch<dim, double>(tree).FindWithin(box, within);
      std::vector<std::int64_t> found(within.begin(), within.end());
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, oracle.FindWithin(box)) << i;
    }
  }
}

TEST(TestPointBoxWalkFacts, BoxesExamineTheNodesThatTheirFacesCross)
{
  const PointSample<3, float> sample{ "uniform", MakeUniformPoints<3, float>(50000, 166) };
  const auto tree = MakePointTree(sample.GetSpan(), 64);
  const PointSearch<3, float> search(tree);
  EXPECT_EQ(search.CountNodesForWithin({ { -1.0, -1.0, -1.0 }, { 2.0, 2.0, 2.0 } }), 1U);
  // The root's own cube: no child crosses its faces.
  const Grid<3>& grid = tree.GetOctree().GetGrid();
  Box<3> root({ grid.GetLower()[0], grid.GetLower()[1], grid.GetLower()[2] },
    { grid.GetLower()[0], grid.GetLower()[1], grid.GetLower()[2] });
  for (double& upper : root.Upper)
  {
    upper += grid.GetSide();
  }
  EXPECT_EQ(search.CountNodesForWithin(root), 1U);
  root.Lower[1] += grid.GetSide() / 2.0; // Nor those of its halves.
  EXPECT_EQ(search.CountNodesForWithin(root), 1U);
  // All points are in leaves of depth 4: a plane crosses 1, 4, 16 and 64 nodes above them.
  EXPECT_EQ(search.CountNodesForWithin({ { -1.0, -1.0, 0.3 }, { 2.0, 2.0, 0.3 } }), 85U);
  // Nothing can be in these.
  EXPECT_EQ(search.CountNodesForWithin({ { 0.1, 0.1, 0.6 }, { 0.9, 0.9, 0.4 } }), 0U);
  EXPECT_EQ(search.CountNodesForWithin({ { 0.1, 0.1, NAN }, { 0.9, 0.9, 0.4 } }), 0U);
}

TEST(TestPointBoxWalkFacts, BoxesEndWhereTheySay)
{
  // Faces so near to points that only the points themselves tell on which side they are: beside a
  // face of cells, which is 0 here, and below the last cell's upper face.
  const PointSample<1, double> sample{ "on faces", { -3.0, 1.0, 0.0, 0.5, 0.75, -1.0, -2.0 } };
  const auto tree = MakePointTree(sample.GetSpan(), 1);
  const auto find = [&tree](double lower, double upper)
  {
    std::vector<PointIndex> found;
    PointSearch<1, double>(tree).FindWithin(Box<1>({ lower }, { upper }), found);
    std::sort(found.begin(), found.end());
    return found;
  };
  EXPECT_EQ(find(0.0, 1.0), (std::vector<PointIndex>{ 1, 2, 3, 4 }));
  EXPECT_EQ(find(1e-30, 1.0), (std::vector<PointIndex>{ 1, 3, 4 }));
  EXPECT_EQ(find(-3.0, std::nextafter(1.0, 0.0)), (std::vector<PointIndex>{ 0, 2, 3, 4, 5, 6 }));
}
