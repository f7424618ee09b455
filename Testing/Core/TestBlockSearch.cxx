// SPDX-License-Identifier: BSD-3-Clause
#include "BlockSearch.h"

#include "Dimensions.h"
#include "DirectSearch.h"
#include "SampleTree.h"

using namespace hashedoctree;

template <typename Dimension>
class TestBlockSearch : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestBlockSearch, Dimensions);

TYPED_TEST(TestBlockSearch, FindsTheDeepestInternalNodeNotBelowADepth)
{
  constexpr int dim = TypeParam::value;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    if (!made.Tree.IsRootInternal())
    {
      continue;
    }
    ForEachLeaf(made.Tree,
      [&made](const auto& leaf)
      {
        const MortonKey<dim> key = leaf.NodeKey.GetLastAtMaxDepth();
        for (int depth = 0; depth < MortonKey<dim>::MaxDepth; ++depth)
        {
          NodeCount count;
          const FoundBlock found = FindBlock(made.Tree, key, depth, count);
          // The ancestors of a leaf are internal, and nothing else above it.
          ASSERT_EQ(found.Depth, std::min(depth, leaf.NodeKey.GetDepth() - 1));
          ASSERT_EQ(made.Tree.GetBlockKey(found.Block), key.AtDepth(found.Depth));
          // The root is known without a look.
          const int looks = depth - found.Depth + (found.Depth > 0 ? 1 : 0);
          ASSERT_EQ(count.Nodes, static_cast<std::uint64_t>(looks));
        }
      });
  }
}
