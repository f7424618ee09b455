// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredCost.h"

#include "Dimensions.h"
#include "SampleTree.h"
#include "Threads.h"

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
      const MeasuredCost measured = MeasureCost(made.Tree, Execution(OnThreads(threads)));
      ASSERT_EQ(measured.Leaves.size(), counts.Leaves.size());
      ASSERT_EQ(measured.Points.size(), counts.Leaves.size());
      for (std::size_t depth = 0; depth < counts.Leaves.size(); ++depth)
      {
        EXPECT_EQ(measured.Leaves[depth], GetMeanCost(counts.Leaves, static_cast<int>(depth)));
        EXPECT_EQ(measured.Points[depth], GetMeanCost(counts.Points, static_cast<int>(depth)));
      }
    }
  }
}

TEST(TestMeasuredCostFacts, CanBeInterrupted)
{
  const SampleTree<3, double> made(
    PointSample<3, double>{ "uniform", MakeUniformPoints<3, double>(1000, 102) });
  const Execution execution(OnThreads(1), [](double) { return false; });
  EXPECT_THROW(MeasureCost(made.Tree, execution), Interrupted);
}
