// SPDX-License-Identifier: BSD-3-Clause
#include "NodeCorners.h"

#include "Dimensions.h"
#include "NodeList.h"
#include "SampleTree.h"
#include "Threads.h"

#include <algorithm>
#include <set>

using namespace hashedoctree;

template <typename Dimension>
class TestNodeCorners : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNodeCorners, Dimensions);

TYPED_TEST(TestNodeCorners, CornersAreWhereTheyShouldBeAndShared)
{
  constexpr int dim = TypeParam::value;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    const auto nodes = ListNodes(made.Tree, NodeListOptions{ true, true }, Execution());
    std::vector<long long> connectivity(nodes.GetSize() << dim);
    const NodeCorners<dim> corners(nodes, connectivity.data(), Execution());
    std::set<Cell<dim>> distinct;
    for (std::size_t node = 0; node < nodes.GetSize(); ++node)
    {
      const int depth = nodes[node].NodeKey.GetDepth();
      const Cell<dim> cell = nodes[node].NodeKey.GetCell();
      for (unsigned corner = 0; corner < (1U << dim); ++corner)
      {
        Cell<dim> expected;
        for (int axis = 0; axis < dim; ++axis)
        {
          // The first axis is the low bit of a corner's place, as in a VTK_VOXEL.
          expected[axis] = (cell[axis] + (corner >> axis & 1U))
            << (MortonKey<dim>::MaxDepth - depth);
        }
        const auto number = static_cast<std::size_t>(connectivity[(node << dim) + corner]);
        ASSERT_LT(number, corners.GetNumberOfCorners());
        ASSERT_EQ(corners.GetCorner(number), expected);
        distinct.insert(expected);
      }
    }
    EXPECT_EQ(corners.GetNumberOfCorners(), distinct.size());
  }
}

TEST(TestNodeCornersFacts, GrowsWhenFewCornersAreShared)
{
  // Leaves far apart share nothing, so that the corners are eight times the nodes.
  PointSample<3, double> sample{ "apart", {} };
  for (int x = 0; x < 27; ++x)
  {
    for (int y = 0; y < 27; ++y)
    {
      for (int z = 0; z < 27; ++z)
      {
        for (const double offset : { 1e-3, 1.5e-3 })
        {
          sample.Coordinates.insert(
            sample.Coordinates.end(), { x + offset, y + offset, z + offset });
        }
      }
    }
  }
  const SampleTree<3, double> made(sample);
  const auto nodes = ListNodes(made.Tree, NodeListOptions{}, Execution());
  std::vector<int> connectivity(8 * nodes.GetSize());
  std::vector<double> looks;
  const Execution execution(OnThreads(1),
    [&looks](double fraction)
    {
      looks.push_back(fraction);
      return true;
    });
  const NodeCorners<3> corners(nodes, connectivity.data(), execution);
  EXPECT_GT(corners.GetNumberOfCorners(), 4 * nodes.GetSize());

  // More looks than from one batch of nodes to the next: each time that something grows, too.
  EXPECT_TRUE(std::is_sorted(looks.begin(), looks.end()));
  EXPECT_GT(looks.size(), 1000U);
  for (const std::size_t last : { std::size_t(1), looks.size() / 2, looks.size() })
  {
    std::size_t left = last;
    const Execution interrupted(OnThreads(1), [&left](double) { return --left != 0; });
    EXPECT_THROW(NodeCorners<3>(nodes, connectivity.data(), interrupted), Interrupted) << last;
  }
}
