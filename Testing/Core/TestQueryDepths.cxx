// SPDX-License-Identifier: BSD-3-Clause
#include "QueryDepths.h"

#include "Dimensions.h"
#include "OnThisThread.h"
#include "SampleTree.h"
#include "Threads.h"

using namespace hashedoctree;

namespace
{
template <int Dim, typename Real>
DepthHistogram MeasureDepths(
  const Octree<Dim>& tree, PointSpan<Dim, Real> queries, const Execution& execution)
{
  const auto keys = GetQueryKeys(tree.GetGrid(), queries, execution);
  return MeasureQueryDepths(tree, KeySpan<Dim>{ keys.GetData(), keys.GetSize() }, execution);
}
}

template <typename Dimension>
class TestQueryDepths : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Looks at all leaves for each finite position. */
  template <typename Real>
  static DepthHistogram CountByLeaves(const Octree<Dim>& tree, PointSpan<Dim, Real> queries)
  {
    DepthHistogram histogram(static_cast<std::size_t>(tree.GetDeepestDepth()) + 1, 0);
    for (std::size_t i = 0; i < queries.Count; ++i)
    {
      bool finite = true;
      for (int axis = 0; axis < Dim; ++axis)
      {
        finite = finite && std::isfinite(queries[i][axis]);
      }
      const MortonKey<Dim> key = tree.GetGrid().GetKey(queries[i]);
      ForEachLeaf(tree,
        [&](const auto& leaf)
        {
          histogram[static_cast<std::size_t>(leaf.NodeKey.GetDepth())] += finite &&
              leaf.NodeKey.GetFirstAtMaxDepth() <= key && key <= leaf.NodeKey.GetLastAtMaxDepth()
            ? 1
            : 0;
        });
    }
    return histogram;
  }
};
TYPED_TEST_SUITE(TestQueryDepths, Dimensions);

TYPED_TEST(TestQueryDepths, AreThoseOfTheLeavesThatHoldThePositions)
{
  constexpr int dim = TestFixture::Dim;
  // Around the root, and partly outside it.
  PointSample<dim, double> queries{ "queries", MakeUniformPoints<dim, double>(60, 181, -0.2, 1.2) };
  queries.Coordinates[0] = std::numeric_limits<double>::quiet_NaN();
  queries.Coordinates[2 * dim - 1] = -std::numeric_limits<double>::infinity();
  queries.Coordinates[2 * dim] = std::numeric_limits<double>::max();
  for (const auto& sample : MakePointSamples<dim, float>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, float> made(sample);
    EXPECT_EQ(MeasureDepths(made.Tree, queries.GetSpan(), Execution()),
      TestFixture::CountByLeaves(made.Tree, queries.GetSpan()));
  }
}

TYPED_TEST(TestQueryDepths, OfThePointsThemselvesAreThePointsOfTheLeaves)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& sample : MakePointSamples<dim, float>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, float> made(sample, { 3, MortonKey<dim>::MaxDepth });
    EXPECT_EQ(
      MeasureDepths(made.Tree, sample.GetSpan(), Execution()), made.Tree.GetDepthCounts().Points);
  }
}

TYPED_TEST(TestQueryDepths, ThreadsDoNotMatter)
{
  constexpr int dim = TestFixture::Dim;
  const PointSample<dim, double> sample{ "clusters", MakeClusteredPoints<dim, double>(50000, 182) };
  const SampleTree<dim, double> made(sample);
  for (const unsigned threads : { 1U, 2U, 8U })
  {
    EXPECT_EQ(MeasureDepths(made.Tree, sample.GetSpan(), Execution(OnThreads(threads))),
      made.Tree.GetDepthCounts().Points);
  }
}

TEST(TestQueryDepthsFacts, NoQueriesHaveNoWeight)
{
  const SampleTree<2, double> made(
    PointSample<2, double>{ "uniform", MakeUniformPoints<2, double>(100, 183) });
  EXPECT_EQ(MeasureDepths(made.Tree, PointSpan<2, double>(), Execution()),
    DepthHistogram(made.Tree.GetDepthCounts().Leaves.size(), 0));
}

TEST(TestQueryDepthsFacts, CanBeInterrupted)
{
  const PointSample<3, double> sample{ "uniform", MakeUniformPoints<3, double>(1000, 184) };
  const SampleTree<3, double> made(sample);
  EXPECT_THROW(GetQueryKeys(made.Tree.GetGrid(), sample.GetSpan(), MakeInterrupted()), Interrupted);
  const auto keys = GetQueryKeys(made.Tree.GetGrid(), sample.GetSpan(), Execution());
  EXPECT_THROW(
    MeasureQueryDepths(made.Tree, KeySpan<3>{ keys.GetData(), keys.GetSize() }, MakeInterrupted()),
    Interrupted);
}
