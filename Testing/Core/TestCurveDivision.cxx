// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDivision.h"

#include "Dimensions.h"
#include "DirectSearch.h"
#include "MeasuredCost.h"
#include "NodeList.h"
#include "RangeDepths.h"
#include "SampleTree.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>

using namespace hashedoctree;

namespace
{
template <int Dim>
using Keys = std::vector<MortonKey<Dim>>;

/** Builders with points at random, who divide the curve and each make a tree of one part. */
template <int Dim>
struct Builders
{
  using Division = CurveDivision<Dim>;
  std::unique_ptr<Division> Divided;
  std::vector<std::unique_ptr<Octree<Dim>>> Trees;
  std::vector<Keys<Dim>> Own;

  Builders(const PointSample<Dim, double>& sample, const Octree<Dim>& whole, std::size_t number)
  {
    const auto& options = whole.GetOptions();
    std::vector<Keys<Dim>> given(number);
    std::mt19937 random(7);
    for (std::size_t i = 0; i < whole.GetNumberOfPoints(); ++i)
    {
      // Those that take part, in an order that is not that of the curve.
      const std::size_t point = whole.GetPointIds()[i];
      given[random() % number].push_back(
        whole.GetGrid().GetKey(GetPosition<Dim>(sample.GetSpan(), point)));
    }
    Keys<Dim> samples;
    for (const Keys<Dim>& keys : given)
    {
      const Keys<Dim> ofBuilder = Division::Sample(keys, whole.GetNumberOfPoints(), number);
      samples.insert(samples.end(), ofBuilder.begin(), ofBuilder.end());
    }
    this->Divided = std::make_unique<Division>(samples, number, options.MaxDepth);
    this->Own.resize(number);
    for (const Keys<Dim>& keys : given)
    {
      const std::vector<Keys<Dim>> dealt = this->Divided->Deal(keys);
      for (std::size_t part = 0; part < number; ++part)
      {
        this->Own[part].insert(this->Own[part].end(), dealt[part].begin(), dealt[part].end());
      }
    }
    this->Build(whole);
  }

private:
  void Build(const Octree<Dim>& whole)
  {
    const std::size_t overlap = Division::CountOverlap(whole.GetOptions().MaxPointsPerLeaf);
    std::vector<Keys<Dim>> first;
    std::vector<Keys<Dim>> last;
    for (const Keys<Dim>& keys : this->Own)
    {
      first.push_back(Division::FindFirst(keys, overlap));
      last.push_back(Division::FindLast(keys, overlap));
    }
    for (std::size_t part = 0; part < this->Own.size(); ++part)
    {
      Keys<Dim> keys = Division::GetAround(part, first, last, overlap);
      keys.insert(keys.end(), this->Own[part].begin(), this->Own[part].end());
      this->Trees.push_back(
        std::make_unique<Octree<Dim>>(whole.GetGrid(), keys, whole.GetOptions(), Execution()));
    }
  }
};

template <int Dim>
std::vector<PointSample<Dim, double>> MakeSamples()
{
  auto samples = MakePointSamples<Dim, double>();
  samples.push_back({ "uniform", MakeUniformPoints<Dim, double>(3000, 11) });
  samples.push_back({ "clustered", MakeClusteredPoints<Dim, double>(3000, 12) });
  return samples;
}

/** Calls function(whole tree, builders) for all samples, limits and numbers of builders. */
template <int Dim, typename Function>
void ForEachDivision(const Function& function)
{
  for (const auto& sample : MakeSamples<Dim>())
  {
    for (const typename Octree<Dim>::Options options :
      { typename Octree<Dim>::Options{}, { 3, MortonKey<Dim>::MaxDepth }, { 1, 4 }, { 40, 2 },
        { 1, 0 }, { 5000, MortonKey<Dim>::MaxDepth } })
    {
      const SampleTree<Dim, double> made(sample, options);
      if (made.Tree.GetNumberOfPoints() == 0)
      {
        continue; // Nothing to divide.
      }
      for (const std::size_t number : { 1, 2, 3, 8 })
      {
        SCOPED_TRACE(::testing::Message()
          << sample.Name << ", " << number << " builders, at most " << options.MaxPointsPerLeaf
          << " points down to " << options.MaxDepth);
        function(made.Tree, Builders<Dim>(sample, made.Tree, number));
      }
    }
  }
}

void Add(const DepthHistogram& part, DepthHistogram& sum)
{
  sum.resize(std::max(sum.size(), part.size()));
  std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
}
}

