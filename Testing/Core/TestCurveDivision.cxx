// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDivision.h"

#include "CurveBuilders.h"
#include "Dimensions.h"
#include "DirectSearch.h"
#include "NodeList.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestCurveDivision : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestCurveDivision, Dimensions);

TYPED_TEST(TestCurveDivision, PartsTogetherAreTheOneTree)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      const NodeListOptions all{ true, true };
      const CurveKeys<dim> across = builders.Divided->GetNodesAcross();
      using Node = typename Octree<dim>::Node;
      std::map<std::uint64_t, Node> expected;
      ForEachNode(whole, [&](const Node& node) { expected[node.NodeKey.GetValue()] = node; });
      std::set<std::uint64_t> found;
      for (std::size_t part = 0; part < builders.Trees.size(); ++part)
      {
        const auto nodes =
          ListNodes(*builders.Trees[part], all, Execution(), builders.Divided->GetRange(part));
        for (std::size_t i = 0; i < nodes.GetSize(); ++i)
        {
          const MortonKey<dim> key = nodes[i].NodeKey;
          ASSERT_EQ(expected.count(key.GetValue()), 1U);
          EXPECT_TRUE(found.insert(key.GetValue()).second);
          const Node& node = expected[key.GetValue()];
          EXPECT_EQ(nodes[i].Internal, node.Internal);
          if (!node.Internal || !std::binary_search(across.begin(), across.end(), key))
          {
            EXPECT_EQ(nodes[i].GetNumberOfPoints(), node.GetNumberOfPoints());
          }
        }
      }
      EXPECT_EQ(found.size(), expected.size());
    });
}

TYPED_TEST(TestCurveDivision, PointsOfNodesAcrossAddUp)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      const CurveKeys<dim> nodes = builders.Divided->GetNodesAcross();
      std::vector<std::uint64_t> counts(nodes.size());
      for (std::size_t part = 0; part < builders.Own.size(); ++part)
      {
        const auto ofPart = builders.Divided->CountInNodesAcross(part, builders.Own[part]);
        std::transform(ofPart.begin(), ofPart.end(), counts.begin(), counts.begin(), std::plus<>());
      }
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const auto node = whole.FindNode(nodes[i]);
        EXPECT_TRUE(!node || node->GetNumberOfPoints() == counts[i]);
      }
    });
}

TYPED_TEST(TestCurveDivision, SearchesInThePartOfTheirKeyAreThoseInTheOneTree)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const CurveBuilders<dim>& builders)
    {
      CurveKeys<dim> keys = MakeRandomKeys<dim>(40, 31);
      for (std::size_t part = 0; part < builders.Trees.size(); ++part)
      {
        const auto range = builders.Divided->GetRange(part);
        keys.push_back(range.First);
        keys.push_back(std::max(range.Last, CurveRange<dim>().First));
      }
      for (const MortonKey<dim> key : keys)
      {
        const Octree<dim>& tree = *builders.Trees[builders.Divided->FindPart(key)];
        for (int startDepth = 0; startDepth <= MortonKey<dim>::MaxDepth; startDepth += 3)
        {
          NodeCount expectedCount;
          const auto expected = FindLeaf(whole, key, startDepth, expectedCount);
          NodeCount count;
          ASSERT_EQ(FindLeaf(tree, key, startDepth, count).Key, expected.Key);
          EXPECT_EQ(count.Nodes, expectedCount.Nodes);
          EXPECT_EQ(tree.FindNode(expected.Key)->GetNumberOfPoints(),
            whole.FindNode(expected.Key)->GetNumberOfPoints());
        }
      }
    });
}

TYPED_TEST(TestCurveDivision, PartsCoverTheCurveAndFindTheirKeys)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>&, const CurveBuilders<dim>& builders)
    {
      const CurveDivision<dim>& division = *builders.Divided;
      const CurveRange<dim> whole;
      std::uint64_t next = whole.First.GetValue();
      for (std::size_t part = 0; part < division.GetNumberOfParts(); ++part)
      {
        const CurveRange<dim> range = division.GetRange(part);
        EXPECT_EQ(range.First.GetValue(), next);
        next = range.Last.GetValue() + 1;
        if (range.First <= range.Last)
        {
          EXPECT_EQ(division.FindPart(range.First), part);
          EXPECT_EQ(division.FindPart(range.Last), part);
        }
      }
      EXPECT_EQ(next, whole.Last.GetValue() + 1);
    });
}

TYPED_TEST(TestCurveDivision, NodesAcrossAreNamedOnce)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>&, const CurveBuilders<dim>& builders)
    {
      const CurveKeys<dim> nodes = builders.Divided->GetNodesAcross();
      const std::size_t cuts = builders.Divided->GetNumberOfParts() - 1;
      EXPECT_LE(nodes.size(), cuts * (MortonKey<dim>::MaxDepth + 1));
      for (std::size_t i = 1; i < nodes.size(); ++i)
      {
        EXPECT_LT(nodes[i - 1], nodes[i]);
      }
    });
}

