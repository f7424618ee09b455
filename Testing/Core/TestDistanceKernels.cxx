// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceKernels.h"

#include "Dimensions.h"
#include "Lanes.h"
#include "PointSamples.h"

using namespace hashedoctree;

template <typename Dimension>
class TestDistanceKernels : public ::testing::Test
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
  template <typename Real, typename Function>
  static void ForAllKernels(const Function& function)
  {
    const DistanceKernels<Dim, Real>& plain = GetPlainDistanceKernels<Dim, Real>();
    for (const auto* kernels : { &GetDistanceKernels<Dim, Real>(), &plain })
    {
      SCOPED_TRACE(kernels == &plain ? "plain" : "fastest");
      function(*kernels);
    }
  }

  /** Calls both with how far places lie from the middle of a block: near enough for float, and
   * anywhere. */
  static void ForReaches(void (*withFloat)(double), void (*withDouble)(double))
  {
    constexpr double farthest = DistanceKernels<Dim, float>::FarthestPlace - 128.0;
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

  static unsigned Measure(const DistanceKernels<Dim, float>& kernels, const ChildBoxes<Dim>& boxes,
    const double* steps, float limit, float* dist2)
  {
    return kernels.ToBoxes(boxes, steps, limit, dist2);
  }
  static unsigned Measure(const DistanceKernels<Dim, float>& kernels, const ChildBoxes<Dim>& boxes,
    const double* steps, double limit, double* dist2)
  {
    return kernels.ToBoxesFromAfar(boxes, steps, limit, dist2);
  }

  static unsigned GetWhole(const DistanceKernels<Dim, float>& kernels, const ChildBoxes<Dim>& boxes,
    const double* steps, float limit)
  {
    return kernels.ToWholeBoxes(boxes, steps, limit);
  }
  static unsigned GetWhole(const DistanceKernels<Dim, float>& kernels, const ChildBoxes<Dim>& boxes,
    const double* steps, double limit)
  {
    return kernels.ToWholeBoxesFromAfar(boxes, steps, limit);
  }

  /** Looks for whole boxes from places at most `reach` steps from the middle of a block: a box that
   * is one has its farthest corner within the limit, and one that has it well within is one. */
  template <typename T>
  static void ExpectWholeBoxes(double reach)
  {
    std::mt19937 random(136);
    std::uniform_real_distribution<double> uniform(128.0 - reach, 128.0 + reach);
    constexpr double error = DistanceKernels<Dim, float>::template BoxError<T>;
    for (int trial = 0; trial < 200; ++trial)
    {
      const ChildBoxes<Dim> boxes = MakeBoxes(random);
      double steps[Dim];
      std::generate_n(steps, Dim, [&] { return uniform(random); });
      const double some2 = GetFarthest2(boxes, random() % Octants, steps);
      for (const double factor : { 0.9, 1.0, 1.1, double(INFINITY) })
      {
        const auto limit = static_cast<T>(some2 * factor);
        ForAllKernels<float>(
          [&](const DistanceKernels<Dim, float>& kernels)
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
      ForAllKernels<float>(
        [&](const DistanceKernels<Dim, float>& kernels)
        {
          T dist2[Octants];
          const unsigned mask = Measure(kernels, boxes, steps, limit, dist2);
          for (unsigned octant = 0; octant < Octants; ++octant)
          {
            ASSERT_EQ((mask >> octant & 1U) != 0, dist2[octant] <= limit);
            ExpectJustBelow(static_cast<double>(dist2[octant]), GetDist2(boxes, octant, steps),
              DistanceKernels<Dim, float>::template BoxError<T>);
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
    ForAllKernels<float>(
      [&](const DistanceKernels<Dim, float>& kernels)
      {
        T dist2[Octants];
        constexpr unsigned all = (1U << Octants) - 1U;
        EXPECT_EQ(Measure(kernels, boxes, steps, T(1e4), dist2), 0U);
        EXPECT_EQ(Measure(kernels, boxes, steps, std::numeric_limits<T>::quiet_NaN(), dist2), all);
      });
  }

  template <typename Real>
  static void ExpectDistances(const DistanceKernels<Dim, Real>& kernels)
  {
    using Kernels = DistanceKernels<Dim, Real>;
    const double x[4] = { 0.3, -1.7, 1e6, 0.1 };
    for (std::size_t count = 1; count <= Kernels::MostPoints; ++count)
    {
      const std::size_t stride = count + count % 3;
      std::vector<Real> points = MakeUniformPoints<Dim, Real>(stride, 131);
      // What stands beyond the points must not count: these would be the nearest.
      points.reserve(points.size() + Kernels::Padding); // No more, for the address sanitizer.
      points.insert(points.end(), Kernels::Padding, static_cast<Real>(x[Dim - 1]));
      std::vector<double> dist2(Kernels::MostPoints, -1.0);
      const double least = kernels.ToPoints(points.data(), stride, count, x, dist2.data());
      double expectedLeast = Infinity;
      for (std::size_t i = 0; i < count; ++i)
      {
        double expected = 0.0;
        for (std::size_t axis = 0; axis < Dim; ++axis)
        {
          const double difference = static_cast<double>(points[axis * stride + i]) - x[axis];
          expected += difference * difference;
        }
        ASSERT_EQ(dist2[i], expected);
        expectedLeast = std::min(expectedLeast, expected);
      }
      ASSERT_EQ(least, expectedLeast);
      ExpectInfinityBehind(dist2, count);
      for (const double limit : { dist2[count / 2], least, 0.0, Infinity })
      {
        std::vector<double> again(Kernels::MostPoints, -1.0);
        const std::uint64_t within =
          kernels.ToPointsWithin(points.data(), stride, count, x, limit, again.data());
        ASSERT_EQ(within, kernels.Select(dist2.data(), count, limit));
        ASSERT_TRUE(std::equal(dist2.begin(), dist2.begin() + count, again.begin()));
        ExpectInfinityBehind(again, count);
      }
    }
  }

  /** After so many distances, up to a multiple of 4. */
  static void ExpectInfinityBehind(const std::vector<double>& dist2, std::size_t count)
  {
    for (std::size_t i = count; i % 4 != 0; ++i)
    {
      ASSERT_EQ(dist2[i], Infinity);
    }
  }

  static constexpr double Infinity = std::numeric_limits<double>::infinity();
};
TYPED_TEST_SUITE(TestDistanceKernels, Dimensions);

TYPED_TEST(TestDistanceKernels, PointsToTheLastBit)
{
  TestFixture::template ForAllKernels<float>(TestFixture::template ExpectDistances<float>);
  TestFixture::template ForAllKernels<double>(TestFixture::template ExpectDistances<double>);
}

TYPED_TEST(TestDistanceKernels, SelectedAreThoseWithinTheLimit)
{
  constexpr int dim = TestFixture::Dim;
  using Kernels = DistanceKernels<dim, float>;
  const double x[4] = { 0.5, 0.5, 0.5, 0.5 };
  for (std::size_t count = 1; count <= Kernels::MostPoints; ++count)
  {
    std::vector<float> points = MakeUniformPoints<dim, float>(count, 134);
    points.insert(points.end(), Kernels::Padding, 0.5F);
    std::vector<double> dist2(Kernels::MostPoints);
    GetDistanceKernels<dim, float>().ToPoints(points.data(), count, count, x, dist2.data());
    for (const double limit : { dist2[count / 2], 0.0, TestFixture::Infinity })
    {
      TestFixture::template ForAllKernels<float>(
        [&](const Kernels& kernels)
        {
          const std::uint64_t selected = kernels.Select(dist2.data(), count, limit);
          for (std::size_t i = 0; i < 64; ++i)
          {
            ASSERT_EQ((selected >> i & 1U) != 0, i < count && dist2[i] <= limit)
              << i << " of " << count;
          }
        });
    }
  }
}

TYPED_TEST(TestDistanceKernels, SelectedIdsAreCopiedInOrder)
{
  using Kernels = DistanceKernels<TestFixture::Dim, float>;
  std::mt19937_64 random(135);
  for (std::size_t count = 1; count <= Kernels::MostPoints; ++count)
  {
    // No more memory than for these, which the address sanitizer watches.
    std::vector<PointIndex> ids(count);
    std::generate(ids.begin(), ids.end(), [&] { return static_cast<PointIndex>(random()); });
    const std::uint64_t all = ~std::uint64_t(0) >> (64 - count);
    for (const std::uint64_t selected : { all, random() & all, random() & random() & all,
           std::uint64_t(1) << (count - 1), std::uint64_t(0) })
    {
      std::vector<PointIndex> expected;
      for (std::size_t i = 0; i < count; ++i)
      {
        if ((selected >> i & 1U) != 0)
        {
          expected.push_back(ids[i]);
        }
      }
      TestFixture::template ForAllKernels<float>(
        [&](const Kernels& kernels)
        {
          std::vector<PointIndex> copied(Kernels::MostPoints);
          copied.resize(kernels.CopySelected(ids.data(), count, selected, copied.data()));
          ASSERT_EQ(copied, expected) << count << " ids";
        });
    }
  }
}

TYPED_TEST(TestDistanceKernels, BoxesAreNeverFartherThanTheyAre)
{
  TestFixture::ForReaches(TestFixture::template ExpectBoxDistances<float>,
    TestFixture::template ExpectBoxDistances<double>);
}

TYPED_TEST(TestDistanceKernels, FarthestCornersAreNeverNearerThanTheyAre)
{
  constexpr int dim = TestFixture::Dim;
  constexpr double farthest = DistanceKernels<dim, float>::FarthestPlace - 128.0;
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
      TestFixture::template ForAllKernels<float>(
        [&](const DistanceKernels<dim, float>& kernels)
        {
          constexpr double error = DistanceKernels<dim, float>::template BoxError<float>;
          const double dist2 = kernels.ToFarthestCorner(boxes, steps, octants);
          ASSERT_GE(dist2 * (1.0 + error), expected);
          ASSERT_LE(dist2, expected * (1.0 + error) + 0.06 * std::sqrt(expected) + 0.01);
        });
    }
  }
}

TYPED_TEST(TestDistanceKernels, CornersOfTheSmallestBoxesAreNeverNearerThanTheyAre)
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
    TestFixture::template ForAllKernels<float>(
      [&](const DistanceKernels<dim, float>& kernels)
      {
        constexpr double error = DistanceKernels<dim, float>::template BoxError<float>;
        ASSERT_GE(kernels.ToFarthestCorner(boxes, steps, 1U) * (1.0 + error), expected);
      });
  }
}

TYPED_TEST(TestDistanceKernels, WholeBoxesAreWithinTheLimit)
{
  TestFixture::ForReaches(
    TestFixture::template ExpectWholeBoxes<float>, TestFixture::template ExpectWholeBoxes<double>);
}

TYPED_TEST(TestDistanceKernels, NothingIsLeftOutWhereTheLimitIsNoNumber)
{
  TestFixture::template ExpectAllWhereTheLimitIsNoNumber<float>();
  TestFixture::template ExpectAllWhereTheLimitIsNoNumber<double>();
}

TYPED_TEST(TestDistanceKernels, EachIsTheFastestThatTheMachineHas)
{
  constexpr int dim = TestFixture::Dim;
  const DistanceKernels<dim, float>& plain = GetPlainDistanceKernels<dim, float>();
  const DistanceKernels<dim, float>& fastest = GetDistanceKernels<dim, float>();
  EXPECT_EQ(fastest.ToPoints != plain.ToPoints, HasAvx2());
  EXPECT_EQ(fastest.ToPointsWithin != plain.ToPointsWithin, HasAvx2());
  EXPECT_EQ(fastest.Select != plain.Select, HasAvx2());
  EXPECT_EQ(fastest.CopySelected != plain.CopySelected, HasAvx2() && sizeof(PointIndex) == 4);
  // Boxes: in space only.
  EXPECT_EQ(fastest.ToBoxes != plain.ToBoxes, HasAvx2() && dim == 3);
  EXPECT_EQ(fastest.ToBoxesFromAfar != plain.ToBoxesFromAfar, HasAvx2() && dim == 3);
  EXPECT_EQ(fastest.ToWholeBoxes != plain.ToWholeBoxes, HasAvx2() && dim == 3);
  EXPECT_EQ(fastest.ToWholeBoxesFromAfar != plain.ToWholeBoxesFromAfar, HasAvx2() && dim == 3);
  EXPECT_EQ(fastest.ToFarthestCorner != plain.ToFarthestCorner, HasAvx2() && dim == 3);
}
