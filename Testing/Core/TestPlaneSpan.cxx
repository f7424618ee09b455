// SPDX-License-Identifier: BSD-3-Clause
#include "PlaneSpan.h"

#include "ForEachNode.h"
#include "PointSamples.h"
#include "QueryDepths.h"
#include "Threads.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

namespace
{
constexpr std::array<std::array<int, 2>, 6> AllAxes{ { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 1, 0 },
  { 2, 1 }, { 2, 0 } } };

template <typename Real>
PlaneSpan<Real> MakePlane(const PointSample<3, Real>& sample, const std::array<int, 2>& axes)
{
  PlaneSpan<Real> plane;
  plane.Coordinates = sample.Coordinates.data();
  plane.Count = sample.Coordinates.size() / 3;
  plane.Axes = axes;
  return plane;
}

/** The coordinates in the plane of the points that a selection in space keeps, NaN of the others.
 */
template <typename Real>
PointSample<2, Real> CopyKept(const PointSample<3, Real>& sample,
  const PointSelection<3>& selection, const std::array<int, 2>& axes)
{
  PointSample<2, Real> copy{ sample.Name, {} };
  for (std::size_t i = 0; i < sample.GetSpan().Count; ++i)
  {
    for (const int axis : axes)
    {
      copy.Coordinates.push_back(selection.Keeps(sample.GetSpan()[i])
          ? sample.GetSpan()[i][axis]
          : std::numeric_limits<Real>::quiet_NaN());
    }
  }
  return copy;
}

void ExpectSameTrees(const Octree<2>& tree, const Octree<2>& expected)
{
  EXPECT_EQ(tree.GetGrid().GetLower(), expected.GetGrid().GetLower());
  EXPECT_EQ(tree.GetGrid().GetSide(), expected.GetGrid().GetSide());
  ASSERT_EQ(tree.GetNumberOfPoints(), expected.GetNumberOfPoints());
  EXPECT_TRUE(std::equal(
    tree.GetPointIds(), tree.GetPointIds() + tree.GetNumberOfPoints(), expected.GetPointIds()));
  ASSERT_EQ(tree.GetNumberOfNodes(), expected.GetNumberOfNodes());
  std::vector<Octree<2>::Node> nodes;
  ForEachNode(expected, [&nodes](const Octree<2>::Node& node) { nodes.push_back(node); });
  std::size_t next = 0;
  ForEachNode(tree,
    [&](const Octree<2>::Node& node)
    {
      EXPECT_EQ(node.NodeKey, nodes[next].NodeKey);
      EXPECT_EQ(node.FirstPoint, nodes[next].FirstPoint);
      EXPECT_EQ(node.LastPoint, nodes[next].LastPoint);
      EXPECT_EQ(node.Internal, nodes[next].Internal);
      ++next;
    });
}

/** The tree of a plane against the tree of the copied coordinates. */
template <typename Real>
void ExpectTreeOfCopies(const PointSample<3, Real>& sample, const std::optional<Box<3>>& given)
{
  const PointSelection<3> selection(sample.GetSpan(), given, Execution());
  for (const std::array<int, 2>& axes : AllAxes)
  {
    const int across = 3 - axes[0] - axes[1];
    PlaneSpan<Real> plane = MakePlane(sample, axes);
    plane.Lower = selection.GetBox().Lower[across];
    plane.Upper = selection.GetBox().Upper[across];
    const PointSelection<2> inPlane(selection, axes);
    EXPECT_EQ(inPlane.GetNumberOfPoints(), selection.GetNumberOfPoints());
    EXPECT_EQ(inPlane.GetNumberOfSkippedPoints(), selection.GetNumberOfSkippedPoints());
    EXPECT_EQ(inPlane.GetNumberOfOutsidePoints(), selection.GetNumberOfOutsidePoints());
    const Octree<2> tree(plane, inPlane, {}, Execution(OnThreads(2)));

    const PointSample<2, Real> copy = CopyKept(sample, selection, axes);
    std::optional<Box<2>> box;
    if (given)
    {
      box = Box<2>({ given->Lower[axes[0]], given->Lower[axes[1]] },
        { given->Upper[axes[0]], given->Upper[axes[1]] });
    }
    const Octree<2> expected(
      copy.GetSpan(), PointSelection<2>(copy.GetSpan(), box, Execution()), {}, Execution());
    ExpectSameTrees(tree, expected);
  }
}
}

