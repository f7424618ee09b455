// SPDX-License-Identifier: BSD-3-Clause
#include "RangeDepths.h"

#include "CurveBuilders.h"
#include "Dimensions.h"

#include <algorithm>
#include <functional>

using namespace hashedoctree;

namespace
{
void Add(const DepthHistogram& part, DepthHistogram& sum)
{
  sum.resize(std::max(sum.size(), part.size()));
  std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
}
}

template <typename Dimension>
class TestRangeDepths : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestRangeDepths, Dimensions);

TYPED_TEST(TestRangeDepths, CountsOfPartsAddUp)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      DepthCounts counts;
      for (std::size_t part = 0; part < builders.Trees.size(); ++part)
      {
        const CurveRange<dim> range = builders.Divided->GetRange(part);
        const DepthCounts ofPart = CountDepths(*builders.Trees[part], range, Execution());
        Add(ofPart.Leaves, counts.Leaves);
        Add(ofPart.EmptyLeaves, counts.EmptyLeaves);
        Add(ofPart.Points, counts.Points);
      }
      EXPECT_EQ(counts.Leaves, whole.GetDepthCounts().Leaves);
      EXPECT_EQ(counts.EmptyLeaves, whole.GetDepthCounts().EmptyLeaves);
      EXPECT_EQ(counts.Points, whole.GetDepthCounts().Points);
    });
}

TEST(TestRangeDepthsFacts, OfNoKeysThereIsNoDepth)
{
  const SampleTree<3, double> made(
    PointSample<3, double>{ "uniform", MakeUniformPoints<3, double>(100, 5) });
  CurveRange<3> none;
  none.Last = MortonKey<3>(none.First.GetValue() - 1);
  const DepthCounts counts = CountDepths(made.Tree, none, Execution());
  EXPECT_TRUE(counts.Leaves.empty() && counts.EmptyLeaves.empty() && counts.Points.empty());
}
