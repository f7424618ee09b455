// SPDX-License-Identifier: BSD-3-Clause
#include "ExpectOctree.h"
#include "NodeList.h"
#include "PlanarPoints.h"
#include "SameOutputs.h"

#include "vtkMultiBlockDataSet.h"

// Quadtrees are compared with the core's, which is tested against a plain one.

using Filter = vtkHashedOctreeFilter;
using hashedoctree::Octree;

namespace
{
constexpr double Across = -2.5; ///< Where flat points lie.

/** The points of a cell in space. */
std::vector<std::array<double, 3>> GetCellCorners(vtkDataSet* cells, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  cells->GetCellPoints(cell, ids);
  std::vector<std::array<double, 3>> corners(static_cast<std::size_t>(ids->GetNumberOfIds()));
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    cells->GetPoint(ids->GetId(i), corners[static_cast<std::size_t>(i)].data());
  }
  return corners;
}

/** The corners of a square of which two are given, in the order of a VTK_PIXEL. */
std::vector<std::array<double, 3>> GetSquare(
  const std::array<std::array<double, 3>, 2>& ends, const SpacePlane& plane)
{
  std::vector<std::array<double, 3>> corners(4, ends[0]);
  for (unsigned corner = 0; corner < 4; ++corner)
  {
    corners[corner][plane.Axes[0]] = ends[corner & 1U][plane.Axes[0]];
    corners[corner][plane.Axes[1]] = ends[corner >> 1][plane.Axes[1]];
  }
  return corners;
}

/** Port 0 shows the nodes of a quadtree, in its order, in a plane at the given place. */
void ExpectQuadtree(
  TestedFilter& filter, const Octree<2>& tree, const SpacePlane& plane, double across)
{
  const bool outlines = filter->GetOutputType() == Filter::Outlines;
  vtkDataSet* cells = filter.GetCells();
  const auto nodes = hashedoctree::ListNodes(
    tree, { filter->GetIncludeEmptyLeaves(), filter->GetIncludeInternalNodes() }, {});
  ASSERT_EQ(filter.GetFieldValue("Dimension"), 2);
  ASSERT_EQ(cells->GetNumberOfCells(), static_cast<vtkIdType>(nodes.GetSize()));
  const double startDepth = filter.GetFieldValue("StartDepth");
  std::set<std::array<std::int64_t, 2>> places;
  for (std::size_t i = 0; i < nodes.GetSize(); ++i)
  {
    const auto& node = nodes[i];
    const auto cell = static_cast<vtkIdType>(i);
    const auto get = [cells, cell](const char* name)
    { return cells->GetCellData()->GetArray(name)->GetVariantValue(cell).ToUnsignedLongLong(); };
    const auto depth = static_cast<unsigned>(node.NodeKey.GetDepth());
    ASSERT_EQ(get("MortonKey"), node.NodeKey.GetValue());
    ASSERT_EQ(get("Depth"), depth);
    ASSERT_EQ(get("PointCount"), node.GetNumberOfPoints());
    ASSERT_EQ(get("RootCost"), node.Internal ? 0 : 1 + depth);
    ASSERT_EQ(static_cast<double>(get("HitCost")),
      node.Internal ? 0.0 : 1.0 + std::abs(static_cast<double>(depth) - startDepth));

    auto corners = GetSquare(GetCornersInSpace(tree, node.NodeKey, plane, across), plane);
    if (outlines)
    {
      corners = { corners[0], corners[1], corners[3], corners[2], corners[0] };
    }
    ASSERT_EQ(cells->GetCellType(cell), outlines ? VTK_POLY_LINE : VTK_PIXEL);
    ASSERT_EQ(GetCellCorners(cells, cell), corners) << "cell " << i;
    const NodeBox<2> box(node.NodeKey);
    places.insert({ { box.Lower[0], box.Lower[1] }, { box.Upper[0], box.Lower[1] },
      { box.Lower[0], box.Upper[1] }, { box.Upper[0], box.Upper[1] } });
  }
  EXPECT_EQ(static_cast<std::size_t>(cells->GetNumberOfPoints()), places.size())
    << "neighbours share corners";
}

double GetDimension(const std::vector<double>& coordinates)
{
  TestedFilter filter(coordinates);
  filter.UpdateWithoutErrors();
  return filter.GetFieldValue("Dimension");
}

/** Flat points whose extents are 2, two of them 2^-30 apart, the last bit of a quadtree's cells. */
const std::vector<double> DeepPoints{ 0, 0, std::ldexp(1.0, -30), 0, 2, 2 };
}

