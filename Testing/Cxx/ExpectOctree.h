// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_ExpectOctree_h
#define Testing_Cxx_ExpectOctree_h

#include "ExpectedOctree.h"
#include "TestedFilter.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

/** The weights of the frequency models, in the order of vtkHashedOctreeFilter's. */
inline ExpectedOctree::Weight GetWeight(int frequencyModel)
{
  const ExpectedOctree::Weight weights[] = { ExpectedOctree::Leaves, ExpectedOctree::Points,
    ExpectedOctree::Grid };
  return weights[frequencyModel];
}

inline int GetExpectedStartDepth(
  vtkHashedOctreeFilter* filter, const ExpectedOctree& expected, int frequencyModel)
{
  const ExpectedOctree::Weight weight = GetWeight(frequencyModel);
  switch (filter->GetStartDepthModel())
  {
    case vtkHashedOctreeFilter::Median:
      return expected.GetCheapestStartDepth(weight);
    case vtkHashedOctreeFilter::Mean:
      return static_cast<int>(std::floor(expected.GetMeanDepth(weight) + 0.5L));
    case vtkHashedOctreeFilter::Root:
      return 0;
    default:
      return filter->GetFixedStartDepth();
  }
}

/** The nodes that port 0 must show, in its order. */
inline std::vector<ExpectedOctree::Node> GetShownNodes(
  vtkHashedOctreeFilter* filter, const ExpectedOctree& expected)
{
  std::vector<ExpectedOctree::Node> shown;
  for (const ExpectedOctree::Node& node : expected.GetNodes())
  {
    if (node.Internal ? filter->GetIncludeInternalNodes()
                      : !node.Points.empty() || filter->GetIncludeEmptyLeaves())
    {
      shown.push_back(node);
    }
  }
  return shown;
}

/** One row for each cell: Depth, HitCost, RootCost, PointCount, MortonKey. */
inline void ExpectCellArrays(TestedFilter& filter, const ExpectedOctree& expected)
{
  vtkCellData* arrays = filter.GetCells()->GetCellData();
  ASSERT_EQ(arrays->GetNumberOfArrays(), 5);
  ASSERT_NE(arrays->GetScalars(), nullptr);
  EXPECT_STREQ(arrays->GetScalars()->GetName(), "Depth");
  const auto get = [arrays](const char* name, int type) -> vtkDataArray*
  {
    vtkDataArray* array = arrays->GetArray(name);
    return array != nullptr && array->GetDataType() == type ? array : nullptr;
  };
  vtkDataArray* depth = get("Depth", VTK_INT);
  vtkDataArray* hitCost = get("HitCost", VTK_INT);
  vtkDataArray* rootCost = get("RootCost", VTK_INT);
  vtkDataArray* pointCount = get("PointCount", VTK_ID_TYPE);
  vtkDataArray* key = get("MortonKey", VTK_TYPE_UINT64);
  ASSERT_TRUE(depth && hitCost && rootCost && pointCount && key);

  const int startDepth =
    GetExpectedStartDepth(filter.GetFilter(), expected, filter->GetFrequencyModel());
  const auto shown = GetShownNodes(filter.GetFilter(), expected);
  ASSERT_EQ(filter.GetCells()->GetNumberOfCells(), static_cast<vtkIdType>(shown.size()));
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const ExpectedOctree::Node& node = shown[i];
    const auto cell = static_cast<vtkIdType>(i);
    ASSERT_EQ(key->GetVariantValue(cell).ToUnsignedLongLong(), node.Key) << "cell " << i;
    ASSERT_EQ(depth->GetTuple1(cell), node.Depth) << "cell " << i;
    ASSERT_EQ(pointCount->GetTuple1(cell), node.Points.size()) << "cell " << i;
    ASSERT_EQ(hitCost->GetTuple1(cell), node.Internal ? 0 : 1 + std::abs(node.Depth - startDepth))
      << "cell " << i;
    ASSERT_EQ(rootCost->GetTuple1(cell), node.Internal ? 0 : 1 + node.Depth) << "cell " << i;
  }
}

/** The corner of a node with the given number, whose bit 0 is x as in a VTK_VOXEL. */
inline ExpectedOctree::Place GetCorner(const ExpectedOctree::Node& node, unsigned corner)
{
  ExpectedOctree::Place place = node.Lower;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    place[axis] += (corner >> axis & 1U) != 0 ? node.Side : 0;
  }
  return place;
}

