// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborCells.h"

#include "Dimensions.h"
#include "RangeCount.h"
#include "SampleTree.h"

#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestNeighborCells : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNeighborCells, Dimensions);

TYPED_TEST(TestNeighborCells, EachCellIsReachedOnceOrInALeaf)
{
  constexpr int dim = TypeParam::value;
  using Key = MortonKey<dim>;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "uniform", MakeUniformPoints<dim, double>(300, 501) });
  for (int depth = 1; depth <= made.Tree.GetDeepestDepth() + 1; ++depth)
  {
    for (std::uint32_t lower = 0; lower + 1 < (1U << depth); lower += 1 + lower / 4)
    {
      for (unsigned one = 0; one < Key::NumberOfOctants; ++one) // Axes with one cell.
      {
        NeighborCells<dim> cells;
        cells.Depth = depth;
        const auto getKey = [&cells](unsigned corner)
        {
          Cell<dim> cell;
          for (int axis = 0; axis < dim; ++axis)
          {
            const bool isUpper = (corner >> (dim - 1 - axis) & 1U) != 0;
            cell[axis] = isUpper ? cells.Upper[axis] : cells.Lower[axis];
          }
          return Key::FromCell(cell, cells.Depth);
        };
        std::set<std::uint64_t> expectedBlocks;
        std::set<std::uint64_t> expectedLeaves;
        for (int axis = 0; axis < dim; ++axis)
        {
          cells.Lower[axis] = lower;
          cells.Upper[axis] = lower + ((one >> (dim - 1 - axis) & 1U) != 0 ? 0U : 1U);
        }
        for (unsigned corner = 0; corner < Key::NumberOfOctants; ++corner)
        {
          const Key key = getKey(corner);
          const auto leaf = FindLeaf(made.Tree, key.GetFirstAtMaxDepth(), 0);
          const bool isInternal = leaf.Key.GetDepth() > depth;
          (isInternal ? expectedBlocks : expectedLeaves)
            .insert((isInternal ? key : leaf.Key).GetValue());
        }
        std::multiset<std::uint64_t> blocks;
        std::multiset<std::uint64_t> leaves;
        RangeCount<dim> count;
        ReachCells(
          made.Tree, cells, 2, EmptyOctants::Leaves, count,
          [&](unsigned corner, Key key, const auto& entry)
          {
            EXPECT_EQ(corner & ~cells.GetAxesApart(), 0U);
            EXPECT_EQ(getKey(corner), key);
            EXPECT_EQ(made.Tree.GetBlockKey(entry.Block), key);
            blocks.insert(key.GetValue());
          },
          [&](const FoundLeaf<dim>& leaf) { leaves.insert(leaf.Key.GetValue()); });
        ASSERT_EQ(
          blocks, std::multiset<std::uint64_t>(expectedBlocks.begin(), expectedBlocks.end()));
        ASSERT_EQ(
          leaves, std::multiset<std::uint64_t>(expectedLeaves.begin(), expectedLeaves.end()));
        std::uint64_t expectedCount = 0;
        for (const std::uint64_t leaf : leaves)
        {
          expectedCount +=
            static_cast<std::uint64_t>(2 + std::abs(Key(leaf).GetDepth() - std::min(2, depth)));
        }
        ASSERT_EQ(count.GetNodes(), expectedCount);
      }
    }
  }
}

TEST(TestNeighborCellsFacts, EmptyCellsOfASparseTreeAreNoLeaves)
{
  const SampleTree<2, double> made(PointSample<2, double>{ "corners", { 0.0, 0.0, 1.0, 1.0 } });
  const NeighborCells<2> cells{ { 1, 1 }, { 2, 2 }, 2 };
  std::vector<std::uint64_t> leaves;
  RangeCount<2> count;
  ReachCells(
    made.Tree, cells, 0, EmptyOctants::Missing, count,
    [](unsigned, MortonKey<2>, const auto&) { ADD_FAILURE(); },
    [&leaves](const FoundLeaf<2>& leaf) { leaves.push_back(leaf.Key.GetValue()); });
  EXPECT_EQ(leaves, (std::vector<std::uint64_t>{ 0b100, 0b111 }));
  EXPECT_EQ(count.GetNodes(), 4U * 3U);
}