TEST(TestHashedOctreeFilterQuadtrees, CellsAreTheNodesOfTheCoresQuadtree)
{
  for (const auto& sample : MakeFinitePointSamples<2, double>())
  {
    SCOPED_TRACE(sample.Name);
    const auto core = MakeCoreQuadtree(sample.Coordinates);
    for (const SpacePlane& plane : AllPlanes)
    {
      TestedFilter filter(PutInSpace(sample.Coordinates, plane, Across));
      filter->SetDimension(Filter::Two);
      filter->SetPlane(plane.Name);
      for (unsigned shown = 0; shown < 8; ++shown)
      {
        filter->SetOutputType((shown & 1U) != 0 ? Filter::Outlines : Filter::Voxels);
        filter->SetIncludeEmptyLeaves((shown & 2U) != 0);
        filter->SetIncludeInternalNodes((shown & 4U) != 0);
        filter.Update();
        ExpectQuadtree(filter, core.Tree, plane, Across);
      }
    }
  }
}

TEST(TestHashedOctreeFilterQuadtrees, AutoFindsThePlaneOfFlatPoints)
{
  const std::vector<double> planar = MakeSpherePoints<2, double>(300, 60);
  const auto core = MakeCoreQuadtree(planar);
  for (const SpacePlane& plane : AllPlanes)
  {
    TestedFilter filter(PutInSpace(planar, plane, Across));
    filter->SetPlane(AllPlanes[plane.Across].Name); // Not used.
    filter.Update();
    ExpectQuadtree(filter, core.Tree, plane, Across);
  }
}

TEST(TestHashedOctreeFilterQuadtrees, AutoIsTwoWhereOneExtentIsNothing)
{
  const double almost = std::nextafter(5.0, 6.0);
  EXPECT_EQ(GetDimension({ 0, 0, 5, 1, 2, 5, 3, 1, 5 }), 2) << "flat";
  EXPECT_EQ(GetDimension({ 0, 0, 5, 1, 1, 5 }), 2) << "a line across a plane";
  EXPECT_EQ(GetDimension({ 0, 0, 0.0, 1, 2, -0.0, 3, 1, 0.0 }), 2) << "zeros of both signs";
  EXPECT_EQ(GetDimension({ 0, 0, 5, 1, 2, almost, 3, 1, 5 }), 3) << "almost flat";
  EXPECT_EQ(GetDimension({ 0, 0, 5, 0, 2, 5, 0, 7, 5 }), 3) << "a line along an axis";
  EXPECT_EQ(GetDimension({ 4, 4, 5, 4, 4, 5 }), 3) << "one place";
  EXPECT_EQ(GetDimension({ 0, 0, 5, 1, 2, 5, 3, 1, NAN, NAN, 1, 4, 1, INFINITY, 3 }), 2)
    << "points that are left out";
}

TEST(TestHashedOctreeFilterQuadtrees, LeavesTileTheRoot)
{
  const std::vector<double> planar = MakeClusteredPoints<2, double>(300, 61);
  TestedFilter filter(PutInSpace(planar, AllPlanes[0], Across));
  filter->SetMaxDepth(31);
  filter->IncludeEmptyLeavesOn();
  filter.Update();
  vtkDataSet* cells = filter.GetCells();
  std::uint64_t area = 0; // In cells of depth 31.
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const auto depth = static_cast<int>(cells->GetCellData()->GetArray("Depth")->GetTuple1(cell));
    area += std::uint64_t(1) << (2 * (31 - depth));
  }
  EXPECT_EQ(area, std::uint64_t(1) << 62);

  const auto core = MakeCoreQuadtree(planar, 31);
  const std::vector<double> positions = MakeUniformPoints<2, double>(200, 62);
  for (std::size_t i = 0; i < positions.size(); i += 2)
  {
    int holding = 0;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      double b[6];
      cells->GetCellBounds(cell, b);
      const auto& lower = core.Tree.GetGrid().GetLower();
      const double x = lower[0] + positions[i] * core.Tree.GetGrid().GetSide();
      const double y = lower[1] + positions[i + 1] * core.Tree.GetGrid().GetSide();
      holding += b[0] <= x && x < b[1] && b[2] <= y && y < b[3] ? 1 : 0;
    }
    ASSERT_EQ(holding, 1);
  }
}

