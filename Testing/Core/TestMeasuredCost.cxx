// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCost.h"

#include "Dimensions.h"
#include "DirectSearch.h"
#include "OnThisThread.h"
#include "SampleTree.h"
#include "Threads.h"

#include <algorithm>

using namespace hashedoctree;

template <typename Dimension>
class TestMeasuredCost : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestMeasuredCost, Dimensions);

TYPED_TEST(TestMeasuredCost, EqualsTheModelToTheLastDigit)
{
  constexpr int dim = TypeParam::value;
  auto samples = MakePointSamples<dim, double>();
  samples.push_back({ "many", MakeClusteredPoints<dim, double>(20000, 101) });
  for (const auto& sample : samples)
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    const DepthCounts& counts = made.Tree.GetDepthCounts();
    for (const unsigned threads : { 1U, 4U })
    {
      const MeasuredCost measured = MeasureCost<dim>(made.Tree, Execution(OnThreads(threads)));
      const std::size_t startDepths = std::max<std::size_t>(counts.Leaves.size(), 2);
      ASSERT_EQ(measured.Leaves.size(), startDepths);
      ASSERT_EQ(measured.Points.size(), startDepths);
      for (std::size_t depth = 0; depth < startDepths; ++depth)
      {
        EXPECT_EQ(measured.Leaves[depth], GetMeanCost(counts.Leaves, static_cast<int>(depth)));
        EXPECT_EQ(measured.Points[depth], GetMeanCost(counts.Points, static_cast<int>(depth)));
      }
    }
  }
}

TYPED_TEST(TestMeasuredCost, EqualsSearchesMadeOneByOne)
{
  constexpr int dim = TypeParam::value;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "clustered", MakeClusteredPoints<dim, double>(2000, 103) });
  const MeasuredCost measured = MeasureCost<dim>(made.Tree, Execution(OnThisThread));
  for (int startDepth = 0; startDepth <= made.Tree.GetDeepestDepth(); ++startDepth)
  {
    std::uint64_t leaves = 0;
    std::uint64_t points = 0;
    for (std::size_t block = 0; block < made.Tree.GetNumberOfInternalNodes(); ++block)
    {
      for (unsigned octant = 0; octant < Octree<dim>::NumberOfOctants; ++octant)
      {
        const auto leaf = made.Tree.GetChild(block, octant);
        const std::uint64_t nodes = leaf.Internal
          ? 0
          : CountExaminedNodes(made.Tree, leaf.NodeKey.GetFirstAtMaxDepth(), startDepth);
        leaves += nodes;
        points += nodes * leaf.GetNumberOfPoints();
      }
    }
    const auto depth = static_cast<std::size_t>(startDepth);
    EXPECT_EQ(measured.Leaves[depth],
      static_cast<double>(leaves) / static_cast<double>(made.Tree.GetNumberOfLeaves()));
    EXPECT_EQ(measured.Points[depth],
      static_cast<double>(points) / static_cast<double>(made.Tree.GetNumberOfPoints()));
  }
}

TEST(TestMeasuredCostFacts, CanBeInterrupted)
{
  const SampleTree<3, double> made(
    PointSample<3, double>{ "uniform", MakeUniformPoints<3, double>(1000, 102) });
  EXPECT_THROW(MeasureCost<3>(made.Tree, MakeInterrupted()), Interrupted);
}
