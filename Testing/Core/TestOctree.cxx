// SPDX-License-Identifier: BSD-3-Clause
#include "Octree.h"

#include "Dimensions.h"
#include "KeyedPoints.h"
#include "OnThisThread.h"
#include "PlainOctree.h"
#include "SampleTree.h"
#include "Threads.h"
#include "ToldProgress.h"

#include <algorithm>

using namespace hashedoctree;

template <typename Dimension>
class TestOctree : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
  using Options = typename Octree<Dim>::Options;

  /** Every node of the oracle is in the tree, reached directly, with the same points; and there are
   * as many. */
  template <typename Real>
  static void ExpectAsPlain(const PointSample<Dim, Real>& sample, const Options& options)
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<Dim, Real> made(sample, options);
    const Octree<Dim>& tree = made.Tree;
    std::vector<std::uint32_t> ids;
    for (std::uint32_t id = 0; id < sample.GetSpan().Count; ++id)
    {
      if (made.Selection.Keeps(sample.GetSpan()[id]))
      {
        ids.push_back(id);
      }
    }
    ASSERT_EQ(tree.GetNumberOfPoints(), ids.size());
    const PlainOctree<Dim> plain(
      sample.Coordinates.data(), ids, options.MaxPointsPerLeaf, options.MaxDepth);
    EXPECT_EQ(tree.GetNumberOfNodes(), plain.GetNodes().size());
    std::size_t occupiedNodes = 0;
    int deepest = 0;
    for (const auto& [name, expected] : plain.GetNodes())
    {
      const MortonKey<Dim> key = MortonKey<Dim>::FromCell(name.Cell, name.Depth);
      const auto node = tree.FindNode(key);
      ASSERT_TRUE(node) << key.GetValue();
      ASSERT_EQ(node->NodeKey, key);
      ASSERT_EQ(node->Internal, expected.Internal);
      std::vector<std::uint32_t> found(
        tree.GetPointIds() + node->FirstPoint, tree.GetPointIds() + node->LastPoint);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected.Ids);
      for (const std::uint32_t id : found)
      {
        // The same node by the position and depth of each of its points (paper section 2).
        const Real* x = sample.GetSpan()[id];
        const auto same = tree.FindNode(tree.GetGrid().GetKey(x).AtDepth(name.Depth));
        ASSERT_TRUE(same && same->NodeKey == key);
      }
      ASSERT_EQ(tree.FindNode(key, EmptyOctants::Missing).has_value(), !expected.Ids.empty());
      occupiedNodes += expected.Ids.empty() ? 0 : 1;
      deepest = std::max(deepest, name.Depth);
    }
    EXPECT_EQ(tree.GetNumberOfNodes() - tree.GetNumberOfEmptyLeaves(), occupiedNodes);
    EXPECT_EQ(tree.GetDeepestDepth(), deepest);
  }
};
TYPED_TEST_SUITE(TestOctree, Dimensions);

TYPED_TEST(TestOctree, EqualsThePlainOctree)
{
  for (const auto& sample : MakePointSamples<TestFixture::Dim, double>())
  {
    TestFixture::ExpectAsPlain(sample, {});
  }
}

TYPED_TEST(TestOctree, EqualsThePlainOctreeInSinglePrecision)
{
  for (const auto& sample : MakePointSamples<TestFixture::Dim, float>())
  {
    TestFixture::ExpectAsPlain(sample, {});
  }
}

TYPED_TEST(TestOctree, EqualsThePlainOctreeForAnyOptions)
{
  for (const std::size_t maxPointsPerLeaf : { 1U, 2U, 7U, 70U, 10000U })
  {
    for (const int maxDepth : { 0, 1, 4, MortonKey<TestFixture::Dim>::MaxDepth })
    {
      for (const auto& sample : MakePointSamples<TestFixture::Dim, float>())
      {
        if (sample.Name == "duplicates" || sample.Name == "clusters" || sample.Name == "one point")
        {
          TestFixture::ExpectAsPlain(sample, { maxPointsPerLeaf, maxDepth });
        }
      }
    }
  }
}

TYPED_TEST(TestOctree, NodesThatDoNotExistAreNotFound)
{
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "u", MakeUniformPoints<dim, double>(300, 61) });
  for (unsigned noKey = 0; noKey < Octree<dim>::NumberOfOctants; ++noKey)
  {
    EXPECT_EQ(made.Tree.FindNode(MortonKey<dim>(noKey)).has_value(), noKey == 1) << "1 is the root";
  }
  ForEachLeaf(made.Tree,
    [&made](const auto& leaf)
    {
      if (leaf.NodeKey.GetDepth() < MortonKey<dim>::MaxDepth)
      {
        for (unsigned octant = 0; octant < Octree<dim>::NumberOfOctants; ++octant)
        {
          ASSERT_FALSE(made.Tree.FindNode(leaf.NodeKey.GetChild(octant)));
        }
      }
    });
}

