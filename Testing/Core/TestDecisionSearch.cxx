// SPDX-License-Identifier: BSD-3-Clause
#include "DecisionSearch.h"

#include "Dimensions.h"
#include "SampleTree.h"

using namespace hashedoctree;

template <typename Dimension>
class TestDecisionSearch : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Trees that know the leaves, do not, or stop above them. */
  static std::vector<DepthDecisionTree> MakeDecisions(const DepthCounts& counts)
  {
    return { DepthDecisionTree(counts.Leaves), DepthDecisionTree(counts.Points),
      DepthDecisionTree(DepthHistogram(counts.Leaves.size(), 0)), DepthDecisionTree({ 1, 2, 3 }),
      DepthDecisionTree(DepthHistogram{}),
      DepthDecisionTree(DepthHistogram(MortonKey<Dim>::MaxDepth + 1, 1)) };
  }
};
TYPED_TEST_SUITE(TestDecisionSearch, Dimensions);

TYPED_TEST(TestDecisionSearch, AnyDecisionsFindEveryLeafAtTheirCost)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    for (const DepthDecisionTree& decisions :
      TestFixture::MakeDecisions(made.Tree.GetDepthCounts()))
    {
      ForEachLeaf(made.Tree,
        [&made, &decisions](const auto& leaf)
        {
          const int depth = leaf.NodeKey.GetDepth();
          for (const MortonKey<dim> key :
            { leaf.NodeKey.GetFirstAtMaxDepth(), leaf.NodeKey.GetLastAtMaxDepth() })
          {
            NodeCount count;
            const FoundLeaf<dim> found = FindLeaf(made.Tree, key, decisions, count);
            const FoundLeaf<dim> linear = FindLeaf(made.Tree, key, decisions.GetRootDepth());
            ASSERT_EQ(found.Key, leaf.NodeKey);
            ASSERT_TRUE(found.Exists);
            ASSERT_EQ(found.ParentBlock, linear.ParentBlock);
            ASSERT_EQ(count.Nodes, static_cast<std::uint64_t>(decisions.GetCost(depth)));

            const FoundLeaf<dim> sparse =
              FindLeaf(made.Tree, key, decisions, count, EmptyOctants::Missing);
            ASSERT_EQ(sparse.Key, leaf.NodeKey);
            ASSERT_EQ(sparse.Exists, !leaf.IsEmpty());
          }
        });
    }
  }
}

TYPED_TEST(TestDecisionSearch, MeasuredMeanIsThePredictedOneToTheLastDigit)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    const DepthCounts& counts = made.Tree.GetDepthCounts();
    const DepthDecisionTree byLeaves(counts.Leaves);
    const DepthDecisionTree byPoints(counts.Points);
    NodeCount forLeaves;
    std::uint64_t forPoints = 0;
    ForEachLeaf(made.Tree,
      [&](const auto& leaf)
      {
        NodeCount count;
        FindLeaf(made.Tree, leaf.NodeKey.GetFirstAtMaxDepth(), byPoints, count);
        forPoints += count.Nodes * leaf.GetNumberOfPoints();
        FindLeaf(made.Tree, leaf.NodeKey.GetFirstAtMaxDepth(), byLeaves, forLeaves);
      });
    EXPECT_EQ(
      static_cast<double>(forLeaves.Nodes) / static_cast<double>(made.Tree.GetNumberOfLeaves()),
      byLeaves.GetMeanCost());
    EXPECT_LE(byLeaves.GetMeanCost(), GetMeanCost(counts.Leaves, GetMedianDepth(counts.Leaves)));
    if (made.Tree.GetNumberOfPoints() > 0)
    {
      EXPECT_EQ(static_cast<double>(forPoints) / static_cast<double>(made.Tree.GetNumberOfPoints()),
        byPoints.GetMeanCost());
    }
  }
}
