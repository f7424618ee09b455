// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorSamples.h"

#include "LocatorTerrain.h"
#include "PointSamples.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace locator_benchmark
{
namespace
{
using Random = std::mt19937_64;

double Uniform(Random& random, double lower, double upper)
{
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

void AddBlurred(
  std::vector<float>& coordinates, const Position& center, double sigma, Random& random)
{
  std::normal_distribution<double> normal(0.0, sigma);
  for (const double x : center)
  {
    coordinates.push_back(static_cast<float>(x + normal(random)));
  }
}

/** Ten centers with ten clusters each; the widths of the clusters go over two orders. */
std::vector<float> MakeClusters(std::size_t count, unsigned seed)
{
  struct Cluster
  {
    Position Center;
    double Sigma;
  };
  Random random(seed);
  std::vector<Cluster> clusters;
  for (int i = 0; i < 10; ++i)
  {
    const Position center{ Uniform(random, 0, 1), Uniform(random, 0, 1), Uniform(random, 0, 1) };
    std::normal_distribution<double> normal(0.0, 0.05);
    for (int j = 0; j < 10; ++j)
    {
      clusters.push_back(
        { { center[0] + normal(random), center[1] + normal(random), center[2] + normal(random) },
          std::pow(10.0, Uniform(random, -4.0, -2.0)) });
    }
  }
  std::vector<float> coordinates;
  coordinates.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Cluster& cluster = clusters[random() % clusters.size()];
    AddBlurred(coordinates, cluster.Center, cluster.Sigma, random);
  }
  return coordinates;
}

/** A smooth closed curve: a few waves along each axis. */
struct Curve
{
  static constexpr std::size_t Waves = 3;
  Position Center;
  std::array<Position, Waves> Amplitudes;
  std::array<Position, Waves> Phases;

  Position At(double t) const
  {
    Position x = this->Center;
    for (std::size_t wave = 0; wave < Waves; ++wave)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double angle = 6.283185307179586 * static_cast<double>(wave + 1) * t;
        x[axis] += this->Amplitudes[wave][axis] * std::cos(angle + this->Phases[wave][axis]);
      }
    }
    return x;
  }
};

Curve MakeCurve(Random& random)
{
  Curve curve{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    curve.Center[axis] = Uniform(random, 0, 1);
    for (std::size_t wave = 0; wave < Curve::Waves; ++wave)
    {
      curve.Amplitudes[wave][axis] = Uniform(random, 0, 0.2) / static_cast<double>(wave + 1);
      curve.Phases[wave][axis] = Uniform(random, 0, 6.283185307179586);
    }
  }
  return curve;
}

std::vector<float> MakeFilaments(std::size_t count, unsigned seed)
{
  constexpr double thickness = 1e-4;
  Random random(seed);
  std::vector<Curve> curves(50);
  for (Curve& curve : curves)
  {
    curve = MakeCurve(random);
  }
  std::vector<float> coordinates;
  coordinates.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Curve& curve = curves[random() % curves.size()];
    AddBlurred(coordinates, curve.At(Uniform(random, 0, 1)), thickness, random);
  }
  return coordinates;
}

/** All points but one within a billionth of the box. */
std::vector<float> MakeOutlier(std::size_t count, unsigned seed)
{
  std::vector<float> coordinates = MakeUniformPoints<3, float>(count, seed, 0.0, 1e-9);
  std::fill(coordinates.end() - 3, coordinates.end(), 1.0F);
  return coordinates;
}

/** Cauchy distributed on each axis: half of the points within [-1, 1], single ones as far away as
 * there are points. */
std::vector<float> MakeTails(std::size_t count, unsigned seed)
{
  Random random(seed);
  std::cauchy_distribution<double> cauchy;
  std::vector<float> coordinates(3 * count);
  for (float& coordinate : coordinates)
  {
    coordinate = static_cast<float>(cauchy(random));
  }
  return coordinates;
}

/** In a square across z. */
std::vector<float> MakePlane(std::size_t count, unsigned seed)
{
  std::vector<float> coordinates = MakeUniformPoints<3, float>(count, seed);
  for (std::size_t i = 0; i < count; ++i)
  {
    coordinates[3 * i + 2] = 0.0F;
  }
  return coordinates;
}

/** A sphere whose points stand there six times each, as the corners of triangles that share none.
 */
std::vector<float> MakeDuplicates(std::size_t count, unsigned seed)
{
  constexpr std::size_t copies = 6;
  const std::size_t places = (count + copies - 1) / copies;
  const std::vector<float> sphere = MakeSpherePoints<3, float>(places, seed);
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    order[i] = i % places;
  }
  Random random(seed);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<float> coordinates;
  coordinates.reserve(3 * count);
  for (const std::size_t place : order)
  {
    coordinates.insert(
      coordinates.end(), sphere.begin() + 3 * place, sphere.begin() + 3 * (place + 1));
  }
  return coordinates;
}

std::vector<float> MakeCoordinates(
  const std::string& name, std::size_t count, const std::string& terrainPath)
{
  constexpr unsigned seed = 2008;
  if (name == "terrain")
  {
    return ResampleTerrain(terrainPath, count, seed);
  }
  if (name == "cube")
  {
    return MakeUniformPoints<3, float>(count, seed);
  }
  if (name == "sphere")
  {
    return MakeSpherePoints<3, float>(count, seed);
  }
  if (name == "clusters")
  {
    return MakeClusters(count, seed);
  }
  if (name == "filaments")
  {
    return MakeFilaments(count, seed);
  }
  if (name == "duplicates")
  {
    return MakeDuplicates(count, seed);
  }
  if (name == "outlier")
  {
    return MakeOutlier(count, seed);
  }
  return name == "tails" ? MakeTails(count, seed) : MakePlane(count, seed);
}
}

const std::vector<std::string>& GetSampleNames()
{
  static const std::vector<std::string> names{ "terrain", "cube", "sphere", "clusters", "filaments",
    "duplicates", "outlier", "tails", "plane" };
  return names;
}

LocatorData MakeSample(const std::string& name, std::size_t count, const std::string& terrainPath)
{
  return { name, MakeCoordinates(name, count, terrainPath) };
}
}
