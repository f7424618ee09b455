// SPDX-License-Identifier: BSD-3-Clause
#include "NodeWalk.h"

#include "Dimensions.h"
#include "NodeList.h"
#include "OnThisThread.h"
#include "SampleTree.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace hashedoctree;

namespace
{
template <int Dim>
using Nodes = Buffer<typename Octree<Dim>::Node>;

/** Walks along the nodes from a place on and compares with places that were sorted. */
template <int Dim>
void CheckWalk(const Nodes<Dim>& nodes, std::size_t begin)
{
  std::vector<std::size_t> expected(nodes.GetSize() - begin);
  std::iota(expected.begin(), expected.end(), begin);
  std::stable_sort(expected.begin(), expected.end(),
    [&nodes](std::size_t a, std::size_t b)
    { return nodes[a].NodeKey.GetFirstAtMaxDepth() < nodes[b].NodeKey.GetFirstAtMaxDepth(); });
  NodeWalk<Dim> walk(nodes, begin, Execution());
  for (const std::size_t place : expected)
  {
    ASSERT_EQ(walk.Next(), place);
  }
}

/** Walks along all nodes, along all but one, and along none. */
template <int Dim>
void CheckWalks(const Nodes<Dim>& nodes)
{
  for (const std::size_t begin : { std::size_t(0), std::size_t(1), nodes.GetSize() })
  {
    SCOPED_TRACE(begin);
    CheckWalk<Dim>(nodes, std::min(begin, nodes.GetSize()));
  }
}
}

template <typename Dimension>
class TestNodeWalk : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNodeWalk, Dimensions);

TYPED_TEST(TestNodeWalk, FollowsTheCurveWhateverTheOrderOfTheList)
{
  constexpr int dim = TypeParam::value;
  auto samples = MakePointSamples<dim, double>();
  samples.push_back({ "many", MakeUniformPoints<dim, double>(3000, 123) });
  std::mt19937 random(124);
  for (const auto& sample : samples)
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    Nodes<dim> nodes = ListNodes(made.Tree, NodeListOptions{ true, true }, Execution());
    CheckWalks<dim>(nodes);
    std::reverse(nodes.GetData(), nodes.GetData() + nodes.GetSize());
    CheckWalks<dim>(nodes);
    std::shuffle(nodes.GetData(), nodes.GetData() + nodes.GetSize(), random);
    CheckWalks<dim>(nodes);
  }
}

TYPED_TEST(TestNodeWalk, WalksAlongNoNodesAndToTheLastCellOfAll)
{
  constexpr int dim = TypeParam::value;
  using Key = MortonKey<dim>;
  CheckWalks<dim>(Nodes<dim>());
  const Key last = Key::Root().GetLastAtMaxDepth();
  Nodes<dim> nodes(4);
  std::size_t place = 0;
  for (const Key key : { last, Key::Root(), last.GetParent(), Key::Root().GetFirstAtMaxDepth() })
  {
    nodes[place++] = { key, 0, 0, false };
  }
  CheckWalks<dim>(nodes);
}

TEST(TestNodeWalkFacts, LooksAtAnAbortWhileItFindsThePieces)
{
  constexpr std::size_t manyNodes = 1000000;
  Nodes<3> nodes(manyNodes);
  std::fill_n(nodes.GetData(), manyNodes, Octree<3>::Node{ MortonKey<3>::Root(), 0, 0, false });
  std::vector<double> looks;
  const auto walk = [&nodes, &looks](std::size_t looksToStop)
  {
    looks.clear();
    const auto look = [&looks, looksToStop](double fraction)
    {
      looks.push_back(fraction);
      return looks.size() < looksToStop;
    };
    NodeWalk<3>(nodes, 0, Execution(OnThisThread, look));
  };
  walk(manyNodes);
  EXPECT_EQ(looks.front(), 0.0);
  EXPECT_GE(looks.back(), 0.9);
  for (std::size_t i = 1; i < looks.size(); ++i)
  {
    EXPECT_GT(looks[i], looks[i - 1]);
    EXPECT_LT(looks[i], looks[i - 1] + 0.1);
  }
  EXPECT_THROW(walk(5), Interrupted);
  EXPECT_EQ(looks.size(), 5U);
}
