// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_FuzzPoints_h
#define Testing_Fuzz_FuzzPoints_h

#include "PointSpan.h"

#include <cstdint>
#include <limits>
#include <vector>

/** The nearest number of a type; infinite where the value does not fit, for which a conversion to
 * float would be undefined. */
template <typename Real>
Real ToReal(double x)
{
  using Limits = std::numeric_limits<Real>;
  constexpr double most = Limits::max();
  return x > most ? Limits::infinity() : x < -most ? -Limits::infinity() : static_cast<Real>(x);
}

/** Points that are made one after the other, up to a number of them. */
template <int Dim, typename Real>
class FuzzPoints
{
public:
  using Position = hashedoctree::Position<Dim>;

  explicit FuzzPoints(std::size_t most)
    : Most(most)
  {
  }

  hashedoctree::PointSpan<Dim, Real> GetSpan() const
  {
    return { this->Coordinates.data(), this->Coordinates.size() / Dim };
  }

  /** The point of a number, modulo how many there are; where there is none, `otherwise`. */
  Position Get(std::size_t number, const Position& otherwise) const
  {
    const auto points = this->GetSpan();
    return points.Count == 0 ? otherwise
                             : hashedoctree::GetPosition<Dim>(points, number % points.Count);
  }

  void Add(const Position& x)
  {
    if (this->GetSpan().Count < this->Most)
    {
      for (const double coordinate : x)
      {
        this->Coordinates.push_back(ToReal<Real>(coordinate));
      }
    }
  }

  /** Random points in a cube. */
  void AddCloud(const Position& lower, double side, unsigned count, std::uint32_t seed)
  {
    for (unsigned i = 0; i < count; ++i)
    {
      Position x = lower;
      for (double& coordinate : x)
      {
        seed = seed * 1664525U + 1013904223U;
        coordinate += side * (seed >> 16) / 65536.0;
      }
      this->Add(x);
    }
  }

private:
  std::size_t Most;
  std::vector<Real> Coordinates;
};

#endif
