// SPDX-License-Identifier: BSD-3-Clause
#include "DepthDecisionTree.h"

#include "RandomHistogram.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace hashedoctree;

namespace
{
/** The looks that a tree takes for each depth. */
using Costs = std::vector<int>;

/** Those of every binary search tree over [0, count). */
std::vector<Costs> ListAllTrees(int count)
{
  if (count == 0)
  {
    return { {} };
  }
  std::vector<Costs> trees;
  for (int root = 0; root < count; ++root)
  {
    for (const Costs& left : ListAllTrees(root))
    {
      for (const Costs& right : ListAllTrees(count - root - 1))
      {
        Costs costs = left;
        costs.push_back(0);
        costs.insert(costs.end(), right.begin(), right.end());
        for (int& cost : costs)
        {
          ++cost;
        }
        trees.push_back(costs);
      }
    }
  }
  return trees;
}

double GetMean(const DepthHistogram& histogram, const Costs& costs)
{
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t depth = 0; depth < histogram.size(); ++depth)
  {
    sum += static_cast<double>(histogram[depth]) * costs[depth];
    total += static_cast<double>(histogram[depth]);
  }
  return total > 0.0 ? sum / total : 0.0;
}

/** The looks for a leaf at `leaf`, counted by following the decisions. */
int CountLooks(const DepthDecisionTree& tree, int leaf)
{
  int looks = 1;
  for (int depth = tree.GetRootDepth(); depth != leaf && looks <= 64; ++looks)
  {
    depth = leaf < depth ? tree.GetHigher(depth) : tree.GetDeeper(depth);
  }
  return looks;
}
}

TEST(TestDepthDecisionTree, NoBinarySearchTreeIsCheaper)
{
  std::mt19937 random(171);
  for (int size = 1; size <= 6; ++size)
  {
    const std::vector<Costs> all = ListAllTrees(size);
    ASSERT_EQ(all.size(), (std::vector<std::size_t>{ 1, 1, 2, 5, 14, 42, 132 })[size]);
    for (int trial = 0; trial < 300; ++trial)
    {
      const DepthHistogram histogram = MakeRandomHistogram(random, static_cast<std::size_t>(size));
      double least = GetMean(histogram, all.front());
      for (const Costs& costs : all)
      {
        least = std::min(least, GetMean(histogram, costs));
      }
      ASSERT_EQ(DepthDecisionTree(histogram).GetMeanCost(), least)
        << ::testing::PrintToString(histogram);
    }
  }
}

TEST(TestDepthDecisionTree, DecisionsReachEveryDepthAtItsCost)
{
  std::mt19937 random(172);
  for (int trial = 0; trial < 500; ++trial)
  {
    const DepthHistogram histogram = MakeRandomHistogram(random, 1 + random() % 32);
    const DepthDecisionTree tree(histogram);
    Costs costs;
    for (int depth = 0; depth < 40; ++depth)
    {
      costs.push_back(CountLooks(tree, depth));
      ASSERT_EQ(tree.GetCost(depth), costs.back()) << depth;
    }
    ASSERT_EQ(tree.GetMeanCost(), GetMean(histogram, costs));
    ASSERT_LE(*std::max_element(costs.begin(), costs.end() - 8), 32) << "each depth only once";
  }
}

TEST(TestDepthDecisionTree, NoStartDepthIsCheaper)
{
  // Going child by child from any start depth is one of the trees.
  std::mt19937 random(173);
  for (int trial = 0; trial < 500; ++trial)
  {
    const DepthHistogram histogram = MakeRandomHistogram(random, 1 + random() % 32);
    const DepthDecisionTree tree(histogram);
    for (int startDepth = 0; startDepth < 32; ++startDepth)
    {
      ASSERT_LE(tree.GetMeanCost(), GetMeanCost(histogram, startDepth));
    }
    ASSERT_GE(tree.GetMeanCost(), GetEntropyBound(histogram) * (1.0 - 1e-12));
  }
}

