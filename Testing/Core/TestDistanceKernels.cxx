// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceKernels.h"

#include "Dimensions.h"
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
      points.insert(points.end(), Kernels::Padding, static_cast<Real>(x[Dim - 1]));
      std::vector<double> dist2(Kernels::MostPoints, -1.0);
      const double least = kernels.ToPoints(points.data(), stride, count, x, dist2.data());
      double expectedLeast = INFINITY;
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
    }
  }
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
    for (const double limit : { dist2[count / 2], 0.0, std::numeric_limits<double>::infinity() })
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

TYPED_TEST(TestDistanceKernels, BoxesAreNeverFartherThanTheyAre)
{
  constexpr int dim = TestFixture::Dim;
  std::mt19937 random(132);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double reach :
    { 1.0, 300.0, 1e4, DistanceKernels<dim, double>::FarthestPlace - 128.0 })
  {
    for (int trial = 0; trial < 200; ++trial)
    {
      const ChildBoxes<dim> boxes = TestFixture::MakeBoxes(random);
      double steps[dim];
      for (double& step : steps)
      {
        step = 128.0 + reach * uniform(random);
      }
      const auto limit = static_cast<float>(reach * reach);
      TestFixture::template ForAllKernels<double>(
        [&](const DistanceKernels<dim, double>& kernels)
        {
          float dist2[TestFixture::Octants];
          const unsigned mask = kernels.ToBoxes(boxes, steps, limit, dist2);
          for (unsigned octant = 0; octant < TestFixture::Octants; ++octant)
          {
            ASSERT_EQ((mask >> octant & 1U) != 0, dist2[octant] <= limit);
            double expected = 0.0;
            for (int axis = 0; axis < dim; ++axis)
            {
              // A box ends where its last step does.
              const double below = boxes.Lower[axis][octant] - steps[axis];
              const double above = steps[axis] - (boxes.Upper[axis][octant] + 1.0);
              const double distance = std::max({ 0.0, below, above });
              expected += distance * distance;
            }
            constexpr double error = DistanceKernels<dim, double>::BoxError;
            ASSERT_LE(static_cast<double>(dist2[octant]), expected * (1.0 + error));
            // Nor so much nearer that searching would go astray.
            ASSERT_GE(
              static_cast<double>(dist2[octant]), expected - 0.06 * std::sqrt(expected) - 0.01);
          }
        });
    }
  }
}

TYPED_TEST(TestDistanceKernels, NothingIsLeftOutWhereTheLimitIsNoNumber)
{
  constexpr int dim = TestFixture::Dim;
  std::mt19937 random(133);
  const ChildBoxes<dim> boxes = TestFixture::MakeBoxes(random);
  double steps[dim];
  std::fill(std::begin(steps), std::end(steps), -1e4);
  TestFixture::template ForAllKernels<float>(
    [&](const DistanceKernels<dim, float>& kernels)
    {
      float dist2[TestFixture::Octants];
      constexpr unsigned all = (1U << TestFixture::Octants) - 1U;
      EXPECT_EQ(kernels.ToBoxes(boxes, steps, 1e4F, dist2), 0U);
      EXPECT_EQ(kernels.ToBoxes(boxes, steps, NAN, dist2), all);
    });
}