/** Gathers the points of the output by the corners that they stand for: each in its place, and one
 * for each corner. */
class CornerCensus
{
public:
  CornerCensus(vtkDataSet* cells, const ExpectedOctree& expected)
    : Cells(cells)
    , Expected(expected)
  {
  }

  void Add(vtkIdType point, const ExpectedOctree::Place& corner)
  {
    const auto [known, isNew] = this->Points.emplace(corner, point);
    ASSERT_EQ(known->second, point) << "one corner, two points";
    for (std::size_t axis = 0; isNew && axis < 3; ++axis)
    {
      const double position = this->Expected.GetPosition(corner, axis);
      const double scale = std::abs(position) + this->Expected.GetRootSide();
      ASSERT_NEAR(this->Cells->GetPoint(point)[axis], position,
        4 * std::numeric_limits<double>::epsilon() * scale);
    }
  }

  void ExpectComplete() const
  {
    std::set<vtkIdType> used;
    for (const auto& [corner, point] : this->Points)
    {
      used.insert(point);
    }
    EXPECT_EQ(used.size(), this->Points.size()) << "one point, two corners";
    EXPECT_EQ(static_cast<std::size_t>(this->Cells->GetNumberOfPoints()), used.size());
  }

private:
  vtkDataSet* Cells;
  const ExpectedOctree& Expected;
  std::map<ExpectedOctree::Place, vtkIdType> Points;
};

inline void ExpectVoxels(TestedFilter& filter, const ExpectedOctree& expected)
{
  const auto shown = GetShownNodes(filter.GetFilter(), expected);
  ASSERT_EQ(filter.GetCells()->GetDataObjectType(), VTK_UNSTRUCTURED_GRID);
  ASSERT_EQ(filter.GetCells()->GetNumberOfCells(), static_cast<vtkIdType>(shown.size()));
  CornerCensus corners(filter.GetCells(), expected);
  vtkNew<vtkIdList> points;
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    filter.GetCells()->GetCellPoints(cell, points);
    ASSERT_EQ(filter.GetCells()->GetCellType(cell), VTK_VOXEL);
    ASSERT_EQ(points->GetNumberOfIds(), 8);
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      ASSERT_NO_FATAL_FAILURE(corners.Add(points->GetId(corner), GetCorner(shown[i], corner)))
        << "cell " << i;
    }
  }
  corners.ExpectComplete();
}

/** Each outline must walk along the twelve edges of its node, and nowhere else. */
inline void ExpectOutlines(TestedFilter& filter, const ExpectedOctree& expected)
{
  const auto shown = GetShownNodes(filter.GetFilter(), expected);
  ASSERT_EQ(filter.GetCells()->GetDataObjectType(), VTK_POLY_DATA);
  ASSERT_EQ(filter.GetCells()->GetNumberOfCells(), static_cast<vtkIdType>(shown.size()));
  CornerCensus corners(filter.GetCells(), expected);
  vtkNew<vtkIdList> points;
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    filter.GetCells()->GetCellPoints(cell, points);
    ASSERT_EQ(filter.GetCells()->GetCellType(cell), VTK_POLY_LINE);
    ASSERT_EQ(points->GetNumberOfIds(), 16);
    std::set<std::pair<unsigned, unsigned>> edges;
    unsigned last = 0;
    for (vtkIdType j = 0; j < 16; ++j)
    {
      // Which corner of the node this is follows from the position; an empty step stays in place.
      const double* x = filter.GetCells()->GetPoint(points->GetId(j));
      unsigned corner = 0;
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        const double middle = (expected.GetPosition(GetCorner(shown[i], 0), axis) +
                                expected.GetPosition(GetCorner(shown[i], 7), axis)) /
          2;
        corner |= x[axis] > middle ? 1U << axis : 0U;
      }
      ASSERT_NO_FATAL_FAILURE(corners.Add(points->GetId(j), GetCorner(shown[i], corner)))
        << "cell " << i;
      if (j > 0)
      {
        const unsigned step = last ^ corner;
        ASSERT_TRUE(step == 1 || step == 2 || step == 4) << "cell " << i << ": not along an edge";
        edges.emplace(std::min(last, corner), std::max(last, corner));
      }
      last = corner;
    }
    ASSERT_EQ(edges.size(), 12U) << "cell " << i;
  }
  corners.ExpectComplete();
}

