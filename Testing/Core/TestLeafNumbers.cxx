// SPDX-License-Identifier: BSD-3-Clause
#include "LeafNumbers.h"

#include "Dimensions.h"
#include "DirectSearch.h"
#include "NodeList.h"
#include "SampleTree.h"

using namespace hashedoctree;

template <typename Dimension>
class TestLeafNumbers : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestLeafNumbers, Dimensions);

TYPED_TEST(TestLeafNumbers, AreThePlacesInTheListOfLeaves)
{
  constexpr int dim = TypeParam::value;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    const LeafNumbers<dim> numbers(made.Tree);
    EXPECT_EQ(numbers.GetBytes(), sizeof(PointIndex) * made.Tree.GetNumberOfInternalNodes());
    if (!made.Tree.IsRootInternal())
    {
      continue; // No block describes the root.
    }
    const auto leaves = ListNodes(made.Tree, NodeListOptions{ false, false }, Execution());
    for (std::size_t i = 0; i < leaves.GetSize(); ++i)
    {
      const auto leaf = FindLeaf(made.Tree, leaves[i].NodeKey.GetFirstAtMaxDepth(), 0);
      ASSERT_EQ(
        numbers.Get(made.Tree.GetBlock(leaf.ParentBlock), leaf.ParentBlock, leaf.Key.GetOctant()),
        i);
    }
  }
}
