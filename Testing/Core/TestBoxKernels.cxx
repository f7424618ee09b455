// SPDX-License-Identifier: BSD-3-Clause
#include "BoxKernels.h"

#include "Dimensions.h"
#include "Lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestBoxKernels : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  static constexpr unsigned Octants = MortonKey<Dim>::NumberOfOctants;

  static ChildBoxes<Dim> MakeBoxes(std::mt19937& random)
  {
    ChildBoxes<Dim> boxes;
    for (int axis = 0; axis < Dim; ++axis)
    {
      for (unsigned octant = 0; octant < Octants; ++octant)
      {
        const unsigned a = random() % 256;
        const unsigned b = random() % 256;
        boxes.Lower[axis][octant] = static_cast<std::uint8_t>(std::min(a, b));
        boxes.Upper[axis][octant] = static_cast<std::uint8_t>(std::max(a, b));
      }
    }
    return boxes;
  }

  /** Calls function(kernels) for the fastest ones and for those of every machine. */
  template <typename Function>
  static void ForAllKernels(const Function& function)
  {
    const BoxKernels<Dim>& plain = GetPlainBoxKernels<Dim>();
    for (const auto* kernels : { &GetBoxKernels<Dim>(), &plain })
    {
      SCOPED_TRACE(kernels == &plain ? "plain" : "fastest");
      function(*kernels);
    }
  }

  /** Calls both with how far places lie from the middle of a block: near enough for float, and
   * anywhere. */
  static void ForReaches(void (*withFloat)(double), void (*withDouble)(double))
  {
    constexpr double farthest = BoxKernels<Dim>::FarthestPlace - 128.0;
    for (const double reach : { 1.0, 300.0, 1e4, farthest })
    {
      SCOPED_TRACE(reach);
      withFloat(reach);
    }
    for (const double reach : { 1.0, 300.0, farthest, 1e9, 1e15, 1e30 })
    {
      SCOPED_TRACE(reach);
      withDouble(reach);
    }
  }

  static unsigned Measure(const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes,
    const double* steps, float limit, float* dist2)
  {
    return kernels.MeasureBoxes(boxes, steps, limit, dist2);
  }
  static unsigned Measure(const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes,
    const double* steps, double limit, double* dist2)
  {
    return kernels.MeasureBoxesFromAfar(boxes, steps, limit, dist2);
  }

  static unsigned GetWhole(
    const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes, const double* steps, float limit)
  {
    return kernels.SelectWholeBoxes(boxes, steps, limit);
  }
  static unsigned GetWhole(
    const BoxKernels<Dim>& kernels, const ChildBoxes<Dim>& boxes, const double* steps, double limit)
  {
    return kernels.SelectWholeBoxesFromAfar(boxes, steps, limit);
  }

  /** Looks for whole boxes from places at most `reach` steps from the middle of a block: a box that
   * is one has its farthest corner within the limit, and one that has it well within is one. */
  template <typename T>
  static void ExpectWholeBoxes(double reach)
  {
    std::mt19937 random(136);
    std::uniform_real_distribution<double> uniform(128.0 - reach, 128.0 + reach);
    constexpr double error = BoxKernels<Dim>::template BoxError<T>;
    for (int trial = 0; trial < 200; ++trial)
    {
      const ChildBoxes<Dim> boxes = MakeBoxes(random);
      double steps[Dim];
      std::generate_n(steps, Dim, [&] { return uniform(random); });
      const double some2 = GetFarthest2(boxes, random() % Octants, steps);
      for (const double factor : { 0.9, 1.0, 1.1, double(INFINITY) })
      {
        const auto limit = static_cast<T>(some2 * factor);
        ForAllKernels(
          [&](const BoxKernels<Dim>& kernels)
          {
            const unsigned whole = GetWhole(kernels, boxes, steps, limit);
            for (unsigned octant = 0; octant < Octants; ++octant)
            {
              const double farthest2 = GetFarthest2(boxes, octant, steps);
              const double room = sizeof(T) == sizeof(float) ? 0.02 : 0.002 + 1e-14 * reach;
              const double well2 =
                farthest2 * (1.0 + 4.0 * error) + 2.0 * Dim * room * (std::sqrt(farthest2) + room);
              const bool isWhole = (whole >> octant & 1U) != 0;
              ASSERT_TRUE(!isWhole || farthest2 <= limit * (1.0 + error)) << octant;
              ASSERT_TRUE(isWhole || well2 >= limit) << octant;
            }
            ASSERT_EQ(whole >> Octants, 0U);
          });
      }
    }
  }

  /** Measures from places at most `reach` steps from the middle of a block. */
  template <typename T>
  static void ExpectBoxDistances(double reach)
  {
    std::mt19937 random(132);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int trial = 0; trial < 200; ++trial)
    {
      const ChildBoxes<Dim> boxes = MakeBoxes(random);
      double steps[Dim];
      for (double& step : steps)
      {
        step = 128.0 + reach * uniform(random);
      }
      const T limit = static_cast<T>(reach * reach);
      ForAllKernels(
        [&](const BoxKernels<Dim>& kernels)
        {
          T dist2[Octants];
          const unsigned mask = Measure(kernels, boxes, steps, limit, dist2);
          for (unsigned octant = 0; octant < Octants; ++octant)
          {
            ASSERT_EQ((mask >> octant & 1U) != 0, dist2[octant] <= limit);
            ExpectJustBelow(static_cast<double>(dist2[octant]), GetDist2(boxes, octant, steps),
              BoxKernels<Dim>::template BoxError<T>);
          }
        });
    }
  }

  static double GetDist2(const ChildBoxes<Dim>& boxes, unsigned octant, const double* steps)
  {
    double sum = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      // A box ends where its last step does.
      const double below = boxes.Lower[axis][octant] - steps[axis];
      const double above = steps[axis] - (boxes.Upper[axis][octant] + 1.0);
      const double distance = std::max({ 0.0, below, above });
      sum += distance * distance;
    }
    return sum;
  }

  /** Never farther than it is, nor so much nearer that searching would go astray. */
  static void ExpectJustBelow(double dist2, double expected, double error)
  {
    ASSERT_LE(dist2, expected * (1.0 + error));
    ASSERT_GE(dist2, expected * (1.0 - 10.0 * error) - 0.06 * std::sqrt(expected) - 0.01);
  }

  static double GetFarthest2(const ChildBoxes<Dim>& boxes, unsigned octant, const double* steps)
  {
    double sum = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const double fromLower = steps[axis] - boxes.Lower[axis][octant];
      const double fromUpper = boxes.Upper[axis][octant] + 1.0 - steps[axis];
      const double distance = std::max(fromLower, fromUpper);
      sum += distance * distance;
    }
    return sum;
  }

  template <typename T>
  static void ExpectAllWhereTheLimitIsNoNumber()
  {
    std::mt19937 random(133);
    const ChildBoxes<Dim> boxes = MakeBoxes(random);
    double steps[Dim];
    std::fill(std::begin(steps), std::end(steps), -1e4);
    ForAllKernels(
      [&](const BoxKernels<Dim>& kernels)
      {
        T dist2[Octants];
        constexpr unsigned all = (1U << Octants) - 1U;
        EXPECT_EQ(Measure(kernels, boxes, steps, T(1e4), dist2), 0U);
        EXPECT_EQ(Measure(kernels, boxes, steps, std::numeric_limits<T>::quiet_NaN(), dist2), all);
      });
  }
};
TYPED_TEST_SUITE(TestBoxKernels, Dimensions);

