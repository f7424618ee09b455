// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_PointSamples_h
#define Testing_Support_PointSamples_h

#include "PointSpan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

/** Points to test with; Dim coordinates each. */
template <int Dim, typename Real>
struct PointSample
{
  std::string Name;
  std::vector<Real> Coordinates;

  hashedoctree::PointSpan<Dim, Real> GetSpan() const
  {
    return { this->Coordinates.data(), this->Coordinates.size() / Dim };
  }
};

/** `count` points with coordinates uniform in [lower, upper). */
template <int Dim, typename Real>
std::vector<Real> MakeUniformPoints(
  std::size_t count, unsigned seed, double lower = 0.0, double upper = 1.0)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(lower, upper);
  std::vector<Real> coordinates(Dim * count);
  for (Real& coordinate : coordinates)
  {
    coordinate = static_cast<Real>(uniform(random));
  }
  return coordinates;
}

/** Half of the points fill the unit cube, the others a corner of it. */
template <int Dim, typename Real>
std::vector<Real> MakeTwoDensities(std::size_t count, unsigned seed, double widthOfCorner)
{
  std::vector<Real> coordinates = MakeUniformPoints<Dim, Real>(count / 2, seed);
  const auto dense = MakeUniformPoints<Dim, Real>(count / 2, seed + 1, 0.0, widthOfCorner);
  coordinates.insert(coordinates.end(), dense.begin(), dense.end());
  return coordinates;
}

/** `count` points on the unit sphere around the origin. */
template <int Dim, typename Real>
std::vector<Real> MakeSpherePoints(std::size_t count, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Real> coordinates;
  for (std::size_t i = 0; i < count; ++i)
  {
    double x[Dim];
    double norm2 = 0.0;
    for (double& coordinate : x)
    {
      coordinate = normal(random);
      norm2 += coordinate * coordinate;
    }
    for (const double coordinate : x)
    {
      coordinates.push_back(static_cast<Real>(coordinate / std::sqrt(norm2)));
    }
  }
  return coordinates;
}

/** Clusters of clusters: pairs so close that their leaves lie deep, in a wide box. */
template <int Dim, typename Real>
std::vector<Real> MakeClusteredPoints(std::size_t count, unsigned seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::uniform_int_distribution<int> exponent(1, 18);
  std::vector<Real> coordinates;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double size = std::ldexp(1.0, -exponent(random));
    for (int axis = 0; axis < Dim; ++axis)
    {
      coordinates.push_back(static_cast<Real>(0.3 + size * uniform(random)));
    }
  }
  return coordinates;
}

/** The standing samples: what users bring, and what breaks octrees. */
template <int Dim, typename Real>
std::vector<PointSample<Dim, Real>> MakePointSamples()
{
  const Real notANumber = std::numeric_limits<Real>::quiet_NaN();
  const Real infinity = std::numeric_limits<Real>::infinity();
  std::vector<PointSample<Dim, Real>> samples;
  const auto add = [&samples](const char* name, std::vector<Real> coordinates) {
    samples.push_back({ name, std::move(coordinates) });
  };
  const auto transformed = [](std::vector<Real> coordinates, double factor, double offset)
  {
    for (Real& coordinate : coordinates)
    {
      coordinate = static_cast<Real>(coordinate * factor + offset);
    }
    return coordinates;
  };

  const std::vector<Real> uniform = MakeUniformPoints<Dim, Real>(500, 1);
  add("empty", {});
  add("one point", std::vector<Real>(Dim, Real(3)));
  add("two points", transformed(MakeUniformPoints<Dim, Real>(2, 2), 5.0, -1.0));
  add("all coincident", std::vector<Real>(Dim * 40, Real(-7)));
  add("uniform", uniform);
  add("sphere", MakeSpherePoints<Dim, Real>(500, 3));
  add("clusters", MakeClusteredPoints<Dim, Real>(400, 4));
  add("all negative", transformed(uniform, 3.0, -10.0));
  add("far offset", transformed(uniform, 1e-9, 1e6));
  add("large", transformed(uniform, 1e30, -2e29));
  add("squares too large", transformed(uniform, sizeof(Real) == 8 ? 2e154 : 1e38, 0.0));
  add("small", transformed(uniform, 1e-30, 0.0));
  // Squares of differences are no numbers that a double can hold to the last digit, or at all.
  add("tiny", transformed(uniform, 10.0 * std::numeric_limits<Real>::min(), 0.0));
  add("squares too small", transformed(uniform, sizeof(Real) == 8 ? 1e-161 : 1e-40, 0.0));

  std::vector<Real> duplicates = uniform;
  duplicates.insert(duplicates.end(), uniform.begin(), uniform.begin() + 100 * Dim);
  for (int i = 0; i < 30; ++i)
  {
    duplicates.insert(duplicates.end(), uniform.begin(), uniform.begin() + Dim);
  }
  add("duplicates", duplicates);

  std::vector<Real> collinear = uniform;
  std::vector<Real> coplanar = uniform;
  for (std::size_t i = 0; i < uniform.size(); ++i)
  {
    collinear[i] = uniform[i / Dim * Dim];
    coplanar[i] = i % Dim == Dim - 1 ? Real(0.25) : uniform[i];
  }
  add("collinear", collinear);
  add("coplanar", coplanar);

  // A lattice has points on the faces of cells at all depths, and on the upper faces of the root.
  std::vector<Real> lattice;
  for (unsigned i = 0; i < (1U << (2 * Dim)) + (1U << Dim); ++i)
  {
    for (unsigned axis = 0; axis < Dim; ++axis)
    {
      lattice.push_back(static_cast<Real>((i >> (2 * axis) & 3U) + (i >> (2 * Dim) ? 1 : 0)));
    }
  }
  add("lattice", lattice);

  std::vector<Real> outlier = transformed(uniform, 1e-6, 0.0);
  outlier.insert(outlier.end(), Dim, Real(1));
  add("one outlier", outlier);

  // Smaller than a cell of the last depth.
  std::vector<Real> spot = transformed(uniform, 1e-12, 0.0);
  spot.insert(spot.end(), Dim, Real(1));
  add("dense spot and outlier", spot);

  std::vector<Real> broken = uniform;
  broken[0] = notANumber;
  broken[Dim * 17 + Dim - 1] = infinity;
  broken[Dim * 400] = -infinity;
  broken[Dim * 499 + Dim / 2] =
    std::numeric_limits<Real>::max() > Real(1e300) ? std::numeric_limits<Real>::max() : notANumber;
  add("not finite", broken);
  add("nothing finite", std::vector<Real>(Dim * 3, notANumber));
  return samples;
}

/** Those of them that have points, and all of these finite. Throws where they are too few to test
 * with. */
template <int Dim, typename Real>
std::vector<PointSample<Dim, Real>> MakeFinitePointSamples()
{
  std::vector<PointSample<Dim, Real>> samples;
  for (PointSample<Dim, Real>& sample : MakePointSamples<Dim, Real>())
  {
    const std::vector<Real>& coordinates = sample.Coordinates;
    if (!coordinates.empty() &&
      std::all_of(coordinates.begin(), coordinates.end(), [](Real x) { return std::isfinite(x); }))
    {
      samples.push_back(std::move(sample));
    }
  }
  if (samples.size() <= 10)
  {
    throw std::logic_error("too few finite samples");
  }
  return samples;
}

#endif