TYPED_TEST(TestOctree, ThreadsDoNotMatter)
{
  constexpr int dim = TestFixture::Dim;
  const PointSample<dim, float> sample{ "clusters", MakeClusteredPoints<dim, float>(100000, 62) };
  const SampleTree<dim, float> one(sample);
  for (const unsigned threads : { 2U, 8U })
  {
    const SampleTree<dim, float> many(sample, {}, Execution(OnThreads(threads)));
    ASSERT_EQ(many.Tree.GetNumberOfInternalNodes(), one.Tree.GetNumberOfInternalNodes());
    EXPECT_TRUE(std::equal(one.Tree.GetPointIds(),
      one.Tree.GetPointIds() + one.Tree.GetNumberOfPoints(), many.Tree.GetPointIds()));
    for (std::size_t block = 0; block < one.Tree.GetNumberOfInternalNodes(); ++block)
    {
      ASSERT_EQ(many.Tree.GetBlockKey(block), one.Tree.GetBlockKey(block));
      ASSERT_EQ(many.Tree.GetOctants(block).Internal, one.Tree.GetOctants(block).Internal);
      ASSERT_EQ(many.Tree.GetBlock(block).FirstPoint, one.Tree.GetBlock(block).FirstPoint);
    }
    EXPECT_EQ(many.Tree.GetDepthCounts().Leaves, one.Tree.GetDepthCounts().Leaves);
  }
}

TYPED_TEST(TestOctree, KeysAloneGiveTheSameTree)
{
  constexpr int dim = TestFixture::Dim;
  const PointSample<dim, double> sample{ "uniform", MakeUniformPoints<dim, double>(3000, 64) };
  const SampleTree<dim, double> made(sample, { 2, 9 });
  std::vector<MortonKey<dim>> keys;
  for (std::size_t i = 0; i < sample.GetSpan().Count; ++i)
  {
    keys.push_back(made.Tree.GetGrid().GetKey(sample.GetSpan()[i]));
  }
  const Octree<dim> tree(made.Tree.GetGrid(), keys, { 2, 9 }, Execution());
  EXPECT_EQ(FindBrokenLaws(tree, sample.GetSpan(), made.Selection), std::vector<std::string>());
}

TYPED_TEST(TestOctree, UsesSpareMemory)
{
  constexpr int dim = TestFixture::Dim;
  const PointSample<dim, double> sample{ "uniform", MakeUniformPoints<dim, double>(3000, 65) };
  const PointSelection<dim> selection(sample.GetSpan(), {}, Execution());
  Buffer<KeyedPoint<dim>> spare(3000, Memory::Zeroed);
  const Octree<dim> tree(
    sample.GetSpan(), selection, {}, Execution(), { spare.GetData(), spare.GetBytes() });
  EXPECT_EQ(FindBrokenLaws(tree, sample.GetSpan(), selection), std::vector<std::string>());
  EXPECT_TRUE(std::any_of(spare.GetData(), spare.GetData() + spare.GetSize(),
    [](const KeyedPoint<dim>& point) { return point.GetKey().GetValue() != 0; }));
}

TYPED_TEST(TestOctree, CountsItsBytes)
{
  constexpr int dim = TestFixture::Dim;
  using Tree = Octree<dim>;
  // Two slots of the table for each internal node, and up to a bucket more.
  constexpr std::size_t slot = sizeof(std::uint64_t) + sizeof(typename Tree::Entry);
  constexpr std::size_t internal = sizeof(typename Tree::Block) + sizeof(typename Tree::Octants) +
    sizeof(typename Tree::Key) + 2 * slot;
  static_assert(
    dim != 3 || sizeof(PointIndex) != 4 || internal == 82, "or Architecture.md is wrong");
  for (const std::size_t count : { 300U, 5000U, 40000U })
  {
    const SampleTree<dim, float> made(
      PointSample<dim, float>{ "uniform", MakeUniformPoints<dim, float>(count, 63) });
    const std::size_t least = internal * made.Tree.GetNumberOfInternalNodes();
    EXPECT_GE(made.Tree.GetTreeBytes(), least);
    EXPECT_LE(made.Tree.GetTreeBytes(), least + SlotsOfBucket * slot);
    EXPECT_EQ(made.Tree.GetOrderBytes(), sizeof(PointIndex) * count);
  }
}

