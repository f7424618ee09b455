// SPDX-License-Identifier: BSD-3-Clause
#include "LeafNumbers.h"

#include "Dimensions.h"
#include "NodeList.h"
#include "SampleTree.h"

#include <stdexcept>

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
    for (const EmptyOctants reading : { EmptyOctants::Missing, EmptyOctants::Leaves })
    {
      const LeafNumbers<dim> numbers(made.Tree, reading);
      EXPECT_EQ(numbers.GetBytes(), sizeof(PointIndex) * made.Tree.GetNumberOfInternalNodes());
      const bool all = reading == EmptyOctants::Leaves;
      const auto leaves = ListNodes(made.Tree, NodeListOptions{ all, false }, Execution());
      for (std::size_t i = 0; i < leaves.GetSize(); ++i)
      {
        const auto leaf = FindLeaf(made.Tree, leaves[i].NodeKey.GetFirstAtMaxDepth(), 0, reading);
        ASSERT_TRUE(leaf.Exists);
        ASSERT_EQ(numbers.Get(made.Tree, leaf), i);
      }
    }
  }
}

TEST(TestLeafNumbersFacts, MoreLeavesThanCanBeNumberedAreAnError)
{
  if (sizeof(PointIndex) > 4)
  {
    GTEST_SKIP() << "no memory holds too many for 64 bits";
  }
  const SampleTree<3, double> made(
    PointSample<3, double>{ "uniform", MakeUniformPoints<3, double>(10, 235) });
  // What the tree says of their number is looked at, and no more.
  auto& counts = const_cast<DepthCounts&>(made.Tree.GetDepthCounts());
  counts.Leaves.back() += std::uint64_t(1) << 32;
  EXPECT_THROW(LeafNumbers<3>(made.Tree, EmptyOctants::Leaves), std::length_error);
  EXPECT_NO_THROW(LeafNumbers<3>(made.Tree, EmptyOctants::Missing));
}
