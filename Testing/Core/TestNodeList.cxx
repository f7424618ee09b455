// SPDX-License-Identifier: BSD-3-Clause
#include "NodeList.h"

#include "Dimensions.h"
#include "SampleTree.h"
#include "Threads.h"

#include <algorithm>

using namespace hashedoctree;

template <typename Dimension>
class TestNodeList : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNodeList, Dimensions);

TYPED_TEST(TestNodeList, ListsTheNodesAskedForInOrder)
{
  constexpr int dim = TypeParam::value;
  auto samples = MakePointSamples<dim, double>();
  samples.push_back({ "three points", MakeUniformPoints<dim, double>(3, 122) });
  samples.push_back({ "many", MakeUniformPoints<dim, double>(30000, 121) });
  for (const auto& sample : samples)
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    for (const NodeListOptions options :
      { NodeListOptions{ false, false }, NodeListOptions{ true, false },
        NodeListOptions{ false, true }, NodeListOptions{ true, true },
        NodeListOptions{ false, true, 0 }, NodeListOptions{ true, true, 2 },
        NodeListOptions{ false, false, 3 }, NodeListOptions{ true, true, 31 } })
    {
      std::vector<typename Octree<dim>::Node> expected;
      ForEachNode(made.Tree,
        [&](const auto& node)
        {
          const bool isOfDepth = options.Depth < 0 || node.NodeKey.GetDepth() == options.Depth;
          if (isOfDepth &&
            (node.Internal ? options.InternalNodes : options.EmptyLeaves || !node.IsEmpty()))
          {
            expected.push_back(node);
          }
        });
      // Keys begin with a one, so that those of deeper nodes are larger.
      std::sort(expected.begin(), expected.end(),
        [](const auto& a, const auto& b) { return a.NodeKey.GetValue() < b.NodeKey.GetValue(); });
      const auto nodes = ListNodes(made.Tree, options, Execution(OnThreads(2)));
      ASSERT_EQ(nodes.GetSize(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        ASSERT_EQ(nodes[i].NodeKey, expected[i].NodeKey);
        ASSERT_EQ(nodes[i].Internal, expected[i].Internal);
        ASSERT_EQ(nodes[i].FirstPoint, expected[i].FirstPoint);
        ASSERT_EQ(nodes[i].LastPoint, expected[i].LastPoint);
      }
    }
  }
}
