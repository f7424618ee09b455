// SPDX-License-Identifier: BSD-3-Clause
#include "NodeStartDepths.h"

#include "AdjacentSearch.h"
#include "BruteForceNeighbors.h"
#include "Dimensions.h"
#include "OnThisThread.h"
#include "SampleTree.h"
#include "Threads.h"

using namespace hashedoctree;

namespace
{
/** Calls function(node, block, octant) for every node but the root. */
template <int Dim, typename Function>
void ForEachChild(const Octree<Dim>& tree, const Function& function)
{
  for (std::size_t block = 0; block < tree.GetNumberOfInternalNodes(); ++block)
  {
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      function(tree.GetBlockKey(block).GetChild(octant), block, octant);
    }
  }
}

template <int Dim>
std::uint64_t CountNodes(const Octree<Dim>& tree, MortonKey<Dim> node, int startDepth)
{
  std::vector<Neighbor<Dim>> found;
  NodeCount count;
  FindAdjacentLeaves(tree, node, startDepth, found, count);
  return count.Nodes;
}
}

template <typename Dimension>
class TestNodeStartDepths : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNodeStartDepths, Dimensions);

TYPED_TEST(TestNodeStartDepths, AreTheMediansOfTheLeavesAbove)
{
  constexpr int dim = TypeParam::value;
  for (const auto& coordinates :
    { MakeUniformPoints<dim, double>(60, 801), MakeClusteredPoints<dim, double>(12, 802) })
  {
    const SampleTree<dim, double> made(PointSample<dim, double>{ "few", coordinates });
    const BruteForceNeighbors<dim> oracle(made.Tree);
    const NodeStartDepths<dim> starts(made.Tree, Execution());
    ForEachChild(made.Tree,
      [&](MortonKey<dim> node, std::size_t block, unsigned octant)
      {
        std::vector<int> above; // In order: smaller keys are of smaller depth.
        for (const std::uint64_t key : oracle.FindAdjacent(node, EmptyOctants::Leaves))
        {
          const int depth = MortonKey<dim>(key).GetDepth();
          if (depth < node.GetDepth())
          {
            above.push_back(depth);
          }
        }
        ASSERT_EQ(starts.Get(block, octant), above.empty() ? 0 : above[(above.size() - 1) / 2]);
      });
  }
}

TYPED_TEST(TestNodeStartDepths, NoOtherExaminesFewerNodes)
{
  constexpr int dim = TypeParam::value;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample, { 3, MortonKey<dim>::MaxDepth });
    const NodeStartDepths<dim> starts(made.Tree, Execution());
    EXPECT_EQ(starts.GetBytes(), made.Tree.GetNumberOfNodes() - 1);
    ForEachChild(made.Tree,
      [&](MortonKey<dim> node, std::size_t block, unsigned octant)
      {
        const std::uint64_t fewest = CountNodes(made.Tree, node, starts.Get(block, octant));
        for (int startDepth = 0; startDepth <= made.Tree.GetDeepestDepth(); ++startDepth)
        {
          ASSERT_LE(fewest, CountNodes(made.Tree, node, startDepth));
        }
      });
  }
}

TYPED_TEST(TestNodeStartDepths, LeavesCostLessThanFromTheMedianOfTheTree)
{
  constexpr int dim = TypeParam::value;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "clusters", MakeClusteredPoints<dim, double>(400, 811) });
  const NodeStartDepths<dim> starts(made.Tree, Execution());
  const int median = GetMedianDepth(made.Tree.GetDepthCounts().Leaves);
  std::uint64_t own = 0;
  std::uint64_t ofTree = 0;
  ForEachChild(made.Tree,
    [&](MortonKey<dim> node, std::size_t block, unsigned octant)
    {
      if (!made.Tree.GetChild(block, octant).Internal)
      {
        own += CountNodes(made.Tree, node, starts.Get(block, octant));
        ofTree += CountNodes(made.Tree, node, median);
      }
    });
  EXPECT_LT(own, ofTree);
}

TYPED_TEST(TestNodeStartDepths, AreTheSameOnThreads)
{
  constexpr int dim = TypeParam::value;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "sphere", MakeSpherePoints<dim, double>(600, 821) });
  const NodeStartDepths<dim> starts(made.Tree, Execution());
  const NodeStartDepths<dim> onThreads(made.Tree, Execution(OnThreads(3)));
  ForEachChild(made.Tree,
    [&](MortonKey<dim>, std::size_t block, unsigned octant)
    { ASSERT_EQ(onThreads.Get(block, octant), starts.Get(block, octant)); });
}

TEST(TestNodeStartDepthsFacts, StopsWhenAsked)
{
  const SampleTree<3, double> made(
    PointSample<3, double>{ "uniform", MakeUniformPoints<3, double>(100, 831) });
  EXPECT_THROW(NodeStartDepths<3>(made.Tree, MakeInterrupted()), Interrupted);
}

TEST(TestNodeStartDepthsFacts, TreesOfOneLeafNeedNone)
{
  const Octree<3> tree;
  EXPECT_EQ(NodeStartDepths<3>(tree, Execution()).GetBytes(), 0U);
  EXPECT_EQ(NodeStartDepths<3>().GetBytes(), 0U);
}