TEST(TestDepthDecisionTree, ByHand)
{
  // The heaviest depth first, or the chain would be 3 looks long for it.
  const DepthDecisionTree tree({ 1, 2, 9, 2 });
  EXPECT_EQ(tree.GetRootDepth(), 2);
  EXPECT_EQ(tree.GetHigher(2), 1);
  EXPECT_EQ(tree.GetHigher(1), 0);
  EXPECT_EQ(tree.GetDeeper(2), 3);
  EXPECT_DOUBLE_EQ(tree.GetMeanCost(), (1 * 3 + 2 * 2 + 9 * 1 + 2 * 2) / 14.0);
  // Two places far apart: looks between them would be lost.
  const DepthDecisionTree apart({ 0, 5, 0, 0, 0, 0, 0, 6, 0 });
  EXPECT_EQ(apart.GetRootDepth(), 7);
  EXPECT_EQ(apart.GetHigher(7), 1);
  EXPECT_DOUBLE_EQ(apart.GetMeanCost(), (5 * 2 + 6) / 11.0);
}

TEST(TestDepthDecisionTree, TiesGoToTheMiddleThenToTheSmaller)
{
  EXPECT_EQ(DepthDecisionTree({ 7, 7 }).GetRootDepth(), 0);
  // 1, 3: 3 looks for two; the zeros are free.
  EXPECT_EQ(DepthDecisionTree({ 0, 1, 0, 1, 0, 0, 0 }).GetRootDepth(), 3);
  EXPECT_EQ(DepthDecisionTree({ 0, 1, 0, 1, 0 }).GetRootDepth(), 1);
}

TEST(TestDepthDecisionTree, WeightsBeyondADoubleAreExact)
{
  // As many as cells of the grid model in a quadtree of depth 31.
  constexpr std::uint64_t cells = std::uint64_t(1) << 60;
  DepthHistogram histogram(32, 0);
  histogram[1] = cells;
  histogram[2] = cells + 1;
  EXPECT_EQ(DepthDecisionTree(histogram).GetRootDepth(), 2);
  histogram[1] += 2;
  EXPECT_EQ(DepthDecisionTree(histogram).GetRootDepth(), 1);
  histogram[2] += 1;
  EXPECT_EQ(DepthDecisionTree(histogram).GetRootDepth(), 2) << "equal, and nearer to the middle";
}

TEST(TestDepthDecisionTree, WithoutWeightsIsABinarySearch)
{
  for (int size = 1; size <= 32; ++size)
  {
    const DepthDecisionTree tree(DepthHistogram(static_cast<std::size_t>(size), 0));
    EXPECT_EQ(tree.GetRootDepth(), (size - 1) / 2);
    EXPECT_EQ(tree.GetMeanCost(), 0.0);
    for (int depth = 0; depth < size; ++depth)
    {
      EXPECT_LT(1 << (tree.GetCost(depth) - 1), size + 1);
    }
  }
}

TEST(TestDepthDecisionTree, OneDepthNeedsOneLook)
{
  for (int only = 0; only < 32; ++only)
  {
    DepthHistogram histogram(static_cast<std::size_t>(only) + 1, 0);
    histogram.back() = 17;
    EXPECT_EQ(DepthDecisionTree(histogram).GetRootDepth(), only);
    EXPECT_EQ(DepthDecisionTree(histogram).GetMeanCost(), 1.0);
    EXPECT_EQ(GetEntropyBound(histogram), 0.0);
  }
}

TEST(TestDepthDecisionTree, NoDepthsAreTheRootAlone)
{
  const DepthDecisionTree tree(DepthHistogram{});
  EXPECT_EQ(tree.GetRootDepth(), 0);
  EXPECT_EQ(tree.GetDeeper(0), 1);
  EXPECT_EQ(tree.GetCost(0), 1);
  EXPECT_EQ(tree.GetCost(3), 4);
  EXPECT_EQ(tree.GetMeanCost(), 0.0);
}

TEST(TestDepthDecisionTree, EntropyByHand)
{
  EXPECT_EQ(GetEntropyBound({}), 0.0);
  EXPECT_EQ(GetEntropyBound({ 0, 0 }), 0.0);
  EXPECT_DOUBLE_EQ(GetEntropyBound({ 5, 0, 5, 5 }), 1.0);
  EXPECT_NEAR(GetEntropyBound(DepthHistogram(9, 1)), 2.0, 1e-14);
}