TYPED_TEST(TestBoxKernels, BoxesAreNeverFartherThanTheyAre)
{
  TestFixture::ForReaches(TestFixture::template ExpectBoxDistances<float>,
    TestFixture::template ExpectBoxDistances<double>);
}

TYPED_TEST(TestBoxKernels, FarthestCornersAreNeverNearerThanTheyAre)
{
  constexpr int dim = TestFixture::Dim;
  constexpr double farthest = BoxKernels<dim>::FarthestPlace - 128.0;
  std::mt19937 random(134);
  for (const double reach : { 1.0, 300.0, 1e4, farthest })
  {
    std::uniform_real_distribution<double> uniform(128.0 - reach, 128.0 + reach);
    for (int trial = 0; trial < 200; ++trial)
    {
      const ChildBoxes<dim> boxes = TestFixture::MakeBoxes(random);
      const unsigned octants = random() % (1U << TestFixture::Octants);
      double steps[dim];
      std::generate_n(steps, dim, [&] { return uniform(random); });
      double expected = INFINITY;
      for (unsigned octant = 0; octant < TestFixture::Octants; ++octant)
      {
        const bool counts = (octants >> octant & 1U) != 0;
        expected =
          counts ? std::min(expected, TestFixture::GetFarthest2(boxes, octant, steps)) : expected;
      }
      TestFixture::ForAllKernels(
        [&](const BoxKernels<dim>& kernels)
        {
          constexpr double error = BoxKernels<dim>::template BoxError<float>;
          const double dist2 = kernels.MeasureFarthestCorner(boxes, steps, octants);
          ASSERT_GE(dist2 * (1.0 + error), expected);
          ASSERT_LE(dist2, expected * (1.0 + error) + 0.06 * std::sqrt(expected) + 0.01);
        });
    }
  }
}