TEST(TestHashedOctreeFilterQuadtrees, ReachDepth31)
{
  TestedFilter filter(PutInSpace(DeepPoints, AllPlanes[0], Across));
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("DeepestDepth"), 21) << "the default";
  filter->SetMaxDepth(31);
  filter->IncludeEmptyLeavesOn();
  filter->IncludeInternalNodesOn();
  filter->SetStartDepthModel(Filter::Fixed);
  filter->SetFixedStartDepth(31);
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("DeepestDepth"), 31);
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), 31);
  ExpectQuadtree(filter, MakeCoreQuadtree(DeepPoints, 31).Tree, AllPlanes[0], Across);
  EXPECT_EQ(filter.GetHistogram()->GetNumberOfRows(), 32);
  EXPECT_EQ(filter.GetCosts()->GetNumberOfRows(), 32);
}

TEST(TestHashedOctreeFilterQuadtrees, InOctreesDepthsEndAt21)
{
  for (const int dimension : { Filter::Auto, Filter::Three })
  {
    std::vector<double> coordinates = PutInSpace(DeepPoints, AllPlanes[0], Across);
    coordinates.back() += dimension == Filter::Auto ? 1 : 0; // Not flat.
    TestedFilter filter(coordinates);
    filter->SetDimension(dimension);
    filter->SetStartDepthModel(Filter::Fixed);
    filter->SetFixedStartDepth(21);
    const auto outputs = TakeOutputs(filter.GetFilter());
    EXPECT_EQ(filter.GetFieldValue("Dimension"), 3);
    filter->SetMaxDepth(31);
    filter->SetFixedStartDepth(31);
    ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
    EXPECT_EQ(filter.GetFieldValue("DeepestDepth"), 21);
  }
}

TEST(TestHashedOctreeFilterQuadtrees, TwoProjectsOtherPoints)
{
  std::vector<double> coordinates = MakeSpherePoints<3, double>(300, 63);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    for (const SpacePlane& plane : AllPlanes)
    {
      TestedFilter filter;
      filter->SetInputData(MakePolyData(coordinates, type));
      filter->SetDimension(Filter::Two);
      filter->SetPlane(plane.Name);
      filter.Update();
      double lowest = INFINITY;
      for (std::size_t i = 0; i < coordinates.size(); i += 3)
      {
        lowest = std::min(lowest, coordinates[i + plane.Across]);
      }
      ExpectQuadtree(
        filter, MakeCoreQuadtree(TakeFromSpace(coordinates, plane)).Tree, plane, lowest);
    }
    for (double& x : coordinates)
    {
      x = static_cast<double>(static_cast<float>(x));
    }
  }
}

TEST(TestHashedOctreeFilterQuadtrees, WidestIsAcrossTheSmallestExtent)
{
  const std::vector<double> cube = MakeUniformPoints<3, double>(100, 64);
  for (const SpacePlane& plane : AllPlanes)
  {
    std::vector<double> coordinates = cube;
    for (std::size_t i = plane.Across; i < coordinates.size(); i += 3)
    {
      coordinates[i] *= 0.1;
    }
    TestedFilter filter(coordinates);
    filter->SetDimension(Filter::Two);
    const auto outputs = TakeOutputs(filter.GetFilter());
    filter->SetPlane(plane.Name);
    ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
  }
  // Of equal extents z is the smallest, then y.
  const std::pair<std::vector<double>, int> equals[] = { { { 0, 0, 0, 1, 1, 1 }, Filter::XY },
    { { 0, 0, 0, 1, 0, 0 }, Filter::XY }, { { 0, 0, 0, 0, 0, 1 }, Filter::XZ },
    { { 0, 0, 0, 0, 0, 0 }, Filter::XY } };
  for (const auto& [coordinates, plane] : equals)
  {
    TestedFilter filter(coordinates);
    filter->SetDimension(Filter::Two);
    const auto outputs = TakeOutputs(filter.GetFilter());
    filter->SetPlane(plane);
    ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
  }
}

TEST(TestHashedOctreeFilterQuadtrees, ThreeGivesFlatPointsAnOctree)
{
  for (const SpacePlane& plane : AllPlanes)
  {
    const auto coordinates = PutInSpace(MakeUniformPoints<2, double>(200, 65), plane, Across);
    TestedFilter filter(coordinates);
    filter->SetDimension(Filter::Three);
    UpdateAndExpectOctree(filter, coordinates);
    EXPECT_EQ(filter.GetFieldValue("Dimension"), 3);
  }
}

TEST(TestHashedOctreeFilterQuadtrees, PointsThatAreNotFiniteAreLeftOutOfThemToo)
{
  const std::vector<double> good{ 0, 0, 5, 1, 2, 5, 3, 1, 5, 2, 2, 5 };
  std::vector<double> some = good;
  some.insert(some.end(), { 1, 1, NAN, 1.5, 1, INFINITY, NAN, 1, 5, 1, -INFINITY, 5 });
  for (const int dimension : { Filter::Auto, Filter::Two })
  {
    TestedFilter all(good);
    TestedFilter filter(some);
    all->SetDimension(dimension);
    filter->SetDimension(dimension);
    all.Update();
    filter.Update();
    filter.ExpectWarning("4 of 8 points");
    EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 4);
    ExpectSameArrays(filter.GetCells()->GetCellData(), all.GetCells()->GetCellData());
  }
}