TEST(TestOctreeFacts, EmptyTreeIsOneEmptyLeaf)
{
  const Octree<3> tree;
  EXPECT_EQ(tree.GetNumberOfNodes(), 1U);
  EXPECT_EQ(tree.GetNumberOfLeaves(), 1U);
  EXPECT_EQ(tree.GetNumberOfEmptyLeaves(), 1U);
  EXPECT_EQ(tree.GetDeepestDepth(), 0);
  EXPECT_EQ(tree.GetTreeBytes(), 0U);
  EXPECT_TRUE(tree.GetRoot().IsEmpty());
  EXPECT_FALSE(tree.FindNode(MortonKey<3>::Root(), EmptyOctants::Missing));
}

TEST(TestOctreeFacts, TreeOfNoKeysKeepsTheGridThatItIsGiven)
{
  const Box<3> box{ { 1.0, 2.0, 3.0 }, { 5.0, 4.0, 6.0 } };
  const Octree<3> tree(Grid<3>(box), {}, {}, Execution());
  EXPECT_EQ(tree.GetNumberOfNodes(), 1U);
  EXPECT_TRUE(tree.GetRoot().IsEmpty());
  EXPECT_EQ(tree.GetGrid().GetSide(), 4.0);
}

TEST(TestOctreeFacts, UniformGridHasOneDepth)
{
  // The full octree as a special case (paper section 1): 16^3 cells.
  PointSample<3, double> sample{ "grid", {} };
  for (int x = 0; x < 16; ++x)
  {
    for (int y = 0; y < 16; ++y)
    {
      for (int z = 0; z < 16; ++z)
      {
        sample.Coordinates.insert(sample.Coordinates.end(), { 1.0 * x, 1.0 * y, 1.0 * z });
      }
    }
  }
  const SampleTree<3, double> made(sample);
  const DepthHistogram expected{ 0, 0, 0, 0, 4096 };
  EXPECT_EQ(made.Tree.GetDepthCounts().Leaves, expected);
  EXPECT_EQ(made.Tree.GetDepthCounts().Points, expected);
  EXPECT_EQ(made.Tree.GetNumberOfEmptyLeaves(), 0U);
  EXPECT_EQ(GetMedianDepth(expected), 4);
  EXPECT_EQ(GetMeanCost(expected, 4), 1.0) << "each leaf is hit at once";
}

TEST(TestOctreeFacts, RandomSphereOfThePapersTable1)
{
  // Half a million points: 2,883k nodes, deepest 18 and start depth 9 in the paper.
  const PointSample<3, double> sample{ "sphere", MakeSpherePoints<3, double>(500000, 64) };
  const SampleTree<3, double> made(sample);
  EXPECT_NEAR(static_cast<double>(made.Tree.GetNumberOfNodes()), 2.883e6, 0.01e6);
  EXPECT_NEAR(static_cast<double>(made.Tree.GetNumberOfLeaves()), 2.523e6, 0.01e6);
  EXPECT_GE(made.Tree.GetDeepestDepth(), 17);
  EXPECT_LE(made.Tree.GetDeepestDepth(), 19);
  EXPECT_EQ(GetMedianDepth(made.Tree.GetDepthCounts().Leaves), 9);
}

