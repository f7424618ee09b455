// SPDX-License-Identifier: BSD-3-Clause
#include "SearchComparison.h"

#include "Dimensions.h"
#include "QueryDepths.h"
#include "SampleTree.h"

using namespace hashedoctree;

namespace
{
template <int Dim>
SearchComparison<Dim> MakeComparison(
  const Octree<Dim>& tree, const StartDepthOptions& options, const DepthHistogram& queryDepths)
{
  SearchComparison<Dim> comparison(tree, options);
  comparison.SetQueryDepths(queryDepths);
  return comparison;
}

template <int Dim>
typename SearchComparison<Dim>::Costs Count(
  const SearchComparison<Dim>& comparison, MortonKey<Dim> key)
{
  typename SearchComparison<Dim>::Costs costs;
  comparison.Find(key, EmptyOctants::Leaves, costs);
  return costs;
}

template <int Dim>
std::vector<typename SearchComparison<Dim>::Search> GetSearches()
{
  using Comparison = SearchComparison<Dim>;
  return { Comparison::Chosen, Comparison::Root, Comparison::Median, Comparison::Mean,
    Comparison::Local, Comparison::DecisionTree, Comparison::BestForQueries };
}
}

template <typename Dimension>
class TestSearchComparison : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestSearchComparison, Dimensions);

TYPED_TEST(TestSearchComparison, EachSearchStartsWhereItsModelSays)
{
  constexpr int dim = TypeParam::value;
  using Comparison = SearchComparison<dim>;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    for (const auto frequency :
      { FrequencyModel::Leaves, FrequencyModel::Points, FrequencyModel::Grid })
    {
      const DepthHistogram histogram =
        GetDepthHistogram(made.Tree.GetDepthCounts(), frequency, dim);
      const DepthHistogram queries = made.Tree.GetDepthCounts().EmptyLeaves;
      const auto comparison =
        MakeComparison<dim>(made.Tree, { StartDepthModel::Fixed, frequency, 5 }, queries);
      EXPECT_EQ(Comparison(made.Tree, {}).GetStartDepth(Comparison::BestForQueries), 0)
        << "no queries yet";
      EXPECT_EQ(comparison.GetStartDepth(Comparison::Chosen), 5);
      EXPECT_EQ(comparison.GetStartDepth(Comparison::Root), 0);
      EXPECT_EQ(comparison.GetStartDepth(Comparison::Median), GetMedianDepth(histogram));
      EXPECT_EQ(comparison.GetStartDepth(Comparison::Mean), GetMeanDepth(histogram));
      EXPECT_EQ(comparison.GetStartDepth(Comparison::Local), -1);
      EXPECT_EQ(comparison.GetStartDepth(Comparison::DecisionTree),
        DepthDecisionTree(histogram).GetRootDepth());
      EXPECT_EQ(comparison.GetStartDepth(Comparison::BestForQueries), GetBestStartDepth(queries));
      for (const auto model : { StartDepthModel::Median, StartDepthModel::Mean })
      {
        const auto other = MakeComparison<dim>(made.Tree, { model, frequency, 5 }, queries);
        EXPECT_EQ(other.GetStartDepth(Comparison::Chosen),
          other.GetStartDepth(
            model == StartDepthModel::Mean ? Comparison::Mean : Comparison::Median));
      }
    }
  }
}

TYPED_TEST(TestSearchComparison, CountsAreTheModelledCostOfEachLeaf)
{
  constexpr int dim = TypeParam::value;
  using Comparison = SearchComparison<dim>;
  const auto points = MakeClusteredPoints<dim, double>(60, 201);
  const SampleTree<dim, double> made(PointSample<dim, double>{ "clusters", points });
  for (const auto frequency :
    { FrequencyModel::Leaves, FrequencyModel::Points, FrequencyModel::Grid })
  {
    const auto comparison = MakeComparison<dim>(
      made.Tree, { StartDepthModel::Fixed, frequency, 3 }, made.Tree.GetDepthCounts().EmptyLeaves);
    const StartDepths<dim> local(made.Tree, { StartDepthModel::Local, frequency, 0 });
    const DepthDecisionTree decisions(
      GetDepthHistogram(made.Tree.GetDepthCounts(), frequency, dim));
    ForEachLeaf(made.Tree,
      [&](const auto& leaf)
      {
        const MortonKey<dim> key = leaf.NodeKey.GetLastAtMaxDepth();
        const int depth = leaf.NodeKey.GetDepth();
        typename Comparison::Costs counted;
        const FoundLeaf<dim> found = comparison.Find(key, EmptyOctants::Missing, counted);
        ASSERT_EQ(found.Key, leaf.NodeKey);
        ASSERT_EQ(found.Exists, !leaf.IsEmpty());
        for (const auto search : GetSearches<dim>())
        {
          const int cost = search == Comparison::DecisionTree ? decisions.GetCost(depth)
                                                              : 1 +
              std::abs(depth -
                (search == Comparison::Local ? local.Get(key) : comparison.GetStartDepth(search)));
          ASSERT_EQ(counted[search], static_cast<std::uint64_t>(cost)) << search;
        }
      });
  }
}

