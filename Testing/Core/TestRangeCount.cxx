// SPDX-License-Identifier: BSD-3-Clause
#include "RangeCount.h"

#include "AdjacentSearch.h"
#include "CurveBuilders.h"
#include "Dimensions.h"
#include "InRadiusSearch.h"

#include <set>

using namespace hashedoctree;

namespace
{
/** Which leaves a search has found. */
using Found = std::set<std::uint64_t>;

template <int Dim>
void Add(const std::vector<Neighbor<Dim>>& neighbors, const CurveRange<Dim>& range, Found& found)
{
  for (const Neighbor<Dim>& neighbor : neighbors)
  {
    if (range.Has(neighbor.Key))
    {
      EXPECT_TRUE(found.insert(neighbor.Key.GetValue()).second);
    }
  }
}

/** Expects of a search from a node, search(tree, neighbours, count), that the builders together
 * find what is found in the one tree, at the same cost. */
template <int Dim, typename Search>
void ExpectSame(const Octree<Dim>& whole, const CurveBuilders<Dim>& builders, const Search& search)
{
  std::vector<Neighbor<Dim>> neighbors;
  NodeCount expectedCount;
  search(whole, neighbors, expectedCount);
  Found expected;
  Add(neighbors, CurveRange<Dim>(), expected);

  Found found;
  std::uint64_t nodes = 0;
  for (std::size_t part = 0; part < builders.Trees.size(); ++part)
  {
    const CurveRange<Dim> range = builders.Divided->GetRange(part);
    RangeCount<Dim> count(range);
    search(*builders.Trees[part], neighbors, count);
    Add(neighbors, range, found);
    nodes += count.GetNodes();
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(nodes, expectedCount.Nodes);
}
}

template <typename Dimension>
class TestRangeCount : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestRangeCount, Dimensions);

TYPED_TEST(TestRangeCount, NeighboursAndCountsOfPartsAddUp)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      std::vector<MortonKey<dim>> leaves;
      ForEachLeaf(whole, [&](const auto& leaf) { leaves.push_back(leaf.NodeKey); });
      std::mt19937_64 random(41);
      for (int i = 0; i < 12; ++i)
      {
        const MortonKey<dim> leaf = leaves[random() % leaves.size()];
        const double side = whole.GetGrid().GetSide();
        const double radius = std::ldexp(side, -static_cast<int>(random() % 8));
        const int startDepth = static_cast<int>(random() % (MortonKey<dim>::MaxDepth + 1));
        const EmptyOctants reading =
          random() % 2 == 0 ? EmptyOctants::Leaves : EmptyOctants::Missing;
        ExpectSame(whole, builders,
          [&](const Octree<dim>& tree, auto& neighbors, auto& count)
          { FindAdjacentLeaves(tree, leaf, startDepth, neighbors, count, reading); });
        ExpectSame(whole, builders,
          [&](const Octree<dim>& tree, auto& neighbors, auto& count)
          { FindLeavesInRadius(tree, leaf, radius, startDepth, neighbors, count, reading); });
      }
    });
}