/** The column of a table; fails where it has another place, name or type. */
inline vtkDataArray* GetColumn(vtkTable* table, int column, const std::string& name, int type)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumn(column));
  EXPECT_NE(array, nullptr) << name;
  if (array != nullptr)
  {
    EXPECT_EQ(array->GetName(), name);
    EXPECT_EQ(array->GetDataType(), type) << name;
  }
  return array;
}

inline void ExpectHistogram(vtkTable* table, const ExpectedOctree& expected)
{
  ASSERT_EQ(table->GetNumberOfColumns(), 5);
  ASSERT_EQ(table->GetNumberOfRows(), expected.GetDeepestDepth() + 1);
  vtkDataArray* depth = GetColumn(table, 0, "Depth", VTK_INT);
  vtkDataArray* leaves = GetColumn(table, 1, "Leaves", VTK_ID_TYPE);
  vtkDataArray* emptyLeaves = GetColumn(table, 2, "EmptyLeaves", VTK_ID_TYPE);
  vtkDataArray* points = GetColumn(table, 3, "Points", VTK_ID_TYPE);
  vtkDataArray* grid = GetColumn(table, 4, "GridWeight", VTK_DOUBLE);
  ASSERT_TRUE(depth && leaves && emptyLeaves && points && grid);
  double totalGrid = 0.0;
  for (int row = 0; row <= expected.GetDeepestDepth(); ++row)
  {
    const auto sum = [&expected, row](auto value)
    {
      return static_cast<double>(expected.Sum([&value, row](const ExpectedOctree::Node& leaf)
        { return leaf.Depth == row ? value(leaf) : 0; }));
    };
    EXPECT_EQ(depth->GetTuple1(row), row);
    EXPECT_EQ(leaves->GetTuple1(row), sum([](const auto&) { return 1; })) << row;
    EXPECT_EQ(
      emptyLeaves->GetTuple1(row), sum([](const auto& leaf) { return leaf.Points.empty(); }))
      << row;
    EXPECT_EQ(points->GetTuple1(row),
      sum([](const auto& leaf) { return static_cast<std::int64_t>(leaf.Points.size()); }))
      << row;
    EXPECT_EQ(grid->GetTuple1(row),
      sum([&expected](const auto& leaf) { return ExpectedOctree::Grid(expected, leaf); }))
      << row;
    totalGrid += grid->GetTuple1(row);
  }
  EXPECT_DOUBLE_EQ(totalGrid, std::pow(8.0, expected.GetDeepestDepth())) << "tiling of the root";
}

inline void ExpectCosts(vtkTable* table, const ExpectedOctree& expected)
{
  ASSERT_EQ(table->GetNumberOfColumns(), 7);
  ASSERT_EQ(table->GetNumberOfRows(), expected.GetDeepestDepth() + 1);
  vtkDataArray* startDepth = GetColumn(table, 0, "StartDepth", VTK_INT);
  vtkDataArray* costLeaves = GetColumn(table, 1, "CostLeaves", VTK_DOUBLE);
  vtkDataArray* costPoints = GetColumn(table, 2, "CostPoints", VTK_DOUBLE);
  vtkDataArray* costGrid = GetColumn(table, 3, "CostGrid", VTK_DOUBLE);
  vtkDataArray* measuredLeaves = GetColumn(table, 4, "MeasuredLeaves", VTK_DOUBLE);
  vtkDataArray* measuredPoints = GetColumn(table, 5, "MeasuredPoints", VTK_DOUBLE);
  vtkDataArray* continuousLeaves = GetColumn(table, 6, "ContinuousLeaves", VTK_DOUBLE);
  ASSERT_TRUE(startDepth && costLeaves && costPoints && costGrid && measuredLeaves &&
    measuredPoints && continuousLeaves);
  for (int row = 0; row <= expected.GetDeepestDepth(); ++row)
  {
    const auto mean = [&expected, row](ExpectedOctree::Weight weight)
    { return static_cast<double>(expected.GetMeanCost(weight, row)); };
    EXPECT_EQ(startDepth->GetTuple1(row), row);
    EXPECT_DOUBLE_EQ(costLeaves->GetTuple1(row), mean(ExpectedOctree::Leaves)) << row;
    EXPECT_DOUBLE_EQ(costPoints->GetTuple1(row), mean(ExpectedOctree::Points)) << row;
    EXPECT_NEAR(costGrid->GetTuple1(row) / mean(ExpectedOctree::Grid), 1.0, 1e-12) << row;
    // Model and measurement agree to the last digit.
    EXPECT_EQ(measuredLeaves->GetTuple1(row), costLeaves->GetTuple1(row)) << row;
    EXPECT_EQ(measuredPoints->GetTuple1(row), costPoints->GetTuple1(row)) << row;
    const double share = static_cast<double>(expected.Sum(
                           [row](const auto& leaf) { return leaf.Depth == row ? 1 : 0; })) /
      static_cast<double>(expected.Sum([](const auto&) { return 1; }));
    EXPECT_NEAR(
      continuousLeaves->GetTuple1(row), costLeaves->GetTuple1(row) + 3.0 / 16.0 * share, 1e-12)
      << row;
  }
}

