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
protected:
  static constexpr int Dim = Dimension::value;
  using Key = MortonKey<Dim>;

  static bool IsUpper(unsigned corner, int axis) { return (corner >> (Dim - 1 - axis) & 1U) != 0; }

  /** Cells from `lower` on along all axes: one along those of the mask `one`, else two. */
  static NeighborCells<Dim> MakeCells(int depth, std::uint32_t lower, unsigned one)
  {
    NeighborCells<Dim> cells;
    cells.Depth = depth;
    for (int axis = 0; axis < Dim; ++axis)
    {
      cells.Lower[axis] = lower;
      cells.Upper[axis] = lower + (IsUpper(one, axis) ? 0U : 1U);
    }
    return cells;
  }

  static Key GetKey(const NeighborCells<Dim>& cells, unsigned corner)
  {
    Cell<Dim> cell;
    for (int axis = 0; axis < Dim; ++axis)
    {
      cell[axis] = IsUpper(corner, axis) ? cells.Upper[axis] : cells.Lower[axis];
    }
    return Key::FromCell(cell, cells.Depth);
  }

  /** Each cell must be reached once, as a block or in a leaf, and what was looked at be counted. */
  static void ExpectReached(const Octree<Dim>& tree, const NeighborCells<Dim>& cells)
  {
    std::multiset<std::uint64_t> blocks;
    std::multiset<std::uint64_t> leaves;
    constexpr int startDepth = 2;
    RangeCount<Dim> count;
    ReachCells(
      tree, cells, startDepth, count, EmptyOctants::Leaves,
      [&](unsigned corner, Key key, const auto& entry)
      {
        EXPECT_EQ(corner & ~cells.GetAxesApart(), 0U);
        EXPECT_EQ(GetKey(cells, corner), key);
        EXPECT_EQ(tree.GetBlockKey(entry.Block), key);
        blocks.insert(key.GetValue());
      },
      [&](const FoundLeaf<Dim>& leaf) { leaves.insert(leaf.Key.GetValue()); });

    std::set<std::uint64_t> expectedBlocks;
    std::set<std::uint64_t> expectedLeaves;
    for (unsigned corner = 0; corner < Key::NumberOfOctants; ++corner)
    {
      const Key key = GetKey(cells, corner);
      const auto leaf = FindLeaf(tree, key.GetFirstAtMaxDepth(), 0);
      const bool isInternal = leaf.Key.GetDepth() > cells.Depth;
      (isInternal ? expectedBlocks : expectedLeaves)
        .insert((isInternal ? key : leaf.Key).GetValue());
    }
    ASSERT_EQ(blocks, std::multiset<std::uint64_t>(expectedBlocks.begin(), expectedBlocks.end()));
    ASSERT_EQ(leaves, std::multiset<std::uint64_t>(expectedLeaves.begin(), expectedLeaves.end()));

    std::uint64_t expectedCount = 0;
    for (const std::uint64_t leaf : leaves)
    {
      const int steps = std::abs(Key(leaf).GetDepth() - std::min(startDepth, cells.Depth));
      expectedCount += static_cast<std::uint64_t>(2 + steps);
    }
    ASSERT_EQ(count.GetNodes(), expectedCount);
  }
};
TYPED_TEST_SUITE(TestNeighborCells, Dimensions);

TYPED_TEST(TestNeighborCells, EachCellIsReachedOnceOrInALeaf)
{
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "uniform", MakeUniformPoints<dim, double>(300, 501) });
  for (int depth = 1; depth <= made.Tree.GetDeepestDepth() + 1; ++depth)
  {
    for (std::uint32_t lower = 0; lower + 1 < (1U << depth); lower += 1 + lower / 4)
    {
      for (unsigned one = 0; one < MortonKey<dim>::NumberOfOctants; ++one)
      {
        ASSERT_NO_FATAL_FAILURE(this->ExpectReached(made.Tree, this->MakeCells(depth, lower, one)));
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
    made.Tree, cells, 0, count, EmptyOctants::Missing,
    [](unsigned, MortonKey<2>, const auto&) { ADD_FAILURE(); },
    [&leaves](const FoundLeaf<2>& leaf) { leaves.push_back(leaf.Key.GetValue()); });
  EXPECT_EQ(leaves, (std::vector<std::uint64_t>{ 0b100, 0b111 }));
  EXPECT_EQ(count.GetNodes(), 4U * 3U);
}