template <typename Dimension>
class TestCurveDivision : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestCurveDivision, Dimensions);

TYPED_TEST(TestCurveDivision, PartsTogetherAreTheOneTree)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const Builders<dim>& builders)
    {
      const NodeListOptions all{ true, true };
      const Keys<dim> across = builders.Divided->GetNodesAcross();
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

TYPED_TEST(TestCurveDivision, CountsOfPartsAddUp)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const Builders<dim>& builders)
    {
      const int last = MeasuredCost::GetLastStartDepth(whole.GetDeepestDepth());
      DepthCounts counts;
      ExaminedNodes examined;
      for (std::size_t part = 0; part < builders.Trees.size(); ++part)
      {
        const CurveRange<dim> range = builders.Divided->GetRange(part);
        const DepthCounts ofPart = CountDepths(*builders.Trees[part], range, Execution());
        Add(ofPart.Leaves, counts.Leaves);
        Add(ofPart.EmptyLeaves, counts.EmptyLeaves);
        Add(ofPart.Points, counts.Points);
        const ExaminedNodes examinedInPart =
          MeasureExaminedNodes(*builders.Trees[part], range, last, Execution());
        Add(examinedInPart.Leaves, examined.Leaves);
        Add(examinedInPart.Points, examined.Points);
      }
      EXPECT_EQ(counts.Leaves, whole.GetDepthCounts().Leaves);
      EXPECT_EQ(counts.EmptyLeaves, whole.GetDepthCounts().EmptyLeaves);
      EXPECT_EQ(counts.Points, whole.GetDepthCounts().Points);
      const MeasuredCost expected = MeasureCost(whole, Execution());
      const MeasuredCost measured(examined, counts);
      EXPECT_EQ(measured.Leaves, expected.Leaves);
      EXPECT_EQ(measured.Points, expected.Points);
    });
}

TYPED_TEST(TestCurveDivision, PointsOfNodesAcrossAddUp)
{
  constexpr int dim = TypeParam::value;
  ForEachDivision<dim>(
    [](const Octree<dim>& whole, const Builders<dim>& builders)
    {
      const Keys<dim> nodes = builders.Divided->GetNodesAcross();
      DepthHistogram counts(nodes.size());
      for (std::size_t part = 0; part < builders.Own.size(); ++part)
      {
        Add(builders.Divided->CountInNodesAcross(part, builders.Own[part]), counts);
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
    [](const Octree<dim>& whole, const Builders<dim>& builders)
    {
      std::mt19937_64 random(31);
      constexpr std::uint64_t first = MortonKey<dim>::Root().GetFirstAtMaxDepth().GetValue();
      Keys<dim> keys;
      for (int i = 0; i < 40; ++i)
      {
        keys.emplace_back(first | random() % first);
      }
      for (std::size_t part = 0; part < builders.Trees.size(); ++part)
      {
        const auto range = builders.Divided->GetRange(part);
        keys.push_back(range.First);
        keys.emplace_back(std::max(range.Last.GetValue(), first));
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
    [](const Octree<dim>&, const Builders<dim>& builders)
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

TEST(TestCurveDivisionFacts, PartsHaveAboutAsManyPoints)
{
  const PointSample<3, double> sample{ "many", MakeClusteredPoints<3, double>(40000, 13) };
  const SampleTree<3, double> made(sample);
  const Builders<3> builders(sample, made.Tree, 5);
  for (const Keys<3>& keys : builders.Own)
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
