// SPDX-License-Identifier: BSD-3-Clause
#include "AdjacentSearch.h"
#include "InRadiusSearch.h"
#include "PointSamples.h"
#include "SameOutputs.h"
#include "TestedFilter.h"
#include "TestedNeighborsFilter.h"

#include "vtkDataSetSurfaceFilter.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

// What is found is compared with a look at the bounds of every cell of vtkHashedOctreeFilter.

namespace
{
using Filter = vtkHashedOctreeNeighborsFilter;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/** The leaves of a sample, as vtkHashedOctreeFilter shows them. */
class ShownLeaves
{
public:
  ShownLeaves(const std::vector<double>& coordinates, bool empty, int maxPointsPerLeaf = 1)
    : Octree(coordinates)
  {
    this->Octree->SetIncludeEmptyLeaves(empty);
    this->Octree->SetMaxPointsPerLeaf(maxPointsPerLeaf);
    this->Octree.Update();
    this->Cells = this->Octree.GetCells();
    for (vtkIdType cell = 0; cell < this->Cells->GetNumberOfCells(); ++cell)
    {
      this->Bounds.emplace_back();
      this->Cells->GetCellBounds(cell, this->Bounds.back().data());
      this->CellOfKey[this->Get("MortonKey", cell)] = cell;
    }
  }

  const double* GetAllBounds() const { return this->Cells->GetBounds(); }
  vtkIdType GetNumberOfLeaves() const { return this->Cells->GetNumberOfCells(); }
  std::int64_t Get(const char* array, vtkIdType cell) const
  {
    return GetCellValue(this->Cells, array, cell);
  }
  const std::array<double, 6>& GetBounds(vtkIdType cell) const
  {
    return this->Bounds[static_cast<std::size_t>(cell)];
  }
  std::array<double, 3> GetCenter(vtkIdType cell) const
  {
    const auto& b = this->GetBounds(cell);
    return { (b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2 };
  }
  vtkIdType FindCell(std::int64_t key) const { return this->CellOfKey.at(key); }

  /** Cells that touch one. */
  std::set<vtkIdType> FindAdjacent(vtkIdType cell) const
  {
    const auto& a = this->GetBounds(cell);
    return this->FindOthers(cell,
      [&a](const std::array<double, 6>& b)
      {
        return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] &&
          b[4] <= a[5];
      });
  }
  /** Cells that meet a ball around the center of one. */
  std::set<vtkIdType> FindInRadius(vtkIdType cell, double radius) const
  {
    const auto center = this->GetCenter(cell);
    return this->FindOthers(cell,
      [&center, radius](const std::array<double, 6>& b)
      {
        double dist2 = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const double nearest = std::clamp(center[axis], b[2 * axis], b[2 * axis + 1]);
          dist2 += (center[axis] - nearest) * (center[axis] - nearest);
        }
        return dist2 <= radius * radius;
      });
  }

private:
  template <typename Predicate>
  std::set<vtkIdType> FindOthers(vtkIdType cell, const Predicate& isFound) const
  {
    std::set<vtkIdType> found;
    for (vtkIdType other = 0; other < this->GetNumberOfLeaves(); ++other)
    {
      if (other != cell && isFound(this->GetBounds(other)))
      {
        found.insert(other);
      }
    }
    return found;
  }

  TestedFilter Octree;
  vtkDataSet* Cells = nullptr;
  std::vector<std::array<double, 6>> Bounds;
  std::map<std::int64_t, vtkIdType> CellOfKey;
};

/** Each output cell is the leaf that it says it is, with the arrays that the leaf has. */
void ExpectCellsOf(TestedNeighborsFilter& filter, const ShownLeaves& leaves)
{
  std::set<std::array<double, 3>> corners;
  for (vtkIdType cell = 0; cell < filter.GetCells()->GetNumberOfCells(); ++cell)
  {
    const vtkIdType leaf = leaves.FindCell(filter.Get("MortonKey", cell));
    for (const char* name : { "Depth", "HitCost", "RootCost", "PointCount" })
    {
      ASSERT_EQ(filter.Get(name, cell), leaves.Get(name, leaf)) << name;
    }
    std::array<double, 6> bounds;
    filter.GetCells()->GetCellBounds(cell, bounds.data());
    ASSERT_EQ(bounds, leaves.GetBounds(leaf));
    ASSERT_EQ(filter.GetCells()->GetCellType(cell), VTK_VOXEL);
    for (int corner = 0; cell != 0 && corner < 8; ++corner)
    {
      corners.insert(
        { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)] });
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(filter.GetCells()->GetNumberOfPoints()), corners.size() + 8)
    << "neighbours share corners, but not with the query leaf";
  vtkNew<vtkIdList> cornersOfQuery;
  filter.GetCells()->GetCellPoints(0, cornersOfQuery);
  ASSERT_EQ(cornersOfQuery->GetNumberOfIds(), 8);
  for (vtkIdType corner = 0; corner < 8; ++corner)
  {
    EXPECT_EQ(cornersOfQuery->GetId(corner), static_cast<vtkIdType>(corners.size()) + corner);
  }
}

