// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborCases.h"
#include "PlanarPoints.h"
#include "TestedNeighborsFilter.h"

#include "vtkMultiBlockDataSet.h"

// What is found in quadtrees is compared with a look at every node of the core's quadtree.

using Filter = vtkHashedOctreeNeighborsFilter;
using hashedoctree::EmptyOctants;
using hashedoctree::MortonKey;
using hashedoctree::Octree;

namespace
{
constexpr double Across = 4.5; ///< Where flat points lie.

/** The query leaf comes first, then each expected leaf once, as pixels of the plane. */
void ExpectLeaves(TestedNeighborsFilter& filter, const Octree<2>& tree, const SpacePlane& plane,
  const Octree<2>::Node& query, const BruteForceNeighbors<2>::Keys& expected)
{
  BruteForceNeighbors<2>::Keys found;
  ASSERT_EQ(filter.GetCells()->GetNumberOfCells(), static_cast<vtkIdType>(1 + expected.size()));
  for (vtkIdType cell = 0; cell < filter.GetCells()->GetNumberOfCells(); ++cell)
  {
    const MortonKey<2> key(static_cast<std::uint64_t>(filter.Get("MortonKey", cell)));
    const auto corners = GetCornersInSpace(tree, key, plane, Across);
    double bounds[6];
    filter.GetCells()->GetCellBounds(cell, bounds);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(bounds[2 * axis], corners[0][axis]);
      ASSERT_EQ(bounds[2 * axis + 1], corners[1][axis]);
    }
    ASSERT_EQ(filter.GetCells()->GetCellType(cell), VTK_PIXEL);
    ASSERT_EQ(filter.Get("Depth", cell), key.GetDepth());
    ASSERT_EQ(filter.Get("Role", cell), cell == 0 ? Filter::Query : Filter::Neighbor);
    if (cell > 0)
    {
      found.push_back(key.GetValue());
    }
  }
  EXPECT_EQ(static_cast<std::uint64_t>(filter.Get("MortonKey", 0)), query.NodeKey.GetValue());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

/** Calls check(filter, tree, oracle, plane, leaf, reading) for some leaves of samples in each
 * plane, with the filter's Center in the leaf and far from the plane. */
template <typename Check>
void ForLeaves(const Check& check)
{
  const std::vector<double> samples[] = { MakeUniformPoints<2, double>(60, 96),
    MakeSpherePoints<2, double>(80, 97), MakeClusteredPoints<2, double>(40, 98) };
  for (const std::vector<double>& planar : samples)
  {
    const auto core = MakeCoreQuadtree(planar);
    const BruteForceNeighbors<2> oracle(core.Tree);
    for (const SpacePlane& plane : AllPlanes)
    {
      TestedNeighborsFilter filter(PutInSpace(planar, plane, Across));
      for (const MortonKey<2> key : PickNodes(core.Tree, 40))
      {
        const Octree<2>::Node node = *core.Tree.FindNode(key);
        const EmptyOctants reading =
          key.GetValue() % 3 == 0 ? EmptyOctants::Missing : EmptyOctants::Leaves;
        if (node.Internal || (node.IsEmpty() && reading == EmptyOctants::Missing))
        {
          continue;
        }
        const auto corners = GetCornersInSpace(core.Tree, key, plane, Across);
        std::array<double, 3> center;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          center[axis] = 0.7 * corners[0][axis] + 0.3 * corners[1][axis];
        }
        center[plane.Across] = -1e6;
        filter->SetCenter(center.data());
        filter->SetIncludeEmptyLeaves(reading == EmptyOctants::Leaves);
        check(filter, core.Tree, oracle, plane, node, reading);
      }
    }
  }
}
}

TEST(TestHashedOctreeNeighborsFilterQuadtrees, AdjacentAreTheLeavesThatTouch)
{
  ForLeaves(
    [](TestedNeighborsFilter& filter, const Octree<2>& tree, const BruteForceNeighbors<2>& oracle,
      const SpacePlane& plane, const Octree<2>::Node& leaf, EmptyOctants reading)
    {
      filter.Update();
      ExpectLeaves(filter, tree, plane, leaf, oracle.FindAdjacent(leaf.NodeKey, reading));
    });
}

