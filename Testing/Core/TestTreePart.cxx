// SPDX-License-Identifier: BSD-3-Clause
#include "TreePart.h"

#include "CurveBuilders.h"
#include "Dimensions.h"
#include "MeasuredCost.h"
#include "SearchComparison.h"

using namespace hashedoctree;

template <typename Dimension>
class TestTreePart : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestTreePart, Dimensions);

TYPED_TEST(TestTreePart, BuildersMeasureTheCostOfTheOneTree)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      const MeasuredCost expected = MeasureCost<dim>(whole, Execution());
      builders.RunTogether(whole,
        [&](const TreePart<dim>& part)
        {
          const MeasuredCost measured = MeasureCost(part, Execution());
          EXPECT_EQ(measured.Leaves, expected.Leaves);
          EXPECT_EQ(measured.Points, expected.Points);
        });
    });
}

TYPED_TEST(TestTreePart, BuildersStartWhereTheOneTreeDoes)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      const CurveKeys<dim> keys = MakeRandomKeys<dim>(200, 51);
      for (const auto frequency :
        { FrequencyModel::Leaves, FrequencyModel::Points, FrequencyModel::Grid })
      {
        const StartDepthOptions options{ StartDepthModel::Local, frequency };
        const StartDepths<dim> expected(whole, options);
        builders.RunTogether(whole,
          [&](const TreePart<dim>& part)
          {
            const StartDepths<dim> starts(part, options);
            EXPECT_EQ(starts.GetMeanCost(part, frequency), expected.GetMeanCost(whole, frequency));
            for (const MortonKey<dim> key : keys)
            {
              EXPECT_EQ(starts.Get(key), expected.Get(key));
            }
          });
      }
    });
}

TYPED_TEST(TestTreePart, BuildersCompareSearchesAsInTheOneTree)
{
  constexpr int dim = TypeParam::value;
  using Comparison = SearchComparison<dim>;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      const CurveKeys<dim> keys = MakeRandomKeys<dim>(200, 51);
      Comparison expected(whole, {});
      expected.SetQueryDepths(whole.GetDepthCounts().EmptyLeaves);
      builders.RunTogether(whole,
        [&](const TreePart<dim>& part)
        {
          Comparison comparison(part, {});
          comparison.SetQueryDepths(whole.GetDepthCounts().EmptyLeaves);
          for (std::size_t i = 0; i < Comparison::NumberOfSearches; ++i)
          {
            const auto search = static_cast<typename Comparison::Search>(i);
            EXPECT_EQ(comparison.GetStartDepth(search), expected.GetStartDepth(search));
            EXPECT_EQ(comparison.GetPredictedMean(search), expected.GetPredictedMean(search));
          }
          for (const MortonKey<dim> key : keys)
          {
            if (part.Has(key))
            {
              typename Comparison::Costs costs;
              typename Comparison::Costs expectedCosts;
              const MortonKey<dim> leaf = comparison.Find(key, EmptyOctants::Leaves, costs).Key;
              EXPECT_EQ(leaf, expected.Find(key, EmptyOctants::Leaves, expectedCosts).Key);
              EXPECT_EQ(costs, expectedCosts);
            }
          }
        });
    });
}