/** Role and Case of each cell, and their numbers in the field data. */
void ExpectRolesAndCases(TestedNeighborsFilter& filter)
{
  std::array<double, 4> counts{};
  for (vtkIdType cell = 0; cell < filter.GetCells()->GetNumberOfCells(); ++cell)
  {
    const std::int64_t deeper = filter.Get("Depth", cell) - filter.Get("Depth", 0);
    const int expected = cell == 0 ? Filter::QueryLeaf
      : deeper == 0                ? Filter::SameDepth
      : deeper > 0                 ? Filter::Descended
                                   : Filter::Above;
    ASSERT_EQ(filter.Get("Case", cell), expected);
    ASSERT_EQ(filter.Get("Role", cell), cell == 0 ? Filter::Query : Filter::Neighbor);
    ++counts[static_cast<std::size_t>(expected)];
  }
  EXPECT_EQ(filter.GetFieldValue("NumberOfSameDepthNeighbors"), counts[Filter::SameDepth]);
  EXPECT_EQ(filter.GetFieldValue("NumberOfDescendedNeighbors"), counts[Filter::Descended]);
  EXPECT_EQ(filter.GetFieldValue("NumberOfAboveNeighbors"), counts[Filter::Above]);
}

/** The query leaf comes first, then each expected leaf once. */
void ExpectNeighbors(TestedNeighborsFilter& filter, const ShownLeaves& leaves, vtkIdType query,
  const std::set<vtkIdType>& expected)
{
  std::set<vtkIdType> found;
  const vtkIdType cells = filter.GetCells()->GetNumberOfCells();
  ASSERT_EQ(static_cast<std::size_t>(cells), 1 + expected.size());
  EXPECT_EQ(filter.Get("MortonKey", 0), leaves.Get("MortonKey", query));
  for (vtkIdType cell = 1; cell < cells; ++cell)
  {
    found.insert(leaves.FindCell(filter.Get("MortonKey", cell)));
  }
  EXPECT_EQ(found, expected);
  ExpectCellsOf(filter, leaves);
  ExpectRolesAndCases(filter);
}

/** Calls function(name, coordinates, includeEmptyLeaves) for samples that differ. */
template <typename Function>
void ForSamples(const Function& function)
{
  const PointSample<3, double> samples[] = { { "uniform", MakeUniformPoints<3, double>(60, 80) },
    { "sphere", MakeSpherePoints<3, double>(80, 81) },
    { "clusters", MakeClusteredPoints<3, double>(40, 82) }, { "one point", { 1, 2, 3 } },
    { "two points", { 1, 2, 3, 2, 2, 3 } } };
  for (const auto& sample : samples)
  {
    for (const bool empty : { false, true })
    {
      SCOPED_TRACE(sample.Name + (empty ? ", with empty leaves" : ""));
      function(sample.Coordinates, empty);
    }
  }
}

/** So many leaves of all, in steps, are searched around. */
vtkIdType GetStep(const ShownLeaves& leaves)
{
  return leaves.GetNumberOfLeaves() / 40 + 1;
}
}

TEST(TestHashedOctreeNeighborsFilter, HasTheDocumentedDefaults)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetSearchMode(), Filter::Adjacent);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(filter->GetCenter()[axis], 0.0);
  }
  EXPECT_FALSE(filter->GetUseLeafKey());
  EXPECT_EQ(filter->GetLeafKey(), 1);
  EXPECT_EQ(filter->GetRadius(), 1.0);
  EXPECT_EQ(filter->GetStartDepthModel(), Filter::Median);
  EXPECT_EQ(filter->GetFixedStartDepth(), 0);
  EXPECT_EQ(filter->GetMaxPointsPerLeaf(), 1);
  EXPECT_TRUE(filter->GetIncludeEmptyLeaves());
  EXPECT_EQ(filter->GetNumberOfInputPorts(), 1);
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 1);
}