TYPED_TEST(TestBoxKernels, CornersOfTheSmallestBoxesAreNeverNearerThanTheyAre)
{
  // One step wide, and the place about as far from one face as from the other, where a rounding
  // error is the largest part of the distance.
  constexpr int dim = TestFixture::Dim;
  std::mt19937 random(138);
  std::uniform_real_distribution<double> aside(-1e-4, 1e-4);
  std::uniform_real_distribution<double> anywhere(0.0, 256.0);
  for (int trial = 0; trial < 20000; ++trial)
  {
    ChildBoxes<dim> boxes = TestFixture::MakeBoxes(random);
    double steps[dim];
    for (int axis = 0; axis < dim; ++axis)
    {
      std::copy(std::begin(boxes.Lower[axis]), std::end(boxes.Lower[axis]), boxes.Upper[axis]);
      steps[axis] = trial % 2 == 0 ? anywhere(random) : boxes.Lower[axis][0] + 0.5 + aside(random);
    }
    const double expected = TestFixture::GetFarthest2(boxes, 0, steps);
    TestFixture::ForAllKernels(
      [&](const BoxKernels<dim>& kernels)
      {
        constexpr double error = BoxKernels<dim>::template BoxError<float>;
        ASSERT_GE(kernels.MeasureFarthestCorner(boxes, steps, 1U) * (1.0 + error), expected);
      });
  }
}

TYPED_TEST(TestBoxKernels, WholeBoxesAreWithinTheLimit)
{
  TestFixture::ForReaches(
    TestFixture::template ExpectWholeBoxes<float>, TestFixture::template ExpectWholeBoxes<double>);
}

TYPED_TEST(TestBoxKernels, NothingIsLeftOutWhereTheLimitIsNoNumber)
{
  TestFixture::template ExpectAllWhereTheLimitIsNoNumber<float>();
  TestFixture::template ExpectAllWhereTheLimitIsNoNumber<double>();
}

TYPED_TEST(TestBoxKernels, EachIsTheFastestThatTheMachineHas)
{
  constexpr int dim = TestFixture::Dim;
  const BoxKernels<dim>& plain = GetPlainBoxKernels<dim>();
  const BoxKernels<dim>& fastest = GetBoxKernels<dim>();
  const bool inSpace = HasAvx2() && dim == 3; // Others fill no vectors.
  EXPECT_EQ(fastest.MeasureBoxes != plain.MeasureBoxes, inSpace);
  EXPECT_EQ(fastest.MeasureBoxesFromAfar != plain.MeasureBoxesFromAfar, inSpace);
  EXPECT_EQ(fastest.SelectWholeBoxes != plain.SelectWholeBoxes, inSpace);
  EXPECT_EQ(fastest.SelectWholeBoxesFromAfar != plain.SelectWholeBoxesFromAfar, inSpace);
  EXPECT_EQ(fastest.MeasureFarthestCorner != plain.MeasureFarthestCorner, inSpace);
}
