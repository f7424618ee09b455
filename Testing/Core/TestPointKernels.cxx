// SPDX-License-Identifier: BSD-3-Clause
#include "PointKernels.h"

#include "Dimensions.h"
#include "Lanes.h"
#include "PointSamples.h"

using namespace hashedoctree;

template <typename Dimension>
class TestPointKernels : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Calls function(kernels) for the fastest ones and for those of every machine. */
  template <typename Real, typename Function>
  static void ForAllKernels(const Function& function)
  {
    const PointKernels<Dim, Real>& plain = GetPlainPointKernels<Dim, Real>();
    for (const auto* kernels : { &GetPointKernels<Dim, Real>(), &plain })
    {
      SCOPED_TRACE(kernels == &plain ? "plain" : "fastest");
      function(*kernels);
    }
  }

  template <typename Real>
  static void ExpectDistances(const PointKernels<Dim, Real>& kernels)
  {
    using Kernels = PointKernels<Dim, Real>;
    const double x[4] = { 0.3, -1.7, 1e6, 0.1 };
    for (std::size_t count = 1; count <= Kernels::MostPoints; ++count)
    {
      const std::size_t stride = count + count % 3;
      std::vector<Real> points = MakeUniformPoints<Dim, Real>(stride, 131);
      // What stands beyond the points must not count: these would be the nearest.
      points.reserve(points.size() + Kernels::Padding); // No more, for the address sanitizer.
      points.insert(points.end(), Kernels::Padding, static_cast<Real>(x[Dim - 1]));
      std::vector<double> dist2(Kernels::MostPoints, -1.0);
      const double least = kernels.MeasurePoints(points.data(), stride, count, x, dist2.data());
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
          kernels.MeasurePointsWithin(points.data(), stride, count, x, limit, again.data());
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
TYPED_TEST_SUITE(TestPointKernels, Dimensions);

TYPED_TEST(TestPointKernels, PointsToTheLastBit)
{
  TestFixture::template ForAllKernels<float>(TestFixture::template ExpectDistances<float>);
  TestFixture::template ForAllKernels<double>(TestFixture::template ExpectDistances<double>);
}

TYPED_TEST(TestPointKernels, SelectedAreThoseWithinTheLimit)
{
  constexpr int dim = TestFixture::Dim;
  using Kernels = PointKernels<dim, float>;
  const double x[4] = { 0.5, 0.5, 0.5, 0.5 };
  for (std::size_t count = 1; count <= Kernels::MostPoints; ++count)
  {
    std::vector<float> points = MakeUniformPoints<dim, float>(count, 134);
    points.insert(points.end(), Kernels::Padding, 0.5F);
    std::vector<double> dist2(Kernels::MostPoints);
    GetPointKernels<dim, float>().MeasurePoints(points.data(), count, count, x, dist2.data());
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

TYPED_TEST(TestPointKernels, SelectedIdsAreCopiedInOrder)
{
  using Kernels = PointKernels<TestFixture::Dim, float>;
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

TYPED_TEST(TestPointKernels, EachIsTheFastestThatTheMachineHas)
{
  constexpr int dim = TestFixture::Dim;
  const PointKernels<dim, float>& plain = GetPlainPointKernels<dim, float>();
  const PointKernels<dim, float>& fastest = GetPointKernels<dim, float>();
  EXPECT_EQ(fastest.MeasurePoints != plain.MeasurePoints, HasAvx2());
  EXPECT_EQ(fastest.MeasurePointsWithin != plain.MeasurePointsWithin, HasAvx2());
  EXPECT_EQ(fastest.Select != plain.Select, HasAvx2());
  EXPECT_EQ(fastest.CopySelected != plain.CopySelected, HasAvx2() && sizeof(PointIndex) == 4);
}