TEST(TestHashedOctreeNeighborsFilter, PrintsEveryProperty)
{
  vtkNew<Filter> filter;
  filter->SetDimension(Filter::Two);
  filter->SetPlane(Filter::YZ);
  filter->SetMaxPointsPerLeaf(11);
  filter->MergePointsOn();
  filter->SetMaxDepth(12);
  filter->SetFrequencyModel(Filter::Grid);
  filter->SetStartDepthModel(Filter::Fixed);
  filter->SetFixedStartDepth(14);
  filter->SetSearchMode(Filter::InRadius);
  filter->SetCenter(1.5, 2.5, 3.5);
  filter->UseLeafKeyOn();
  filter->SetLeafKey(13);
  filter->SetRadius(0.25);
  std::ostringstream text;
  filter->Print(text);
  for (const char* line :
    { "Dimension: 2", "Plane: 2", "MaxPointsPerLeaf: 11", "MergePoints: 1", "MaxDepth: 12",
      "FrequencyModel: 2", "StartDepthModel: 3", "FixedStartDepth: 14", "IncludeEmptyLeaves: 1",
      "SearchMode: 1", "Center: 1.5, 2.5, 3.5", "UseLeafKey: 1", "LeafKey: 13", "Radius: 0.25" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line << " is not in\n" << text.str();
  }
}

TEST(TestHashedOctreeNeighborsFilter, AdjacentAreTheLeavesThatTouch)
{
  ForSamples(
    [](const std::vector<double>& coordinates, bool empty)
    {
      const ShownLeaves leaves(coordinates, empty);
      TestedNeighborsFilter filter(coordinates);
      filter->SetIncludeEmptyLeaves(empty);
      for (vtkIdType query = 0; query < leaves.GetNumberOfLeaves(); query += GetStep(leaves))
      {
        filter->SetCenter(leaves.GetCenter(query).data());
        filter.Update();
        ExpectNeighbors(filter, leaves, query, leaves.FindAdjacent(query));
      }
    });
}

TEST(TestHashedOctreeNeighborsFilter, InRadiusAreTheLeavesThatMeetTheBallAroundTheQueryLeaf)
{
  ForSamples(
    [](const std::vector<double>& coordinates, bool empty)
    {
      const ShownLeaves leaves(coordinates, empty);
      TestedNeighborsFilter filter(coordinates);
      filter->SetIncludeEmptyLeaves(empty);
      filter->SetSearchMode(Filter::InRadius);
      for (vtkIdType query = 0; query < leaves.GetNumberOfLeaves(); query += 2 * GetStep(leaves))
      {
        const auto& bounds = leaves.GetBounds(query);
        const double side = bounds[1] - bounds[0];
        // Not the center of the leaf, which the ball is around whatever the position in it.
        filter->SetCenter(bounds[0] + 0.2 * side, bounds[2] + 0.7 * side, bounds[4] + 0.4 * side);
        for (const double radius : { 0.0, 0.43 * side, 0.57 * side, 1.7 * side, 0.21, Infinity })
        {
          filter->SetRadius(radius);
          filter.Update();
          ExpectNeighbors(filter, leaves, query, leaves.FindInRadius(query, radius));
        }
      }
    });
}

TEST(TestHashedOctreeNeighborsFilter, SurfacesHaveAllFacesOfTheQueryLeafAndDrawThemLast)
{
  TestedNeighborsFilter filter(MakeUniformPoints<3, double>(2000, 85));
  filter->SetCenter(0.5, 0.5, 0.5);
  filter.Update();
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(filter.GetCells());
  surface->Update();
  vtkDataArray* roles = surface->GetOutput()->GetCellData()->GetArray("Role");
  const vtkIdType faces = roles->GetNumberOfTuples();
  ASSERT_GT(faces, 6);
  for (vtkIdType face = 0; face < faces; ++face)
  {
    ASSERT_EQ(roles->GetComponent(face, 0), face < faces - 6 ? Filter::Neighbor : Filter::Query);
  }
}

TEST(TestHashedOctreeNeighborsFilter, KeyAndPositionAgree)
{
  ForSamples(
    [](const std::vector<double>& coordinates, bool empty)
    {
      const ShownLeaves leaves(coordinates, empty);
      TestedNeighborsFilter byPosition(coordinates);
      TestedNeighborsFilter byKey(coordinates);
      byPosition->SetIncludeEmptyLeaves(empty);
      byKey->SetIncludeEmptyLeaves(empty);
      byKey->UseLeafKeyOn();
      byKey->SetCenter(NAN, 0.0, 0.0); // Not used.
      for (const int mode : { Filter::Adjacent, Filter::InRadius })
      {
        byPosition->SetSearchMode(mode);
        byKey->SetSearchMode(mode);
        for (vtkIdType query = 0; query < leaves.GetNumberOfLeaves(); query += GetStep(leaves))
        {
          byPosition->SetCenter(leaves.GetCenter(query).data());
          byKey->SetLeafKey(leaves.Get("MortonKey", query));
          byPosition.Update();
          byKey.Update();
          ExpectSame(byKey.GetCells(), byPosition.GetCells());
        }
      }
    });
}

TEST(TestHashedOctreeNeighborsFilter, KeysOfTheLastDepthAreNegativeNumbers)
{
  // Equal points go down to the last depth, in the octants around the middle of the root.
  const std::vector<double> coordinates{ 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0, 0, 0, 1, 1, 1 };
  TestedNeighborsFilter filter(coordinates);
  filter->SetCenter(0.25, 0.25, 0.25);
  filter.Update();
  EXPECT_EQ(filter.Get("Depth", 0), 21);
  EXPECT_EQ(filter.Get("PointCount", 0), 2);
  const std::int64_t key = filter.Get("MortonKey", 0);
  EXPECT_LT(key, 0);
  const vtkIdType cells = filter.GetCells()->GetNumberOfCells();
  EXPECT_GT(cells, 8);
  filter->UseLeafKeyOn();
  filter->SetLeafKey(key);
  filter.Update();
  EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), cells);
}