inline void ExpectFieldData(TestedFilter& filter, const ExpectedOctree& expected)
{
  const int model = filter->GetFrequencyModel();
  const int startDepth = GetExpectedStartDepth(filter.GetFilter(), expected, model);
  const auto hitCost = static_cast<double>(expected.GetMeanCost(GetWeight(model), startDepth));
  const auto rootCost = static_cast<double>(expected.GetMeanCost(GetWeight(model), 0));
  const std::int64_t leaves = expected.Sum([](const auto&) { return 1; });
  const std::int64_t points =
    expected.Sum([](const auto& leaf) { return static_cast<std::int64_t>(leaf.Points.size()); });
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), startDepth);
  EXPECT_NEAR(filter.GetFieldValue("MeanHitCost") / hitCost, 1.0, 1e-12);
  EXPECT_NEAR(filter.GetFieldValue("MeanRootCost") / rootCost, 1.0, 1e-12);
  EXPECT_NEAR(filter.GetFieldValue("CostRatio") / (rootCost / hitCost), 1.0, 1e-12);
  EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), points);
  EXPECT_EQ(filter.GetFieldValue("NumberOfNodes"), expected.GetNodes().size());
  EXPECT_EQ(filter.GetFieldValue("NumberOfLeaves"), leaves);
  EXPECT_EQ(filter.GetFieldValue("NumberOfEmptyLeaves"),
    expected.Sum([](const auto& leaf) { return leaf.Points.empty(); }));
  EXPECT_EQ(filter.GetFieldValue("DeepestDepth"), expected.GetDeepestDepth());
  EXPECT_EQ(filter.GetFieldValue("StartDepthLeaves"),
    GetExpectedStartDepth(filter.GetFilter(), expected, vtkHashedOctreeFilter::Leaves));
  EXPECT_EQ(filter.GetFieldValue("StartDepthPoints"),
    GetExpectedStartDepth(filter.GetFilter(), expected, vtkHashedOctreeFilter::Points));
  EXPECT_EQ(filter.GetFieldValue("StartDepthGrid"),
    GetExpectedStartDepth(filter.GetFilter(), expected, vtkHashedOctreeFilter::Grid));
  EXPECT_GT(filter.GetFieldValue("BuildSeconds"), 0.0);
  EXPECT_GE(filter.GetFieldValue("TreeBytes"), 0.0);
  EXPECT_EQ(filter.GetFieldValue("Dimension"), 3);
  EXPECT_EQ(filter.GetCells()->GetFieldData()->GetNumberOfArrays(), 17);
}

/** Everything that the filter says of its points, against the plain octree of the same points. */
inline void ExpectOctree(TestedFilter& filter, const ExpectedOctree& expected)
{
  ASSERT_NO_FATAL_FAILURE(ExpectCellArrays(filter, expected));
  if (filter->GetOutputType() == vtkHashedOctreeFilter::Outlines)
  {
    ExpectOutlines(filter, expected);
  }
  else
  {
    ExpectVoxels(filter, expected);
  }
  ExpectHistogram(filter.GetHistogram(), expected);
  ExpectCosts(filter.GetCosts(), expected);
  ExpectFieldData(filter, expected);
}

/** Updates the filter and expects the plain octree of the points, which are its input's. */
inline void UpdateAndExpectOctree(TestedFilter& filter, const std::vector<double>& coordinates)
{
  ASSERT_NO_FATAL_FAILURE(filter.Update());
  ExpectOctree(filter,
    ExpectedOctree(
      coordinates, static_cast<std::size_t>(filter->GetMaxPointsPerLeaf()), filter->GetMaxDepth()));
}

#endif
