// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_ExpectCells_h
#define Testing_Cxx_ExpectCells_h

#include "ExpectedStartDepth.h"
#include "TestedFilter.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"

#include <limits>
#include <map>
#include <set>
#include <vector>

/** The nodes that port 0 must show, in its order. */
inline std::vector<OracleOctree::Node> GetShownNodes(
  vtkHashedOctreeFilter* filter, const OracleOctree& expected)
{
  std::vector<OracleOctree::Node> shown;
  for (const OracleOctree::Node& node : expected.GetNodes())
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
inline void ExpectCellArrays(TestedFilter& filter, const OracleOctree& expected)
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
  vtkDataArray* pointCount = get("PointCount", VTK_TYPE_INT64);
  vtkDataArray* key = get("MortonKey", VTK_TYPE_UINT64);
  ASSERT_TRUE(depth && hitCost && rootCost && pointCount && key);

  const int startDepth =
    GetExpectedStartDepth(filter.GetFilter(), expected, filter->GetFrequencyModel());
  const auto shown = GetShownNodes(filter.GetFilter(), expected);
  ASSERT_EQ(filter.GetCells()->GetNumberOfCells(), static_cast<vtkIdType>(shown.size()));
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const OracleOctree::Node& node = shown[i];
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
inline OracleOctree::Place GetCorner(const OracleOctree::Node& node, unsigned corner)
{
  OracleOctree::Place place = node.Lower;
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
  CornerCensus(vtkDataSet* cells, const OracleOctree& expected)
    : Cells(cells)
    , Expected(expected)
  {
  }

  void Add(vtkIdType point, const OracleOctree::Place& corner)
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
  const OracleOctree& Expected;
  std::map<OracleOctree::Place, vtkIdType> Points;
};

/** Expects a cell of one kind for each node shown, and calls expectCell(node, points, corners). */
template <typename Function>
void ExpectCells(TestedFilter& filter, const OracleOctree& expected, int cellType,
  vtkIdType pointsPerCell, const Function& expectCell)
{
  const auto shown = GetShownNodes(filter.GetFilter(), expected);
  ASSERT_EQ(filter.GetCells()->GetNumberOfCells(), static_cast<vtkIdType>(shown.size()));
  CornerCensus corners(filter.GetCells(), expected);
  vtkNew<vtkIdList> points;
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    filter.GetCells()->GetCellPoints(cell, points);
    ASSERT_EQ(filter.GetCells()->GetCellType(cell), cellType);
    ASSERT_EQ(points->GetNumberOfIds(), pointsPerCell);
    ASSERT_NO_FATAL_FAILURE(expectCell(shown[i], points.Get(), corners)) << "cell " << i;
  }
  corners.ExpectComplete();
}

inline void ExpectVoxels(TestedFilter& filter, const OracleOctree& expected)
{
  ASSERT_EQ(filter.GetCells()->GetDataObjectType(), VTK_UNSTRUCTURED_GRID);
  ExpectCells(filter, expected, VTK_VOXEL, 8,
    [](const OracleOctree::Node& node, vtkIdList* points, CornerCensus& corners)
    {
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        ASSERT_NO_FATAL_FAILURE(corners.Add(points->GetId(corner), GetCorner(node, corner)));
      }
    });
}

/** Which corner of a node a place is nearest to. */
inline unsigned GetNearestCorner(
  const OracleOctree& expected, const OracleOctree::Node& node, const double* x)
{
  unsigned corner = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const double middle = (expected.GetPosition(GetCorner(node, 0), axis) +
                            expected.GetPosition(GetCorner(node, 7), axis)) /
      2;
    corner |= x[axis] > middle ? 1U << axis : 0U;
  }
  return corner;
}

/** Each outline must walk along the twelve edges of its node, and nowhere else. */
inline void ExpectOutlines(TestedFilter& filter, const OracleOctree& expected)
{
  ASSERT_EQ(filter.GetCells()->GetDataObjectType(), VTK_POLY_DATA);
  ExpectCells(filter, expected, VTK_POLY_LINE, 16,
    [&](const OracleOctree::Node& node, vtkIdList* points, CornerCensus& corners)
    {
      std::set<std::pair<unsigned, unsigned>> edges;
      unsigned last = 0;
      for (vtkIdType j = 0; j < 16; ++j)
      {
        const double* x = filter.GetCells()->GetPoint(points->GetId(j));
        const unsigned corner = GetNearestCorner(expected, node, x);
        ASSERT_NO_FATAL_FAILURE(corners.Add(points->GetId(j), GetCorner(node, corner)));
        if (j > 0)
        {
          const unsigned step = last ^ corner; // An empty one would stay in place.
          ASSERT_TRUE(step == 1 || step == 2 || step == 4) << "not along an edge";
          edges.emplace(std::min(last, corner), std::max(last, corner));
        }
        last = corner;
      }
      ASSERT_EQ(edges.size(), 12U);
    });
}

#endif