TYPED_TEST(TestSearchComparison, PredictedMeansAreThoseOfCountedSearches)
{
  constexpr int dim = TypeParam::value;
  using Comparison = SearchComparison<dim>;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample, { 2, MortonKey<dim>::MaxDepth });
    const int deepest = made.Tree.GetDeepestDepth();
    for (const auto frequency :
      { FrequencyModel::Leaves, FrequencyModel::Points, FrequencyModel::Grid })
    {
      const auto comparison = MakeComparison<dim>(
        made.Tree, { StartDepthModel::Fixed, frequency, 2 }, made.Tree.GetDepthCounts().Points);
      std::array<long double, Comparison::NumberOfSearches> sums{};
      long double weights = 0.0L;
      ForEachLeaf(made.Tree,
        [&](const auto& leaf)
        {
          const auto counted = Count(comparison, leaf.NodeKey.GetFirstAtMaxDepth());
          const long double weight = frequency == FrequencyModel::Leaves ? 1.0L
            : frequency == FrequencyModel::Points
            ? static_cast<long double>(leaf.GetNumberOfPoints())
            : std::ldexp(1.0L, dim * (deepest - leaf.NodeKey.GetDepth()));
          weights += weight;
          for (const auto search : GetSearches<dim>())
          {
            sums[search] += weight * static_cast<long double>(counted[search]);
          }
        });
      for (const auto search : GetSearches<dim>())
      {
        const auto mean = static_cast<double>(weights > 0 ? sums[search] / weights : 0.0L);
        // Counts of leaves and points are exact; those of the grid need not be.
        EXPECT_NEAR(comparison.GetPredictedMean(search), mean,
          frequency == FrequencyModel::Grid ? 1e-12 * mean : 0.0)
          << search;
      }
    }
  }
}

TYPED_TEST(TestSearchComparison, TheBestDepthCostsTheQueriesTheLeast)
{
  constexpr int dim = TypeParam::value;
  using Comparison = SearchComparison<dim>;
  const PointSample<dim, double> sample{ "clusters", MakeClusteredPoints<dim, double>(500, 202) };
  const SampleTree<dim, double> made(sample);
  const PointSample<dim, double> queries{ "queries", MakeUniformPoints<dim, double>(200, 203) };
  const auto keys = GetQueryKeys(made.Tree.GetGrid(), queries.GetSpan(), Execution());
  const auto depths =
    MeasureQueryDepths(made.Tree, KeySpan<dim>{ keys.GetData(), keys.GetSize() }, Execution());
  const auto sum = [&](const StartDepthOptions& options, typename Comparison::Search search)
  {
    const auto comparison = MakeComparison<dim>(made.Tree, options, depths);
    std::uint64_t nodes = 0;
    for (std::size_t i = 0; i < queries.GetSpan().Count; ++i)
    {
      const auto key = made.Tree.GetGrid().GetKey(queries.GetSpan()[i]);
      nodes += Count(comparison, key)[search];
    }
    return nodes;
  };
  const std::uint64_t best = sum({}, Comparison::BestForQueries);
  EXPECT_LT(best, sum({}, Comparison::Median));
  for (int depth = 0; depth <= made.Tree.GetDeepestDepth(); ++depth)
  {
    EXPECT_LE(
      best, sum({ StartDepthModel::Fixed, FrequencyModel::Leaves, depth }, Comparison::Chosen));
  }
}
