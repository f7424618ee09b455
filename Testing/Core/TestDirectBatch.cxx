// SPDX-License-Identifier: BSD-3-Clause
#include "DirectBatch.h"

#include "Dimensions.h"
#include "SampleTree.h"

#include <limits>
#include <utility>
#include <vector>

using namespace hashedoctree;

template <typename Dimension>
class TestDirectBatch : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  static void Check(const Octree<Dim>& tree, PointSpan<Dim, float> positions, std::size_t first,
    std::size_t last, int startDepth, EmptyOctants reading)
  {
    // Checked afterwards: FindLeaves() has all that is called within it inline.
    std::vector<std::pair<std::size_t, FoundLeaf<Dim>>> found;
    found.reserve(last - first);
    const auto remember = [&found](std::size_t i, const FoundLeaf<Dim>& leaf)
    { found.emplace_back(i, leaf); };
    FindLeaves(tree, positions, first, last, startDepth, remember, reading);
    ASSERT_EQ(found.size(), last - first);
    for (std::size_t place = 0; place < found.size(); ++place)
    {
      const auto& [i, leaf] = found[place];
      ASSERT_EQ(i, first + place);
      const MortonKey<Dim> key = tree.GetGrid().GetKey(positions[i]);
      const FoundLeaf<Dim> single = FindLeaf(tree, key, startDepth, reading);
      ASSERT_EQ(leaf.Key, single.Key);
      ASSERT_EQ(leaf.ParentBlock, single.ParentBlock);
      ASSERT_EQ(leaf.Exists, single.Exists);
    }
  }
};
TYPED_TEST_SUITE(TestDirectBatch, Dimensions);

TYPED_TEST(TestDirectBatch, FindsWhatSingleSearchesFindInOrder)
{
  constexpr int dim = TestFixture::Dim;
  // Around the root, and partly outside it.
  PointSample<dim, float> queries{ "queries", MakeUniformPoints<dim, float>(100, 182, -0.2, 1.2) };
  queries.Coordinates[0] = std::numeric_limits<float>::quiet_NaN();
  queries.Coordinates[dim] = std::numeric_limits<float>::infinity();
  for (const auto& sample : MakePointSamples<dim, float>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, float> made(sample);
    for (const EmptyOctants reading : { EmptyOctants::Leaves, EmptyOctants::Missing })
    {
      for (int startDepth = 0; startDepth <= MortonKey<dim>::MaxDepth; ++startDepth)
      {
        this->Check(made.Tree, queries.GetSpan(), 0, 100, startDepth, reading);
      }
    }
  }
}

TYPED_TEST(TestDirectBatch, TakesAnyNumberOfPositions)
{
  constexpr int dim = TestFixture::Dim;
  const PointSample<dim, float> sample{ "uniform", MakeUniformPoints<dim, float>(70, 183) };
  const SampleTree<dim, float> made(sample);
  for (std::size_t count = 0; count <= 70; ++count)
  {
    this->Check(made.Tree, sample.GetSpan(), 70 - count, 70, 3, EmptyOctants::Leaves);
    this->Check(made.Tree, sample.GetSpan(), 0, count, 3, EmptyOctants::Leaves);
  }
}
