// SPDX-License-Identifier: BSD-3-Clause
#include "StartDepths.h"

#include "Dimensions.h"
#include "DirectSearch.h"
#include "SampleTree.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

using namespace hashedoctree;

namespace
{
template <int Dim = 3>
PointSample<Dim, double> MakeSample()
{
  return { "two densities", MakeTwoDensities<Dim, double>(8000, 161, 1.0 / 512.0) };
}

MortonKey<3> GetKey(const Octree<3>& tree, const Position<3>& x)
{
  return tree.GetGrid().GetKey(x.data());
}
}

template <typename Dimension>
class TestStartDepths : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestStartDepths, Dimensions);

TEST(TestStartDepthsFacts, OneForTheTreeByEachModel)
{
  const SampleTree<3, double> made(MakeSample());
  const MortonKey<3> key = GetKey(made.Tree, { 0.4, 0.7, 0.2 });
  for (const FrequencyModel frequency :
    { FrequencyModel::Leaves, FrequencyModel::Points, FrequencyModel::Grid })
  {
    const DepthHistogram histogram = GetDepthHistogram(made.Tree.GetDepthCounts(), frequency, 3);
    const std::map<StartDepthModel, int> expected{ { StartDepthModel::Root, 0 },
      { StartDepthModel::Median, GetMedianDepth(histogram) },
      { StartDepthModel::Mean, GetMeanDepth(histogram) }, { StartDepthModel::Fixed, 7 } };
    for (const auto& [model, depth] : expected)
    {
      const StartDepths<3> starts(made.Tree, { model, frequency, 7 });
      EXPECT_EQ(starts.Get(key), depth);
      EXPECT_EQ(starts.GetOfTree(), depth);
    }
  }
  EXPECT_EQ(StartDepths<3>().Get(key), 0);
}

TYPED_TEST(TestStartDepths, LocalIsTheWeightedMedianOfTheLeavesNearby)
{
  constexpr int dim = TypeParam::value;
  const SampleTree<dim, double> made(MakeSample<dim>());
  constexpr int depth = StartDepths<dim>::LocalDepth;
  const int deepest = made.Tree.GetDeepestDepth();
  // By coarse cell; without points, all leaves weigh the same.
  std::map<std::uint64_t, std::array<DepthHistogram, 3>> histograms;
  ForEachNode(made.Tree,
    [&](const auto& node)
    {
      const int nodeDepth = node.NodeKey.GetDepth();
      if (!node.Internal && nodeDepth >= depth)
      {
        const std::uint64_t weights[]{ 1, node.GetNumberOfPoints(),
          std::uint64_t(1) << (dim * (deepest - nodeDepth)) };
        auto& ofCell = histograms[node.NodeKey.GetFirstAtMaxDepth().AtDepth(depth).GetValue()];
        for (std::size_t model = 0; model < ofCell.size(); ++model)
        {
          ofCell[model].resize(MortonKey<dim>::MaxDepth + 1);
          ofCell[model][static_cast<std::size_t>(nodeDepth)] += weights[model];
        }
      }
    });
  std::array<int, 3> without{};
  for (std::size_t model = 0; model < without.size(); ++model)
  {
    const StartDepths<dim> starts(
      made.Tree, { StartDepthModel::Local, static_cast<FrequencyModel>(model), 0 });
    for (const auto& [key, ofCell] : histograms)
    {
      const bool hasWeight = GetTotal(ofCell[model]) > 0;
      without[model] += hasWeight ? 0 : 1;
      ASSERT_EQ(starts.Get(MortonKey<dim>(key).GetFirstAtMaxDepth()),
        GetMedianDepth(ofCell[hasWeight ? model : 0]))
        << model;
    }
    EXPECT_EQ(starts.GetBytes(), 4096U);
    EXPECT_EQ(starts.GetOfTree(),
      GetMedianDepth(
        GetDepthHistogram(made.Tree.GetDepthCounts(), static_cast<FrequencyModel>(model), dim)));
  }
  EXPECT_GT(histograms.size(), 1000U);
  EXPECT_GT(without[1], 10);
  EXPECT_EQ(without[0] + without[2], 0);
}

TYPED_TEST(TestStartDepths, LocalTakesTheDepthOfALeafThatIsLarger)
{
  constexpr int dim = TypeParam::value;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "corner", MakeClusteredPoints<dim, double>(500, 163) });
  for (const FrequencyModel frequency :
    { FrequencyModel::Leaves, FrequencyModel::Points, FrequencyModel::Grid })
  {
    const StartDepths<dim> starts(made.Tree, { StartDepthModel::Local, frequency, 0 });
    int larger = 0;
    for (std::uint64_t cell = 0; cell < 4096; ++cell)
    {
      const MortonKey<dim> key = MortonKey<dim>(4096 + cell).GetFirstAtMaxDepth();
      const auto leaf = FindLeaf(made.Tree, key, 0);
      if (leaf.Key.GetDepth() <= StartDepths<dim>::LocalDepth)
      {
        EXPECT_EQ(starts.Get(key), leaf.Key.GetDepth());
        ++larger;
      }
    }
    EXPECT_GT(larger, 100);
  }
}