TYPED_TEST(TestCurveDivision, OverlapsAreTheNextKeysAndNoOthers)
{
  constexpr int dim = TypeParam::value;
  using Division = CurveDivision<dim>;
  std::mt19937_64 random(61);
  CurveKeys<dim> all = MakeRandomKeys<dim>(90, 62);
  std::sort(all.begin(), all.end());
  // Where each of five parts begins; one is empty, one has less than most overlaps.
  const std::vector<std::size_t> begins{ 0, 40, 40, 43, 70, 90 };
  std::vector<std::uint64_t> points;
  for (std::size_t part = 0; part < 5; ++part)
  {
    points.push_back(begins[part + 1] - begins[part]);
  }
  for (const std::size_t overlap : { 1U, 2U, 5U, 30U, 200U })
  {
    std::vector<CurveKeys<dim>> around(5);
    for (std::size_t part = 0; part < 5; ++part)
    {
      CurveKeys<dim> own(all.begin() + static_cast<std::ptrdiff_t>(begins[part]),
        all.begin() + static_cast<std::ptrdiff_t>(begins[part + 1]));
      std::shuffle(own.begin(), own.end(), random);
      Append(Division::GetOverlaps(part, own, points, overlap), around);
    }
    for (std::size_t part = 0; part < 5; ++part)
    {
      CurveKeys<dim> expected;
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        const bool isBefore = i < begins[part] && begins[part] <= i + overlap;
        const bool isAfter = i >= begins[part + 1] && i < begins[part + 1] + overlap;
        if (isBefore || isAfter)
        {
          expected.push_back(all[i]);
        }
      }
      std::sort(around[part].begin(), around[part].end());
      EXPECT_EQ(around[part], expected) << "part " << part << ", overlap " << overlap;
    }
  }
}

TEST(TestCurveDivisionFacts, SamplesAreSmallAndFollowNoRule)
{
  // Keys by turns in two far places: every second one would tell of one place only.
  CurveKeys<3> keys;
  for (std::uint64_t i = 0; i < 100000; ++i)
  {
    keys.emplace_back(MortonKey<3>::Root().GetFirstAtMaxDepth().GetValue() + (i % 2 << 62U) + i);
  }
  for (const std::size_t parts : { 1U, 2U, 5U })
  {
    const CurveKeys<3> sample = CurveDivision<3>::Sample(keys, keys.size(), parts);
    const double expected = 1024.0 * static_cast<double>(parts);
    EXPECT_NEAR(static_cast<double>(sample.size()), expected, 0.2 * expected);
    const auto inUpper = std::count_if(sample.begin(), sample.end(),
      [](MortonKey<3> key) { return (key.GetValue() >> 62U & 1U) != 0; });
    EXPECT_NEAR(static_cast<double>(inUpper) / static_cast<double>(sample.size()), 0.5, 0.1);
  }
}

TEST(TestCurveDivisionFacts, PartsOfFewPointsDifferByOneAtMost)
{
  for (std::size_t number = 1; number <= 20; ++number)
  {
    const CurveKeys<3> keys = MakeRandomKeys<3>(number, 71);
    for (const std::size_t parts : { 1U, 2U, 5U, 8U })
    {
      const CurveKeys<3> sample = CurveDivision<3>::Sample(keys, number, parts);
      EXPECT_EQ(sample, keys);
      const CurveDivision<3> division(sample, parts, MortonKey<3>::MaxDepth);
      const std::vector<std::size_t> counts = division.Deal(keys).Counts;
      const auto extremes = std::minmax_element(counts.begin(), counts.end());
      EXPECT_LE(*extremes.second - *extremes.first, 1U) << number << " keys, " << parts << " parts";
    }
  }
}

TEST(TestCurveDivisionFacts, PartsHaveAboutAsManyPoints)
{
  const PointSample<3, double> sample{ "many", MakeClusteredPoints<3, double>(40000, 13) };
  const SampleTree<3, double> made(sample);
  const CurveBuilders<3> builders(sample, made.Tree, 5);
  for (const CurveKeys<3>& keys : builders.Own)
  {
    EXPECT_NEAR(static_cast<double>(keys.size()), 8000.0, 800.0);
  }
}

TEST(TestCurveDivisionFacts, OfNoPointsTheLastPartHasTheCurve)
{
  const CurveDivision<3> division({}, 3, 21);
  EXPECT_EQ(division.FindPart(MortonKey<3>::Root().GetFirstAtMaxDepth()), 2U);
  EXPECT_FALSE(division.GetRange(0).Has(MortonKey<3>::Root()));
  EXPECT_TRUE(division.GetRange(2).Has(MortonKey<3>::Root()));
  EXPECT_TRUE(division.GetNodesAcross().empty());
}
