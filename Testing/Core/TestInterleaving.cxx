// SPDX-License-Identifier: BSD-3-Clause
#include "Interleaving.h"

#include "Dimensions.h"

#include <gtest/gtest.h>

#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestInterleaving : public ::testing::Test
{
public:
  static constexpr int Dim = Dimension::value;
  using Key = MortonKey<Dim>;

  /** Cells anywhere, and those in the corners of the root. */
  static std::vector<Cell<Dim>> MakeCells()
  {
    constexpr std::uint32_t last = (std::uint64_t(1) << Key::MaxDepth) - 1;
    std::mt19937 random(12);
    std::vector<Cell<Dim>> cells(5000);
    for (Cell<Dim>& cell : cells)
    {
      for (std::uint32_t& coordinate : cell)
      {
        coordinate = random() & last;
      }
    }
    for (unsigned corner = 0; corner < Key::NumberOfOctants; ++corner)
    {
      for (int axis = 0; axis < Dim; ++axis)
      {
        cells[corner][axis] = (corner >> axis & 1U) != 0 ? last : 0;
      }
    }
    return cells;
  }

  /** Expects of a way to make the keys of many cells what dilation gives for each. */
  template <typename Way>
  static void ExpectKeysOfDilation(const Way& makeKeys)
  {
    const std::vector<Cell<Dim>> cells = MakeCells();
    std::vector<Key> keys(cells.size());
    makeKeys(cells.data(), cells.size(), keys.data());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      ASSERT_EQ(keys[i], Key::FromCell(cells[i], Key::MaxDepth));
    }
  }

  /** Calls function(cell, depth) for a cell of MaxDepth and those around it at all other depths. */
  template <typename Function>
  static void ForEachDepth(Cell<Dim> cell, const Function& function)
  {
    for (int depth = Key::MaxDepth; depth >= 0; --depth)
    {
      function(cell, depth);
      for (std::uint32_t& coordinate : cell)
      {
        coordinate >>= 1;
      }
    }
  }
};
TYPED_TEST_SUITE(TestInterleaving, Dimensions);

TYPED_TEST(TestInterleaving, FastestWayGivesTheKeysOfDilation)
{
  constexpr int dim = TypeParam::value;
  this->ExpectKeysOfDilation(InterleaveCells<dim>);
  for (const Cell<dim>& cell : this->MakeCells())
  {
    this->ForEachDepth(cell,
      [](const Cell<dim>& ancestor, int depth) {
        ASSERT_EQ(InterleaveCell<dim>(ancestor, depth), MortonKey<dim>::FromCell(ancestor, depth));
      });
  }
}

TYPED_TEST(TestInterleaving, DilationOfManyCells)
{
  this->ExpectKeysOfDilation(DilateCells<TypeParam::value>);
}

TYPED_TEST(TestInterleaving, DepositGivesTheKeysOfDilation)
{
  constexpr int dim = TypeParam::value;
  if (!HasPdep())
  {
    GTEST_SKIP() << "this machine has no BMI2 instructions, so there is nothing to compare";
  }
  this->ExpectKeysOfDilation(DepositCells<dim>);
  for (const Cell<dim>& cell : this->MakeCells())
  {
    this->ForEachDepth(cell,
      [](const Cell<dim>& ancestor, int depth)
      { ASSERT_EQ(DepositCell<dim>(ancestor, depth), MortonKey<dim>::FromCell(ancestor, depth)); });
  }
}

TEST(TestInterleaving, IsFastestOnlyWhereTheMachineHasIt)
{
  EXPECT_TRUE(HasPdep() || !PdepIsFastest);
}