TEST(TestHashedOctreeNeighborsFilter, PositionsOutsideTheRootStandForTheNearestCell)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(60, 83);
  const ShownLeaves leaves(coordinates, true);
  TestedNeighborsFilter filter(coordinates);
  const auto inside = [&](double x, double y, double z)
  {
    filter->SetCenter(x, y, z);
    filter.Update();
    return leaves.GetBounds(leaves.FindCell(filter.Get("MortonKey", 0)));
  };
  const double* b = leaves.GetAllBounds();
  EXPECT_EQ(inside(-9.0, -1e300, -1.0), inside(b[0], b[2], b[4]));
  EXPECT_EQ(inside(7.0, 0.5, 1e300), inside(b[1], 0.5, b[5]));
  EXPECT_EQ(inside(0.3, 8.0, 0.4), inside(0.3, b[3], 0.4));
}

namespace
{
/** Nodes that the core's own search examines around the query leaf of the filter. */
double CountExaminedNodes(TestedNeighborsFilter& filter, const hashedoctree::Octree<3>& tree)
{
  const hashedoctree::MortonKey<3> query(static_cast<std::uint64_t>(filter.Get("MortonKey", 0)));
  const auto startDepth = static_cast<int>(filter.GetFieldValue("StartDepth"));
  constexpr auto reading = hashedoctree::EmptyOctants::Missing;
  std::vector<hashedoctree::Neighbor<3>> found;
  hashedoctree::NodeCount count;
  if (filter->GetSearchMode() == Filter::Adjacent)
  {
    FindAdjacentLeaves(tree, query, startDepth, found, count, reading);
  }
  else
  {
    FindLeavesInRadius(tree, query, filter->GetRadius(), startDepth, found, count, reading);
  }
  return static_cast<double>(count.Nodes);
}

/** Side of the query leaf. */
double GetQuerySide(TestedNeighborsFilter& filter)
{
  double bounds[6];
  filter.GetCells()->GetCellBounds(0, bounds);
  return bounds[1] - bounds[0];
}

std::vector<std::int64_t> GetKeys(TestedNeighborsFilter& filter)
{
  std::vector<std::int64_t> keys;
  for (vtkIdType cell = 0; cell < filter.GetCells()->GetNumberOfCells(); ++cell)
  {
    keys.push_back(filter.Get("MortonKey", cell));
  }
  return keys;
}
}

