// SPDX-License-Identifier: BSD-3-Clause
#include "PointDescent.h"

#include "MakePointTree.h"
#include "PointSamples.h"
#include "PointWalk.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

namespace
{
/** A ball that counts how many points were compared with it, some at a time. */
class CountingBall
{
public:
  static constexpr bool HasFixedBall = true;
  static constexpr bool TakesWholeNodes = false;
  static constexpr bool TakesWithin = true;
  static constexpr bool TakesPromises = false;

  explicit CountingBall(double radius)
    : Radius2(radius * radius)
  {
  }
  double GetBound2() const
  {
    ++this->Looks;
    return this->Radius2;
  }
  static constexpr bool NeedsIds() { return true; }
  void Add(const double*, std::uint64_t within, const PointIndex*, std::size_t)
  {
    this->Found += static_cast<std::size_t>(__builtin_popcountll(within));
  }

  mutable std::size_t Looks = 0;
  std::size_t Found = 0;

private:
  double Radius2;
};
}

TEST(TestPointDescent, PointsAtOnePlaceAreLookedAtOnlyIfOneOfThemIsWithin)
{
  constexpr std::size_t copies = 100000;
  std::vector<float> coordinates(3 * copies, 0.0F);
  const std::vector<float> others = MakeUniformPoints<3, float>(1000, 411);
  coordinates.insert(coordinates.end(), others.begin(), others.end());
  const PointSpan<3, float> points{ coordinates.data(), coordinates.size() / 3 };
  const auto tree = MakePointTree(points, 64);
  NoCount nodes;
  for (const double x : { -0.1, -1e-8, 1e-8 }) // Where the leaf of the copies is the nearest.
  {
    const Position<3> position{ x, x, x };
    CountingBall near(1.7 * std::abs(x));
    SearchPoints<3, float>(tree, position, near, nodes, 1);
    EXPECT_EQ(near.Found, 0U);
    EXPECT_LT(near.Looks, 100U) << x;
    CountingBall around(1.8 * std::abs(x));
    SearchPoints<3, float>(tree, position, around, nodes, 1);
    EXPECT_GE(around.Found, copies);
  }
}