TEST(TestOctreeFacts, TreeOfTheDrawing)
{
  // Plugin/Documentation/keys.svg (the paper's Fig. 2): its points a to e, here e, c, a, d, b.
  const PointSample<2, double> sample{ "drawing",
    { 0.84, 0.66, 0.66, 0.45, 0.2, 0.38, 0.9, 0.45, 0.58, 0.18 } };
  const PointSelection<2> selection(
    sample.GetSpan(), Box<2>({ 0.0, 0.0 }, { 1.0, 1.0 }), Execution());
  const Octree<2> tree(sample.GetSpan(), selection, {}, Execution());
  EXPECT_EQ(std::vector<PointIndex>(tree.GetPointIds(), tree.GetPointIds() + 5),
    (std::vector<PointIndex>{ 2, 4, 1, 3, 0 }));

  ASSERT_EQ(tree.GetNumberOfInternalNodes(), 2U);
  const Octree<2>::Block& root = tree.GetBlock(0);
  EXPECT_EQ(tree.GetBlockKey(0).GetValue(), 0b1U);
  EXPECT_EQ(tree.GetOctants(0).Internal, 1U << 2); // Octant 0 is the lowest bit.
  EXPECT_EQ(tree.GetOctants(0).Occupied, 1U << 0 | 1U << 2 | 1U << 3);
  EXPECT_EQ(tree.GetChildBlock(0, 2), 1U);
  EXPECT_EQ(root.FirstPoint, (std::array<PointIndex, 5>{ 0, 1, 1, 4, 5 }));
  const Octree<2>::Block& child = tree.GetBlock(1);
  EXPECT_EQ(tree.GetBlockKey(1).GetValue(), 0b110U);
  EXPECT_EQ(tree.GetOctants(1).Internal, 0U);
  EXPECT_EQ(tree.GetOctants(1).Occupied, 1U << 0 | 1U << 1 | 1U << 3);
  EXPECT_EQ(child.FirstPoint, (std::array<PointIndex, 5>{ 1, 2, 3, 3, 4 }));

  for (std::uint32_t block = 0; block < 2; ++block)
  {
    const auto* entry = tree.GetTable().Find(tree.GetBlockKey(block).GetValue());
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->Block, block);
    EXPECT_EQ(entry->Internal, tree.GetOctants(block).Internal);
    EXPECT_EQ(entry->Occupied, tree.GetOctants(block).Occupied);
  }
  EXPECT_EQ(tree.GetTable().Find(0b101U), nullptr);
  EXPECT_EQ(tree.GetTable().Find(0b111U), nullptr);
}

TEST(TestOctreeFacts, GivenBoxIsTheRoot)
{
  const PointSample<3, double> sample{ "uniform", MakeUniformPoints<3, double>(1000, 65) };
  const Box<3> box({ -1.0, 0.0, 0.0 }, { 1.0, 0.5, 2.0 });
  const PointSelection<3> selection(sample.GetSpan(), box, Execution());
  EXPECT_GT(selection.GetNumberOfOutsidePoints(), 300U);
  const Octree<3> tree(sample.GetSpan(), selection, {}, Execution());
  EXPECT_EQ(tree.GetGrid().GetLower(), box.Lower);
  EXPECT_EQ(tree.GetGrid().GetSide(), 2.0);
  EXPECT_TRUE(FindBrokenLaws(tree, sample.GetSpan(), selection).empty());
  // No point lies in the half with x < 0.
  for (unsigned octant = 0; octant < 4; ++octant)
  {
    EXPECT_TRUE(tree.GetChild(0, octant).IsEmpty());
  }
}

TEST(TestOctreeFacts, BuildCanBeInterruptedAnywhere)
{
  const PointSample<3, float> sample{ "uniform", MakeUniformPoints<3, float>(50000, 66) };
  const PointSelection<3> selection(sample.GetSpan(), {}, Execution());
  std::vector<double> told;
  const auto build = [&](std::size_t reports)
  {
    told.clear();
    const Execution execution(OnThisThread,
      [&](double fraction)
      {
        told.push_back(fraction);
        return told.size() < reports;
      });
    return Octree<3>(sample.GetSpan(), selection, {}, execution).GetNumberOfPoints();
  };
  EXPECT_EQ(build(1000000), 50000U);
  const std::size_t reports = told.size();
  EXPECT_GE(reports, 6U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_NEAR(told.back(), 1.0, 1e-12);
  for (std::size_t stop = 1; stop <= reports; ++stop)
  {
    EXPECT_THROW(build(stop), Interrupted);
  }
}

TEST(TestOctreeFacts, ProgressRisesWhileTheTableIsFilled)
{
  const PointSample<1, double> sample{ "uniform", MakeUniformPoints<1, double>(200000, 67) };
  const PointSelection<1> selection(sample.GetSpan(), {}, Execution());
  ToldProgress told;
  const Octree<1> tree(sample.GetSpan(), selection, {}, told.MakeExecution());
  EXPECT_GT(tree.GetNumberOfInternalNodes(), 262144U) << "more than between two reports";
  EXPECT_EQ(FindBrokenLaws(tree, sample.GetSpan(), selection), std::vector<std::string>());
  told.ExpectToRise(7);
  EXPECT_NEAR(told.GetFractions().back(), 1.0, 1e-12);
}

TEST(TestOctreeFacts, CountOctantsCountsBits)
{
  for (std::uint32_t mask = 0; mask < 65536; ++mask)
  {
    ASSERT_EQ(CountOctants(mask), static_cast<unsigned>(__builtin_popcount(mask)));
  }
}