TEST(TestHashedOctreeFilterQuadtrees, EachBlockHasItsOwnDimension)
{
  const auto flat =
    MakePolyData(PutInSpace(MakeUniformPoints<2, double>(90, 66), AllPlanes[1], Across));
  const auto full = MakeUniform(90, 67);
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, flat);
  input->SetBlock(1, full);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateWithoutErrors();
  for (const unsigned block : { 0U, 1U })
  {
    TestedFilter alone;
    alone->SetInputData(input->GetBlock(block));
    const auto outputs = TakeOutputs(alone.GetFilter());
    EXPECT_EQ(alone.GetFieldValue("Dimension"), 2 + block);
    EXPECT_EQ(alone.GetCells()->GetCellType(0), block == 0 ? VTK_PIXEL : VTK_VOXEL);
    for (int port = 0; port < 3; ++port)
    {
      ExpectSame(
        vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port))->GetBlock(block),
        outputs[static_cast<std::size_t>(port)]);
    }
  }
}

TEST(TestHashedOctreeFilterQuadtrees, CustomBoundsDecideInPlaceOfThePoints)
{
  std::vector<double> coordinates =
    PutInSpace(MakeUniformPoints<2, double>(100, 68), AllPlanes[0], Across);
  TestedFilter filter(coordinates);
  filter->UseCustomBoundsOn();
  const std::array<double, 6> full{ 0, 2, 0, 1, -3, 4 };
  filter->SetCustomBounds(full.data());
  filter.Update();
  ExpectOctree(filter, OracleOctree(coordinates, full));

  // Flat bounds hold only points in their plane, as in an octree.
  coordinates.insert(coordinates.end(), { 0.5, 0.5, Across + 1e-9, 0.5, 0.25, 7 });
  filter->SetInputData(MakePolyData(coordinates));
  filter->SetCustomBounds(0, 1, 0, 0.5, Across, Across);
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("Dimension"), 2);
  EXPECT_EQ(filter.GetCells()->GetBounds()[4], Across);
  EXPECT_EQ(filter.GetCells()->GetBounds()[5], Across);
  const double inside = filter.GetFieldValue("NumberOfPoints");
  EXPECT_GT(inside, 10);
  EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 102 - inside);

  // With Two the plane is where the bounds begin, and points are projected to it.
  filter->SetDimension(Filter::Two);
  filter->SetPlane(Filter::XY);
  filter->SetCustomBounds(0, 1, 0, 1, -3, 6);
  filter->IncludeEmptyLeavesOn();
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 101);
  EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 1) << "across the plane";
  const std::vector<double> bounds(
    filter.GetCells()->GetBounds(), filter.GetCells()->GetBounds() + 6);
  EXPECT_EQ(bounds, std::vector<double>({ 0, 1, 0, 1, -3, -3 }));
  filter->SetCustomBounds(0, 1, 0, 1, 6, -3);
  filter.UpdateInError("bounds");
}

TEST(TestHashedOctreeFilterQuadtrees, PointsOnEitherSideOfTheBoundsAreLeftOut)
{
  std::vector<double> coordinates;
  for (const double across : { -7.0, 7.0, Across })
  {
    const auto points = PutInSpace(MakeUniformPoints<2, double>(100, 69), AllPlanes[0], across);
    coordinates.insert(coordinates.end(), points.begin(), points.end());
  }
  TestedFilter inside(std::vector<double>(coordinates.end() - 300, coordinates.end()));
  TestedFilter filter(coordinates);
  for (TestedFilter* one : { &inside, &filter })
  {
    (*one)->SetDimension(Filter::Two);
    (*one)->SetPlane(Filter::XY);
    (*one)->UseCustomBoundsOn();
    (*one)->SetCustomBounds(0, 1, 0, 1, -3, 6);
  }
  for (const bool merge : { false, true })
  {
    inside->SetMergePoints(merge);
    inside.Update();
    filter->SetMergePoints(merge);
    filter.Update();
    EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 100);
    EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 200);
    ExpectSameArrays(filter.GetCells()->GetCellData(), inside.GetCells()->GetCellData());
  }
}

