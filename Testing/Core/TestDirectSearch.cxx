// SPDX-License-Identifier: BSD-3-Clause
#include "DirectSearch.h"

#include "Dimensions.h"
#include "SampleTree.h"

using namespace hashedoctree;

namespace
{
/** A tree that remembers the keys that a search asks for and looks up. */
template <int Dim>
class RecordedTree
{
public:
  using Entry = typename Octree<Dim>::Entry;

  explicit RecordedTree(const Octree<Dim>& tree, bool isCached = true)
    : Tree(tree)
    , Cached(isCached)
  {
  }
  const RecordedTree& GetTable() const { return *this; }
  bool IsRootInternal() const { return this->Tree.IsRootInternal(); }
  std::size_t GetNumberOfPoints() const { return this->Tree.GetNumberOfPoints(); }

  bool IsCached() const { return this->Cached; }
  void Prefetch(std::uint64_t key) const { this->Asked.push_back(key); }
  const Entry* Find(std::uint64_t key) const
  {
    this->LookedUp.push_back(key);
    return this->Tree.GetTable().Find(key);
  }

  mutable std::vector<std::uint64_t> Asked;
  mutable std::vector<std::uint64_t> LookedUp;

private:
  const Octree<Dim>& Tree;
  bool Cached;
};
}

template <typename Dimension>
class TestDirectSearch : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;
};
TYPED_TEST_SUITE(TestDirectSearch, Dimensions);

TYPED_TEST(TestDirectSearch, EveryStartDepthFindsEveryLeafAtTheModelledCost)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    ForEachLeaf(made.Tree,
      [&made](const auto& leaf)
      {
        const int depth = leaf.NodeKey.GetDepth();
        for (int startDepth = 0; startDepth <= MortonKey<dim>::MaxDepth; ++startDepth)
        {
          // The leaf is found from either end of its cells.
          for (const MortonKey<dim> key :
            { leaf.NodeKey.GetFirstAtMaxDepth(), leaf.NodeKey.GetLastAtMaxDepth() })
          {
            NodeCount count;
            const FoundLeaf<dim> found = FindLeaf(made.Tree, key, startDepth, count);
            ASSERT_EQ(found.Key, leaf.NodeKey);
            ASSERT_TRUE(found.Exists);
            ASSERT_EQ(count.Nodes, static_cast<std::uint64_t>(1 + std::abs(depth - startDepth)));
            ASSERT_EQ(CountExaminedNodes(made.Tree, key, startDepth), count.Nodes);

            const FoundLeaf<dim> sparse =
              FindLeaf(made.Tree, key, startDepth, EmptyOctants::Missing);
            ASSERT_EQ(sparse.Key, leaf.NodeKey);
            ASSERT_EQ(sparse.Exists, !leaf.IsEmpty());
          }
        }
      });
  }
}

TYPED_TEST(TestDirectSearch, EveryPointIsFoundInItsLeaf)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& sample : MakePointSamples<dim, float>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, float> made(sample, { 3, MortonKey<dim>::MaxDepth });
    ForEachLeaf(made.Tree,
      [&](const auto& leaf)
      {
        for (PointIndex place = leaf.FirstPoint; place < leaf.LastPoint; ++place)
        {
          const float* x = sample.GetSpan()[made.Tree.GetPointIds()[place]];
          const MortonKey<dim> key = made.Tree.GetGrid().GetKey(x);
          for (int startDepth = 0; startDepth <= MortonKey<dim>::MaxDepth; startDepth += 3)
          {
            const auto found = FindLeaf(made.Tree, key, startDepth, EmptyOctants::Missing);
            ASSERT_EQ(found.Key, leaf.NodeKey);
            ASSERT_TRUE(found.Exists);
          }
        }
      });
  }
}

TYPED_TEST(TestDirectSearch, FromTheRootEveryAncestorIsLookedUpInOrder)
{
  // Start depth 0 is the classical search (paper section 3a).
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "clusters", MakeClusteredPoints<dim, double>(2000, 71) });
  ForEachLeaf(made.Tree,
    [&made](const auto& leaf)
    {
      const MortonKey<dim> key = leaf.NodeKey.GetFirstAtMaxDepth();
      std::vector<std::uint64_t> ancestors(static_cast<std::size_t>(leaf.NodeKey.GetDepth()));
      for (std::size_t depth = 0; depth < ancestors.size(); ++depth)
      {
        ancestors[depth] = key.AtDepth(static_cast<int>(depth)).GetValue();
      }
      const RecordedTree<dim> recorded(made.Tree);
      NodeCount count;
      ASSERT_EQ(FindLeaf(recorded, key, 0, count).Key, leaf.NodeKey);
      ASSERT_EQ(recorded.LookedUp, ancestors);
      ASSERT_EQ(count.Nodes, ancestors.size() + 1);
    });
}

TYPED_TEST(TestDirectSearch, OnlyLargeTablesAreAskedAhead)
{
  constexpr int dim = TestFixture::Dim;
  const SampleTree<dim, double> made(
    PointSample<dim, double>{ "clusters", MakeClusteredPoints<dim, double>(300, 73) });
  ForEachLeaf(made.Tree,
    [&made](const auto& leaf)
    {
      const MortonKey<dim> key = leaf.NodeKey.GetFirstAtMaxDepth();
      for (int startDepth = 0; startDepth <= MortonKey<dim>::MaxDepth; ++startDepth)
      {
        const RecordedTree<dim> cached(made.Tree);
        ASSERT_EQ(FindLeaf(cached, key, startDepth).Key, leaf.NodeKey);
        ASSERT_TRUE(cached.Asked.empty());

        const RecordedTree<dim> large(made.Tree, false);
        ASSERT_EQ(FindLeaf(large, key, startDepth).Key, leaf.NodeKey);
        ASSERT_EQ(large.LookedUp, cached.LookedUp);
        // The first is wanted at once, and from the root the second, too.
        for (std::size_t look = startDepth == 0 ? 2 : 1; look < large.LookedUp.size(); ++look)
        {
          ASSERT_NE(std::find(large.Asked.begin(), large.Asked.end(), large.LookedUp[look]),
            large.Asked.end());
        }
      }
    });
}

TEST(TestDirectSearchFacts, CountsAddUpOverSearches)
{
  const SampleTree<2, double> made(
    PointSample<2, double>{ "uniform", MakeUniformPoints<2, double>(100, 72) });
  NodeCount count;
  std::uint64_t expected = 0;
  ForEachLeaf(made.Tree,
    [&](const auto& leaf)
    {
      FindLeaf(made.Tree, leaf.NodeKey.GetFirstAtMaxDepth(), 4, count);
      expected += static_cast<std::uint64_t>(1 + std::abs(leaf.NodeKey.GetDepth() - 4));
    });
  EXPECT_EQ(count.Nodes, expected);
}