TYPED_TEST(TestStartDepths, LocalOfAShallowTreeHasCellsLikeItsDeepestLeaves)
{
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : { 0, 1, 12 })
  {
    const SampleTree<dim, double> made(
      PointSample<dim, double>{ "few", MakeUniformPoints<dim, double>(count, 164) }, { 4 });
    const int deepest = made.Tree.GetDeepestDepth();
    ASSERT_LT(deepest, StartDepths<dim>::LocalDepth);
    const StartDepths<dim> starts(made.Tree, { StartDepthModel::Local, FrequencyModel::Leaves, 0 });
    const std::uint64_t cells = std::uint64_t(1) << (dim * deepest);
    EXPECT_EQ(starts.GetBytes(), cells);
    for (std::uint64_t cell = 0; cell < cells; ++cell)
    {
      const MortonKey<dim> key = MortonKey<dim>(cells + cell).GetLastAtMaxDepth();
      EXPECT_EQ(starts.Get(key), FindLeaf(made.Tree, key, 0).Key.GetDepth());
    }
  }
}

TEST(TestStartDepthsFacts, LocalCostsLessWhereDensityVaries)
{
  const SampleTree<3, double> made(MakeSample());
  const StartDepths<3> median(made.Tree, {});
  const StartDepths<3> local(made.Tree, { StartDepthModel::Local, FrequencyModel::Leaves, 0 });
  std::uint64_t medianCost = 0;
  std::uint64_t localCost = 0;
  ForEachNode(made.Tree,
    [&](const auto& node)
    {
      if (!node.Internal)
      {
        const MortonKey<3> key = node.NodeKey.GetFirstAtMaxDepth();
        medianCost += CountExaminedNodes(made.Tree, key, median.Get(key));
        localCost += CountExaminedNodes(made.Tree, key, local.Get(key));
      }
    });
  EXPECT_LT(localCost, medianCost);
}

TEST(TestStartDepthsFacts, MeanCostIsThatOfSearchesForTheLeaves)
{
  const SampleTree<3, double> made(MakeSample());
  for (const StartDepthModel model : { StartDepthModel::Median, StartDepthModel::Mean,
         StartDepthModel::Root, StartDepthModel::Fixed, StartDepthModel::Local })
  {
    const StartDepths<3> starts(made.Tree, { model, FrequencyModel::Leaves, 7 });
    double forLeaves = 0.0;
    double forPoints = 0.0;
    double forGrid = 0.0;
    ForEachLeaf(made.Tree,
      [&](const auto& leaf)
      {
        const MortonKey<3> key = leaf.NodeKey.GetLastAtMaxDepth();
        const auto nodes = static_cast<double>(CountExaminedNodes(made.Tree, key, starts.Get(key)));
        forLeaves += nodes;
        forPoints += nodes * static_cast<double>(leaf.GetNumberOfPoints());
        forGrid += nodes * std::ldexp(1.0, -3 * leaf.NodeKey.GetDepth());
      });
    EXPECT_EQ(starts.GetMeanCost(made.Tree, FrequencyModel::Leaves),
      forLeaves / static_cast<double>(made.Tree.GetNumberOfLeaves()));
    EXPECT_EQ(starts.GetMeanCost(made.Tree, FrequencyModel::Points),
      forPoints / static_cast<double>(made.Tree.GetNumberOfPoints()));
    EXPECT_NEAR(starts.GetMeanCost(made.Tree, FrequencyModel::Grid), forGrid, 1e-12);
  }
}

TEST(TestStartDepthsFacts, TreesOfOneLeaf)
{
  for (const std::size_t count : { 0U, 1U })
  {
    const SampleTree<3, double> made(
      PointSample<3, double>{ "few", MakeUniformPoints<3, double>(count, 164) });
    const StartDepths<3> starts(made.Tree, { StartDepthModel::Local, FrequencyModel::Points, 0 });
    EXPECT_EQ(starts.Get(MortonKey<3>::Root().GetLastAtMaxDepth()), 0);
    EXPECT_EQ(starts.GetMeanCost(made.Tree, FrequencyModel::Leaves), 1);
    EXPECT_EQ(starts.GetMeanCost(made.Tree, FrequencyModel::Points), count);
  }
}