TEST(TestHashedOctreeFilterQuadtrees, WithoutPointsInTheBoundsMakeNothing)
{
  TestedFilter filter(PutInSpace(MakeUniformPoints<2, double>(10, 69), AllPlanes[0], Across));
  filter->SetDimension(Filter::Two);
  filter->UseCustomBoundsOn();
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("CustomBounds");
  filter.ExpectEmptyOutputs();
  filter->UseCustomBoundsOff();
  filter->SetInputData(MakePolyData({ NAN, 0, 0 }));
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("1 of 1 points");
  filter.ExpectEmptyOutputs();
}

TEST(TestHashedOctreeFilterQuadtrees, TablesAreThoseOfFourChildren)
{
  std::vector<double> planar = MakeUniformPoints<2, double>(60, 70, 0.0, 1e-4);
  planar.insert(planar.end(), { 1, 1, 0.1, 0.1, 0.1, 0.1 });
  TestedFilter filter(PutInSpace(planar, AllPlanes[2], Across));
  filter->SetFrequencyModel(Filter::Grid);
  filter->IncludeEmptyLeavesOn();
  filter.Update();
  const auto column = [](vtkTable* table, const char* name)
  { return vtkDataArray::SafeDownCast(table->GetColumnByName(name)); };
  const int deepest = static_cast<int>(filter.GetFieldValue("DeepestDepth"));
  ASSERT_EQ(filter.GetHistogram()->GetNumberOfRows(), deepest + 1);
  ASSERT_EQ(filter.GetCosts()->GetNumberOfRows(), deepest + 1);

  // From the cells alone.
  vtkDataArray* depths = filter.GetCells()->GetCellData()->GetArray("Depth");
  std::vector<double> leaves(static_cast<std::size_t>(deepest) + 1, 0.0);
  for (vtkIdType cell = 0; cell < depths->GetNumberOfTuples(); ++cell)
  {
    leaves[static_cast<std::size_t>(depths->GetTuple1(cell))] += 1.0;
  }
  double area = 0.0;
  int cheapest = 0;
  vtkDataArray* gridCosts = column(filter.GetCosts(), "CostGrid");
  for (int row = 0; row <= deepest; ++row)
  {
    const double weight = column(filter.GetHistogram(), "GridWeight")->GetTuple1(row);
    const double count = leaves[static_cast<std::size_t>(row)];
    EXPECT_EQ(column(filter.GetHistogram(), "Leaves")->GetTuple1(row), count);
    EXPECT_EQ(weight, count * std::pow(4.0, deepest - row));
    area += weight;
    double cost = 0.0;
    for (int depth = 0; depth <= deepest; ++depth)
    {
      cost += leaves[static_cast<std::size_t>(depth)] * std::pow(4.0, -depth) *
        (1 + std::abs(depth - row));
    }
    EXPECT_NEAR(gridCosts->GetTuple1(row), cost, 1e-12 * cost);
    EXPECT_EQ(column(filter.GetCosts(), "CostLeaves")->GetTuple1(row),
      column(filter.GetCosts(), "MeasuredLeaves")->GetTuple1(row));
    cheapest = gridCosts->GetTuple1(row) < gridCosts->GetTuple1(cheapest) ? row : cheapest;
  }
  EXPECT_EQ(area, std::pow(4.0, deepest));
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), cheapest);
  EXPECT_EQ(filter.GetFieldValue("StartDepthGrid"), cheapest);
  EXPECT_NEAR(filter.GetFieldValue("MeanHitCost"), gridCosts->GetTuple1(cheapest), 1e-12);
  EXPECT_NEAR(filter.GetFieldValue("MeanRootCost"), gridCosts->GetTuple1(0), 1e-12);
  EXPECT_NE(filter.GetFieldValue("StartDepthLeaves"), cheapest) << "so that the models differ";
}

TEST(TestHashedOctreeFilterQuadtrees, StartDepthsWeighLeavesByTheirArea)
{
  // A point in each cell of depth 3, but for one quadrant, which is a leaf: a quarter of the area.
  // Weighed as cubes, it would be more than half.
  std::vector<double> planar;
  for (int x = 0; x < 8; ++x)
  {
    for (int y = 0; y < 8; ++y)
    {
      if (x < 4 || y < 4 || (x == 7 && y == 7))
      {
        planar.insert(planar.end(), { x / 7.0, y / 7.0 });
      }
    }
  }
  TestedFilter filter(PutInSpace(planar, AllPlanes[0], Across));
  filter->SetFrequencyModel(Filter::Grid);
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("NumberOfLeaves"), 49);
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), 3);
  EXPECT_EQ(filter.GetFieldValue("StartDepthGrid"), 3);
  EXPECT_NEAR(filter.GetFieldValue("MeanHitCost"), 0.75 * 1 + 0.25 * 3, 1e-12);
}
