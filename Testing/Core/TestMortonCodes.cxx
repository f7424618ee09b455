// SPDX-License-Identifier: BSD-3-Clause
#include "MortonCodes.h"

#include "Dimensions.h"
#include "PointSamples.h"
#include "Threads.h"

using namespace hashedoctree;

template <typename Dimension>
class TestMortonCodes : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestMortonCodes, Dimensions);

TYPED_TEST(TestMortonCodes, DilationMovesEachBitAndBack)
{
  constexpr int dim = TypeParam::value;
  constexpr int bits = MortonKey<dim>::MaxDepth;
  std::mt19937 random(11);
  for (std::uint32_t trial = 0; trial < (1U << 17); ++trial)
  {
    // All 16-bit integers, then any that fit.
    const std::uint32_t x =
      (trial < (1U << 16) ? trial : random()) & ((std::uint64_t(1) << bits) - 1);
    std::uint64_t expected = 0;
    for (int bit = 0; bit < bits; ++bit)
    {
      expected |= std::uint64_t(x >> bit & 1U) << (dim * bit);
    }
    ASSERT_EQ(Dilation<dim>::Spread(x), expected) << x;
    ASSERT_EQ(Dilation<dim>::Contract(expected), x);
    // Bits of the other axes must not disturb.
    ASSERT_EQ(Dilation<dim>::Contract(expected | ~Dilation<dim>::Mask(1)), x);
  }
}

TYPED_TEST(TestMortonCodes, PdepAgreesWithDilation)
{
  constexpr int dim = TypeParam::value;
  if (!HasPdep())
  {
    GTEST_SKIP() << "this machine has no BMI2 instructions, so there is nothing to compare";
  }
  std::mt19937 random(12);
  std::vector<Cell<dim>> cells(5000);
  for (Cell<dim>& cell : cells)
  {
    for (std::uint32_t& coordinate : cell)
    {
      coordinate = random() & ((std::uint64_t(1) << MortonKey<dim>::MaxDepth) - 1);
    }
  }
  std::vector<MortonKey<dim>> dilated(cells.size());
  std::vector<MortonKey<dim>> deposited(cells.size());
  InterleaveCells<dim>(cells.data(), cells.size(), dilated.data(), Interleaving::Dilation);
  InterleaveCells<dim>(cells.data(), cells.size(), deposited.data(), Interleaving::Pdep);
  EXPECT_EQ(dilated, deposited);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    ASSERT_EQ(dilated[i], MortonKey<dim>::FromCell(cells[i], MortonKey<dim>::MaxDepth));
  }
}

TEST(TestInterleaving, FastestOneCanRun)
{
  EXPECT_TRUE(GetFastestInterleaving() == Interleaving::Dilation || HasPdep());
}

TYPED_TEST(TestMortonCodes, EncodesTheSelectedPointsInOrder)
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
    const Buffer<CodedPoint<dim>> coded =
      EncodePoints(sample.GetSpan(), selection, grid, Execution(OnThreads(threads)));
    ASSERT_EQ(coded.GetSize(), 3 * chunk);
    std::size_t next = 0;
    for (std::uint32_t id = 0; id < 3 * chunk + 5; ++id)
    {
      if (selection.Keeps(sample.GetSpan()[id]))
      {
        ASSERT_EQ(coded[next].Id, id);
        ASSERT_EQ(coded[next].Key, grid.GetKey(sample.GetSpan()[id]));
        ++next;
      }
    }
    EXPECT_EQ(next, coded.GetSize());
  }
}
