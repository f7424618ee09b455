// SPDX-License-Identifier: BSD-3-Clause
#include "NodeCorners.h"

#include "Dimensions.h"
#include "NodeList.h"
#include "OnThisThread.h"
#include "SampleTree.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace hashedoctree;

namespace
{
/** Compares the corners of nodes, of which the first are apart, with what their keys say. */
template <int Dim>
void CheckCorners(const Buffer<typename Octree<Dim>::Node>& nodes, std::size_t apart)
{
  SCOPED_TRACE(apart);
  std::vector<long long> connectivity(nodes.GetSize() << Dim);
  const NodeCorners<Dim> corners(nodes, apart, connectivity.data(), Execution());
  const std::size_t shared = corners.GetNumberOfCorners() - (apart << Dim);
  std::set<Cell<Dim>> distinct;
  for (std::size_t node = 0; node < nodes.GetSize(); ++node)
  {
    const int depth = nodes[node].NodeKey.GetDepth();
    const Cell<Dim> cell = nodes[node].NodeKey.GetCell();
    for (unsigned corner = 0; corner < (1U << Dim); ++corner)
    {
      Cell<Dim> expected;
      for (int axis = 0; axis < Dim; ++axis)
      {
        // The first axis is the low bit of a corner's place, as in a VTK_VOXEL.
        expected[axis] = (cell[axis] + (corner >> axis & 1U)) << (MortonKey<Dim>::MaxDepth - depth);
      }
      const auto number = static_cast<std::size_t>(connectivity[(node << Dim) + corner]);
      ASSERT_LT(number, corners.GetNumberOfCorners());
      ASSERT_EQ(corners.GetCorner(number), expected);
      if (node < apart)
      {
        ASSERT_EQ(number, shared + (node << Dim) + corner);
        continue;
      }
      ASSERT_LT(number, shared);
      distinct.insert(expected);
    }
  }
  EXPECT_EQ(shared, distinct.size());
}

/** Nodes, and what numbering their corners tells of its progress. */
struct Numbering
{
  /** Of the leaves of a sample. */
  explicit Numbering(const PointSample<3, double>& sample)
    : Numbering(ListNodes(SampleTree<3, double>(sample).Tree, NodeListOptions{}, Execution()))
  {
  }
  explicit Numbering(Buffer<Octree<3>::Node> nodes)
    : Nodes(std::move(nodes))
  {
    this->NumberOfCorners = this->Number(
      [this](double fraction)
      {
        this->Looks.push_back(fraction);
        return true;
      });
  }

  /** Numbers the corners; returns how many they are. */
  std::size_t Number(const Execution::Progress& progress) const
  {
    std::vector<int> connectivity(8 * this->Nodes.GetSize());
    return NodeCorners<3>(this->Nodes, 0, connectivity.data(), Execution(OnThisThread, progress))
      .GetNumberOfCorners();
  }

  Buffer<Octree<3>::Node> Nodes;
  std::vector<double> Looks;
  std::size_t NumberOfCorners;
};
}

template <typename Dimension>
class TestNodeCorners : public ::testing::Test
{
};
TYPED_TEST_SUITE(TestNodeCorners, Dimensions);

TYPED_TEST(TestNodeCorners, CornersAreWhereTheyShouldBeAndShared)
{
  constexpr int dim = TypeParam::value;
  auto samples = MakePointSamples<dim, double>();
  samples.push_back({ "many", MakeUniformPoints<dim, double>(5000, 125) });
  std::mt19937 random(126);
  for (const auto& sample : samples)
  {
    SCOPED_TRACE(sample.Name);
    const SampleTree<dim, double> made(sample);
    auto nodes = ListNodes(made.Tree, NodeListOptions{ true, true }, Execution());
    for (const bool isShuffled : { false, true })
    {
      SCOPED_TRACE(isShuffled);
      if (isShuffled)
      {
        std::shuffle(nodes.GetData(), nodes.GetData() + nodes.GetSize(), random);
      }
      for (const std::size_t apart : { std::size_t(0), std::size_t(1), nodes.GetSize() })
      {
        CheckCorners<dim>(nodes, apart);
      }
    }
  }
}

TEST(TestNodeCornersFacts, ReportsProgressWhenFewCornersAreShared)
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
  Numbering numbering(sample);
  const std::vector<double>& looks = numbering.Looks;
  EXPECT_GT(numbering.NumberOfCorners, 4 * numbering.Nodes.GetSize());

  // One look each time that a shard is full.
  EXPECT_TRUE(std::is_sorted(looks.begin(), looks.end()));
  EXPECT_GT(looks.size(), 1000U);
  for (const std::size_t last : { std::size_t(1), looks.size() / 2, looks.size() })
  {
    std::size_t left = last;
    EXPECT_THROW(numbering.Number([&left](double) { return --left != 0; }), Interrupted) << last;
  }
}

TEST(TestNodeCornersFacts, ReportsProgressWhenMostCornersAreShared)
{
  // One point in the middle of each cell: a complete tree, with hardly more corners than nodes.
  PointSample<3, double> sample{ "full", {} };
  constexpr int side = 32;
  for (int x = 0; x < side; ++x)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int z = 0; z < side; ++z)
      {
        sample.Coordinates.insert(sample.Coordinates.end(), { x + 0.5, y + 0.5, z + 0.5 });
      }
    }
  }
  const Numbering numbering(sample);
  const std::vector<double>& looks = numbering.Looks;
  ASSERT_LT(numbering.NumberOfCorners, 2 * numbering.Nodes.GetSize());
  double last = 0.0;
  for (const double look : looks)
  {
    ASSERT_LE(look - last, 0.125);
    last = look;
  }
  EXPECT_GE(last, 0.999);
}

TEST(TestNodeCornersFacts, ProgressNeverFalls)
{
  // All nodes of a depth: enough of them for reports from each part of the work.
  constexpr int depth = 6;
  const MortonKey<3> first = MortonKey<3>::Root().GetFirstAtMaxDepth().AtDepth(depth);
  constexpr std::size_t side = 1U << depth;
  Buffer<Octree<3>::Node> nodes(side * side * side);
  for (std::size_t i = 0; i < nodes.GetSize(); ++i)
  {
    nodes[i] = { MortonKey<3>(first.GetValue() + i), 0, 0, false };
  }
  const Numbering numbering(std::move(nodes));
  const std::vector<double>& looks = numbering.Looks;
  EXPECT_EQ(numbering.NumberOfCorners, (side + 1) * (side + 1) * (side + 1));
  EXPECT_TRUE(std::is_sorted(looks.begin(), looks.end()));
  EXPECT_GE(looks.back(), 0.999);
}
