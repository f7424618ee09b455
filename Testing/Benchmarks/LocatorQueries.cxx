// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorQueries.h"

#include "Median.h"
#include "Octree.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace locator_benchmark
{
namespace
{
using Random = std::mt19937_64;

/** The distance to the closest point after `rank` closer ones. */
double GetDistance(const LocatorData& data, LocatorPeer& locator, const Position& x, int rank)
{
  Answer answer;
  locator.FindClosest(rank + 1, x, answer);
  return std::sqrt(data.GetDistance2(static_cast<std::size_t>(locator.GetIds(answer).back()), x));
}

Position MovePoint(const LocatorData& data, LocatorPeer& locator, std::size_t id, Random& random)
{
  const float* point = data.GetPoint(id);
  Position x{ point[0], point[1], point[2] };
  const double spacing = GetDistance(data, locator, x, 1);
  std::normal_distribution<double> normal;
  for (double& coordinate : x)
  {
    coordinate += 0.5 * spacing / std::sqrt(3.0) * normal(random);
  }
  return x;
}

Position MakeUniformPosition(const double bounds[6], Random& random)
{
  Position x{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    x[axis] =
      std::uniform_real_distribution<double>(bounds[2 * axis], bounds[2 * axis + 1])(random);
  }
  return x;
}

std::vector<Position> MakeOrderedPositions(
  const LocatorData& data, LocatorPeer& locator, std::size_t count, Random& random)
{
  constexpr std::size_t run = 1000;
  const hashedoctree::PointSpan<3, float> points{ data.GetPoint(0), data.GetNumberOfPoints() };
  const hashedoctree::Execution execution;
  const hashedoctree::PointSelection<3> all(points, {}, execution);
  const hashedoctree::Octree<3> curve(points, all, {}, execution);
  std::vector<Position> positions;
  for (std::size_t first = 0; positions.size() < count; ++first)
  {
    if (positions.size() % run == 0)
    {
      first = random();
    }
    const std::size_t place = first % curve.GetNumberOfPoints();
    positions.push_back(MovePoint(data, locator, curve.GetPointIds()[place], random));
  }
  return positions;
}

double MakeRadius(
  const LocatorData& data, LocatorPeer& locator, const std::vector<Position>& positions)
{
  std::vector<double> distances;
  for (std::size_t i = 0; i < std::min<std::size_t>(positions.size(), 501); ++i)
  {
    // With radius 0, we and VTK would find the points at that place, and nanoflann none.
    const double distance = GetDistance(data, locator, positions[i], 29);
    if (distance > 0.0)
    {
      distances.push_back(distance);
    }
  }
  // A little more, so that no point lies on it: nanoflann's radius is exclusive, VTK's inclusive.
  return distances.empty() ? 1.0 : GetMedian(distances) * (1.0 + 1e-6);
}
}

LocatorQueries MakeQueries(const LocatorData& data, LocatorPeer& locator, std::size_t count)
{
  Random random(27);
  LocatorQueries queries{};
  double bounds[6];
  data.MakePolyData()->GetBounds(bounds);
  for (std::size_t i = 0; i < count; ++i)
  {
    queries.Near.push_back(MovePoint(data, locator, random() % data.GetNumberOfPoints(), random));
    queries.Uniform.push_back(MakeUniformPosition(bounds, random));
  }
  queries.Ordered = MakeOrderedPositions(data, locator, count, random);
  const double side =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  for (std::size_t i = 0; i < count; ++i)
  {
    const float* point = data.GetPoint(random() % data.GetNumberOfPoints());
    queries.Points.push_back({ point[0], point[1], point[2] });
    queries.Above.push_back(MakeUniformPosition(bounds, random));
    queries.Above.back()[2] = bounds[5] + 10.0 * side;
  }
  queries.Radius = MakeRadius(data, locator, queries.Near);
  return queries;
}
}
