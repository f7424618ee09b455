// SPDX-License-Identifier: BSD-3-Clause
#include "KeyedPoints.h"

#include "Dimensions.h"
#include "PointSamples.h"
#include "Threads.h"

using namespace hashedoctree;

template <typename Dimension>
class TestKeyedPoints : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestKeyedPoints, Dimensions);

TYPED_TEST(TestKeyedPoints, KeepsTheSelectedPointsInOrder)
{
  constexpr int dim = TypeParam::value;
  // More than one chunk, with gaps at the ends of chunks.
  constexpr std::size_t chunk = PointSelection<dim>::ChunkSize;
  PointSample<dim, double> sample{ "gaps", MakeUniformPoints<dim, double>(3 * chunk + 5, 13) };
  for (const std::size_t gap : { std::size_t(0), chunk - 1, chunk, 2 * chunk + 7, 3 * chunk + 4 })
  {
    sample.Coordinates[dim * gap] = std::numeric_limits<double>::quiet_NaN();
  }
  const PointSelection<dim> selection(sample.GetSpan(), {}, Execution());
  const Grid<dim> grid(selection.GetBox());
  for (const unsigned threads : { 1U, 2U, 8U })
  {
    const Buffer<KeyedPoint<dim>> keyed =
      MakeKeyedPoints(sample.GetSpan(), selection, grid, Execution(OnThreads(threads)));
    ASSERT_EQ(keyed.GetSize(), 3 * chunk);
    std::size_t next = 0;
    for (std::uint32_t id = 0; id < 3 * chunk + 5; ++id)
    {
      if (selection.Keeps(sample.GetSpan()[id]))
      {
        ASSERT_EQ(keyed[next].GetId(), id);
        ASSERT_EQ(keyed[next].GetKey(), grid.GetKey(sample.GetSpan()[id]));
        ++next;
      }
    }
    EXPECT_EQ(next, keyed.GetSize());
  }
}