TEST(TestHashedOctreeNeighborsFilter, StartDepthsChangeTheCostNotTheNeighbors)
{
  using namespace hashedoctree;
  const std::vector<double> coordinates = MakeClusteredPoints<3, double>(300, 84);
  const PointSpan<3, double> span{ coordinates.data(), coordinates.size() / 3 };
  const Octree<3> tree(
    span, PointSelection<3>(span, std::nullopt, Execution()), Octree<3>::Options(), Execution());
  TestedFilter octree(coordinates);
  TestedNeighborsFilter filter(coordinates);
  octree->SetFixedStartDepth(11);
  filter->SetFixedStartDepth(11);
  std::map<std::pair<int, int>, std::set<std::vector<std::int64_t>>> keys;
  std::map<std::pair<int, int>, std::set<double>> costs;
  for (int model = 0; model < 4; ++model)
  {
    for (int frequency = 0; frequency < 3; ++frequency)
    {
      filter->SetStartDepthModel(model);
      octree->SetStartDepthModel(model);
      filter->SetFrequencyModel(frequency);
      octree->SetFrequencyModel(frequency);
      octree.Update();
      for (int run = 0; run < 40; ++run)
      {
        const std::pair<int, int> query{ run % 2, run / 2 };
        filter->SetSearchMode(query.first);
        filter->SetCenter(coordinates.data() + 3 * query.second);
        if (query.first == Filter::InRadius)
        {
          filter->SetRadius(0.7 * GetQuerySide(filter)); // The leaf is that of the run before.
        }
        filter.Update();
        ASSERT_EQ(filter.GetFieldValue("StartDepth"), octree.GetFieldValue("StartDepth"));
        ASSERT_EQ(filter.GetFieldValue("ExaminedNodes"), CountExaminedNodes(filter, tree));
        keys[query].insert(GetKeys(filter));
        costs[query].insert(filter.GetFieldValue("ExaminedNodes"));
      }
    }
  }
  int changes[2] = { 0, 0 };
  for (const auto& [query, found] : keys)
  {
    EXPECT_EQ(found.size(), 1U);
    changes[query.first] += costs[query].size() > 1 ? 1 : 0;
  }
  EXPECT_GT(changes[Filter::Adjacent], 0);
  EXPECT_GT(changes[Filter::InRadius], 0);
}

TEST(TestHashedOctreeNeighborsFilter, TreeOptionsAreThoseOfTheOctreeFilter)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(200, 85);
  const ShownLeaves leaves(coordinates, true, 7);
  TestedNeighborsFilter filter(coordinates);
  filter->SetMaxPointsPerLeaf(7);
  filter->SetCenter(leaves.GetCenter(3).data());
  filter.Update();
  ExpectNeighbors(filter, leaves, 3, leaves.FindAdjacent(3));

  std::vector<double> twice = coordinates;
  twice.insert(twice.end(), coordinates.begin(), coordinates.end());
  TestedNeighborsFilter merging(twice);
  merging->SetMaxPointsPerLeaf(7);
  merging->MergePointsOn();
  merging->SetCenter(leaves.GetCenter(3).data());
  merging.Update();
  ExpectNeighbors(merging, leaves, 3, leaves.FindAdjacent(3));

  filter->SetMaxDepth(1);
  filter.Update();
  EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 8);
  filter->SetMaxDepth(0);
  filter.Update();
  EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 1) << "the root has no neighbours";
  EXPECT_EQ(filter.Get("MortonKey", 0), 1);
}

TEST(TestHashedOctreeNeighborsFilter, OutputHasTheArraysThatItPromises)
{
  TestedNeighborsFilter filter({ 0, 0, 0, 1, 1, 1, 1, 1, 0.2 });
  filter.Update();
  const std::pair<const char*, int> expected[] = { { "Depth", VTK_INT }, { "HitCost", VTK_INT },
    { "RootCost", VTK_INT }, { "PointCount", VTK_TYPE_INT64 }, { "MortonKey", VTK_TYPE_UINT64 },
    { "Role", VTK_INT }, { "Case", VTK_INT } };
  vtkCellData* cellData = filter.GetCells()->GetCellData();
  ASSERT_EQ(cellData->GetNumberOfArrays(), 7);
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_STREQ(cellData->GetArrayName(i), expected[i].first);
    EXPECT_EQ(cellData->GetArray(i)->GetDataType(), expected[i].second);
  }
  ASSERT_NE(cellData->GetScalars(), nullptr);
  EXPECT_STREQ(cellData->GetScalars()->GetName(), "Case");
  EXPECT_EQ(filter.GetCells()->GetFieldData()->GetNumberOfArrays(), 6);
  EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 0);
}