TEST(TestPlaneSpan, ReadsTwoCoordinatesOfEachPoint)
{
  const PointSample<3, float> sample{ "two points", { 1, 2, 3, 4, 5, 6 } };
  for (const std::array<int, 2>& axes : AllAxes)
  {
    const PlaneSpan<float> plane = MakePlane(sample, axes);
    ASSERT_EQ(plane.Count, 2U);
    for (std::size_t i = 0; i < 2; ++i)
    {
      EXPECT_EQ(plane[i][0], sample.Coordinates[3 * i + static_cast<std::size_t>(axes[0])]);
      EXPECT_EQ(plane[i][1], sample.Coordinates[3 * i + static_cast<std::size_t>(axes[1])]);
    }
  }
}

TEST(TestPlaneSpan, HasNoNumbersWhereTheThirdIsOutOfItsInterval)
{
  const PointSample<3, double> sample{ "across",
    { 0, 1, 2, 0, 3, 2, 0, std::nextafter(1.0, 0.0), 2, 0, std::nextafter(3.0, 4.0), 2, 0, NAN, 2,
      0, INFINITY, 2, 0, -INFINITY, 2 } };
  PlaneSpan<double> plane = MakePlane(sample, { 0, 2 });
  const auto countNumbers = [&plane]
  {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < plane.Count; ++i)
    {
      EXPECT_EQ(std::isnan(plane[i][0]), std::isnan(plane[i][1]));
      if (!std::isnan(plane[i][0]))
      {
        numbers.push_back(i);
      }
    }
    return numbers;
  };
  EXPECT_EQ(countNumbers(), std::vector<std::size_t>({ 0, 1, 2, 3 })) << "all that are finite";
  plane.Lower = 1;
  plane.Upper = 3;
  EXPECT_EQ(countNumbers(), std::vector<std::size_t>({ 0, 1 }));
}

TEST(TestPlaneSpan, HasTheTreeOfCopiedCoordinates)
{
  for (const auto& sample : MakePointSamples<3, double>())
  {
    SCOPED_TRACE(sample.Name);
    ExpectTreeOfCopies(sample, {});
    ExpectTreeOfCopies(sample, Box<3>({ 0.2, -0.4, 0.0 }, { 0.5, 0.9, 0.7 }));
  }
  for (const auto& sample : MakePointSamples<3, float>())
  {
    SCOPED_TRACE(sample.Name);
    ExpectTreeOfCopies(sample, {});
  }
}

TEST(TestPlaneSpan, GivesQueriesTheDepthsOfCopiedCoordinates)
{
  // Around the root, and partly outside it.
  PointSample<3, double> queries{ "queries", MakeUniformPoints<3, double>(60, 191, -0.2, 1.2) };
  queries.Coordinates[0] = NAN;
  queries.Coordinates[4] = INFINITY;
  queries.Coordinates[8] = NAN;
  const PointSample<2, double> points{ "uniform", MakeUniformPoints<2, double>(500, 192) };
  const Octree<2> tree(
    points.GetSpan(), PointSelection<2>(points.GetSpan(), {}, Execution()), {}, Execution());
  const PointSelection<3> finite(queries.GetSpan(), {}, Execution());
  EXPECT_EQ(finite.GetNumberOfPoints(), 57U);
  for (const std::array<int, 2>& axes : AllAxes)
  {
    const auto copied = CopyKept(queries, finite, axes);
    const auto keys = GetQueryKeys(tree.GetGrid(), MakePlane(queries, axes), Execution());
    const auto expected = GetQueryKeys(tree.GetGrid(), copied.GetSpan(), Execution());
    const auto measure = [&](const Buffer<MortonKey<2>>& of) {
      return MeasureQueryDepths(tree, KeySpan<2>{ of.GetData(), of.GetSize() }, Execution());
    };
    EXPECT_EQ(measure(keys), measure(expected));
  }
}