TEST(TestHashedOctreeNeighborsFilterQuadtrees, InRadiusAreTheLeavesThatMeetTheDisk)
{
  ForLeaves(
    [](TestedNeighborsFilter& filter, const Octree<2>& tree, const BruteForceNeighbors<2>& oracle,
      const SpacePlane& plane, const Octree<2>::Node& leaf, EmptyOctants reading)
    {
      filter->SetSearchMode(Filter::InRadius);
      const double side = tree.GetGrid().GetSide(leaf.NodeKey.GetDepth());
      for (const double radius : { 0.43 * side, 0.57 * side, 1.7 * side, 0.21 })
      {
        filter->SetRadius(radius);
        filter.Update();
        ExpectLeaves(filter, tree, plane, leaf,
          oracle.FindInRadius(leaf.NodeKey, radius, tree.GetGrid().GetSide(), reading));
      }
    });
}

TEST(TestHashedOctreeNeighborsFilterQuadtrees, KeysNameTheirLeavesDownToDepth31)
{
  // The first two points lie in cells of depth 31 side by side.
  const std::vector<double> planar{ 0, 0, std::ldexp(1.0, -30), 0, 2, 2 };
  const auto core = MakeCoreQuadtree(planar, 31);
  const BruteForceNeighbors<2> oracle(core.Tree);
  TestedNeighborsFilter filter(PutInSpace(planar, AllPlanes[0], Across));
  filter->SetMaxDepth(31);
  filter->UseLeafKeyOn();
  for (const double* x : { planar.data(), planar.data() + 2 })
  {
    const MortonKey<2> key = core.Tree.GetGrid().GetKey(x);
    ASSERT_TRUE(core.Tree.FindNode(key));
    filter->SetLeafKey(static_cast<vtkTypeInt64>(key.GetValue()));
    filter.Update();
    EXPECT_EQ(filter.Get("Depth", 0), 31);
    EXPECT_EQ(filter.Get("PointCount", 0), 1);
    ExpectLeaves(filter, core.Tree, AllPlanes[0], *core.Tree.FindNode(key),
      oracle.FindAdjacent(key, EmptyOctants::Leaves));
  }
  for (const vtkTypeInt64 key : { 0, 1, 2, 3, 8, -1 })
  {
    filter->SetLeafKey(key);
    filter.UpdateInError("names no leaf");
  }
}

TEST(TestHashedOctreeNeighborsFilterQuadtrees, TwoProjectsOtherPoints)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(60, 99);
  for (const SpacePlane& plane : AllPlanes)
  {
    const auto core = MakeCoreQuadtree(TakeFromSpace(coordinates, plane));
    const BruteForceNeighbors<2> oracle(core.Tree);
    TestedNeighborsFilter filter(coordinates);
    filter->SetDimension(Filter::Two);
    filter->SetPlane(plane.Name);
    filter->SetCenter(coordinates.data());
    filter.Update();
    const MortonKey<2> key(static_cast<std::uint64_t>(filter.Get("MortonKey", 0)));
    EXPECT_EQ(filter.Get("PointCount", 0), 1);
    EXPECT_EQ(static_cast<std::size_t>(filter.GetCells()->GetNumberOfCells()),
      1 + oracle.FindAdjacent(key, EmptyOctants::Leaves).size());
  }
}

TEST(TestHashedOctreeNeighborsFilterQuadtrees, BlocksOfBothDimensionsAreSearched)
{
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(
    0, MakePolyData(PutInSpace(MakeUniformPoints<2, double>(60, 100), AllPlanes[0], 0.5)));
  input->SetBlock(1, MakeUniform(60, 101));
  TestedNeighborsFilter filter;
  filter->SetInputData(input);
  filter->SetCenter(0.5, 0.5, 0.5);
  filter.UpdateWithoutErrors();
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (const unsigned block : { 0U, 1U })
  {
    auto* cells = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(cells, nullptr);
    EXPECT_GT(cells->GetNumberOfCells(), 3);
    EXPECT_EQ(cells->GetCellType(0), block == 0 ? VTK_PIXEL : VTK_VOXEL);
  }
}
