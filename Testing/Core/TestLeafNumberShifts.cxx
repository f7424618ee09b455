// SPDX-License-Identifier: BSD-3-Clause
#include "LeafNumberShifts.h"

#include "CurveBuilders.h"
#include "Dimensions.h"
#include "LeafNumbers.h"
#include "RangeDepths.h"

#include <algorithm>
#include <functional>

using namespace hashedoctree;

template <typename Dimension>
class TestLeafNumberShifts : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestLeafNumberShifts, Dimensions);

TYPED_TEST(TestLeafNumberShifts, MakeNumbersOfPartsThoseOfTheWhole)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      for (const EmptyOctants reading : { EmptyOctants::Leaves, EmptyOctants::Missing })
      {
        const LeafNumbers<dim> numbers(whole, reading);
        DepthHistogram before(whole.GetDepthCounts().Leaves.size(), 0);
        for (std::size_t part = 0; part < builders.Trees.size(); ++part)
        {
          const Octree<dim>& tree = *builders.Trees[part];
          const CurveRange<dim> range = builders.Divided->GetRange(part);
          const LeafNumbers<dim> ofPart(tree, reading);
          const auto shifts =
            FindLeafNumberShifts(tree, range, whole.GetDepthCounts(), before, reading, Execution());
          CurveKeys<dim> keys = MakeRandomKeys<dim>(20, 71);
          keys.insert(keys.end(), builders.Own[part].begin(), builders.Own[part].end());
          keys.push_back(range.First);
          for (const MortonKey<dim> key : keys)
          {
            const FoundLeaf<dim> leaf = FindLeaf(tree, key, 0, reading);
            if (range.Has(key) && leaf.Exists)
            {
              const auto shift = shifts[static_cast<std::size_t>(leaf.Key.GetDepth())];
              EXPECT_EQ(static_cast<std::int64_t>(ofPart.Get(tree, leaf)) + shift,
                numbers.Get(whole, FindLeaf(whole, key, 0, reading)));
            }
          }
          const DepthHistogram own =
            CountNumberedLeaves(CountDepths(tree, range, Execution()), reading);
          std::transform(own.begin(), own.end(), before.begin(), before.begin(), std::plus<>());
        }
      }
    });
}
