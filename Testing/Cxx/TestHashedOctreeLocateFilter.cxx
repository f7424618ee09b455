// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "TestedFilter.h"
#include "TestedLocateFilter.h"

#include "vtkHashedOctreePointLocator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <sstream>

using Filter = vtkHashedOctreeLocateFilter;

namespace
{
std::vector<double> MakeDensities(std::size_t count, unsigned seed)
{
  return MakeTwoDensities<3, double>(count, seed, 1.0 / 128.0);
}

/** In the unit cube and around it. */
std::vector<double> MakeQueries(std::size_t count, unsigned seed)
{
  return MakeUniformPoints<3, double>(count, seed, -0.2, 1.2);
}

/** Makes the filter that shows the tree show the one that is searched. */
void CopyProperties(Filter* filter, vtkHashedOctreeFilter* shown)
{
  shown->SetMaxPointsPerLeaf(filter->GetMaxPointsPerLeaf());
  shown->SetMergePoints(filter->GetMergePoints());
  shown->SetMaxDepth(filter->GetMaxDepth());
  shown->SetFrequencyModel(filter->GetFrequencyModel());
  shown->SetStartDepthModel(filter->GetStartDepthModel());
  shown->SetFixedStartDepth(filter->GetFixedStartDepth());
  shown->SetIncludeEmptyLeaves(filter->GetIncludeEmptyLeaves());
}

/** The cell that holds a position, or, outside the root, what is nearest to it; -1 if none does.
 * Looks at all cells. The position must not lie on a face of one. */
vtkIdType FindCell(vtkDataSet* cells, const double* root, const double* x)
{
  double inside[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    inside[axis] = std::clamp(x[axis], root[2 * axis], root[2 * axis + 1]);
  }
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    double b[6];
    cells->GetCellBounds(cell, b);
    if (b[0] <= inside[0] && inside[0] <= b[1] && b[2] <= inside[1] && inside[1] <= b[3] &&
      b[4] <= inside[2] && inside[2] <= b[5])
    {
      return cell;
    }
  }
  return -1;
}

/** The leaf and the costs of each query against the cells of the filter that shows the tree. */
void ExpectCells(TestedLocateFilter& filter, vtkDataObject* points)
{
  TestedFilter shown;
  shown->SetInputData(points);
  CopyProperties(filter.GetFilter(), shown.GetFilter());
  shown->IncludeEmptyLeavesOn();
  shown.Update();
  vtkNew<vtkUnstructuredGrid> all;
  all->ShallowCopy(shown.GetCells());
  CopyProperties(filter.GetFilter(), shown.GetFilter());
  shown.Update();
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), shown.GetFieldValue("StartDepth"));
  const auto get = [](vtkDataSet* cells, const char* array, vtkIdType cell)
  { return cells->GetCellData()->GetArray(array)->GetVariantValue(cell).ToTypeInt64(); };
  for (vtkIdType query = 0; query < filter.GetLocated()->GetNumberOfPoints(); ++query)
  {
    const double* x = filter.GetLocated()->GetPoint(query);
    ASSERT_EQ(filter.Get("LeafId", query), FindCell(shown.GetCells(), all->GetBounds(), x));
    // Empty cells have a depth, a key and a cost, too.
    const vtkIdType cell = FindCell(all, all->GetBounds(), x);
    ASSERT_EQ(filter.Get("LeafDepth", query), get(all, "Depth", cell));
    ASSERT_EQ(filter.Get("LeafKey", query), get(all, "MortonKey", cell));
    ASSERT_EQ(filter.Get("HitCost", query), get(all, "HitCost", cell));
    ASSERT_EQ(filter.Get("RootCost", query), get(all, "RootCost", cell));
  }
}
}

TEST(TestHashedOctreeLocateFilter, HasTheDocumentedDefaults)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetDimension(), Filter::Auto);
  EXPECT_EQ(filter->GetPlane(), Filter::Widest);
  EXPECT_EQ(filter->GetMaxPointsPerLeaf(), 1);
  EXPECT_FALSE(filter->GetMergePoints());
  EXPECT_EQ(filter->GetMaxDepth(), 21);
  EXPECT_EQ(filter->GetFrequencyModel(), Filter::Leaves);
  EXPECT_EQ(filter->GetStartDepthModel(), Filter::Median);
  EXPECT_EQ(filter->GetFixedStartDepth(), 0);
  EXPECT_FALSE(filter->GetIncludeEmptyLeaves());
  EXPECT_EQ(filter->GetNumberOfInputPorts(), 2);
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 2);
}

TEST(TestHashedOctreeLocateFilter, ClampsValuesThatAreOutOfRange)
{
  vtkNew<Filter> filter;
  const auto clamped = [&filter](void (Filter::*set)(int), int (Filter::*get)(), int value)
  {
    (filter->*set)(value);
    return (filter->*get)();
  };
  EXPECT_EQ(clamped(&Filter::SetMaxPointsPerLeaf, &Filter::GetMaxPointsPerLeaf, 0), 1);
  EXPECT_EQ(clamped(&Filter::SetMaxDepth, &Filter::GetMaxDepth, -1), 0);
  EXPECT_EQ(clamped(&Filter::SetMaxDepth, &Filter::GetMaxDepth, 32), 31);
  EXPECT_EQ(clamped(&Filter::SetFrequencyModel, &Filter::GetFrequencyModel, 3), Filter::Grid);
  EXPECT_EQ(clamped(&Filter::SetFrequencyModel, &Filter::GetFrequencyModel, -1), Filter::Leaves);
  EXPECT_EQ(clamped(&Filter::SetStartDepthModel, &Filter::GetStartDepthModel, 4), Filter::Fixed);
  EXPECT_EQ(clamped(&Filter::SetStartDepthModel, &Filter::GetStartDepthModel, -1), Filter::Median);
  EXPECT_EQ(clamped(&Filter::SetFixedStartDepth, &Filter::GetFixedStartDepth, -1), 0);
  EXPECT_EQ(clamped(&Filter::SetFixedStartDepth, &Filter::GetFixedStartDepth, 32), 31);
}

TEST(TestHashedOctreeLocateFilter, PrintsEveryProperty)
{
  vtkNew<Filter> filter;
  filter->SetDimension(Filter::Two);
  filter->SetPlane(Filter::YZ);
  filter->SetMaxPointsPerLeaf(11);
  filter->MergePointsOn();
  filter->SetMaxDepth(12);
  filter->SetFrequencyModel(Filter::Grid);
  filter->SetStartDepthModel(Filter::Fixed);
  filter->SetFixedStartDepth(13);
  filter->IncludeEmptyLeavesOn();
  std::ostringstream text;
  filter->Print(text);
  for (const char* line :
    { "Dimension: 2", "Plane: 2", "MaxPointsPerLeaf: 11", "MergePoints: 1", "MaxDepth: 12",
      "FrequencyModel: 2", "StartDepthModel: 3", "FixedStartDepth: 13", "IncludeEmptyLeaves: 1" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line << " is not in\n" << text.str();
  }
}

TEST(TestHashedOctreeLocateFilter, EachQueryIsInTheCellThatItsLeafIdNames)
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const auto points = MakePolyData(MakeDensities(120, 301), type);
    TestedLocateFilter filter(points, MakePolyData(MakeQueries(100, 303), type));
    for (const bool emptyLeaves : { false, true })
    {
      filter->SetIncludeEmptyLeaves(emptyLeaves);
      filter->SetMaxPointsPerLeaf(1);
      filter->SetMaxDepth(21);
      filter->SetStartDepthModel(Filter::Median);
      filter.Update();
      ExpectCells(filter, points);
      int withoutLeaf = 0;
      for (vtkIdType query = 0; query < 100; ++query)
      {
        withoutLeaf += filter.Get("LeafId", query) == -1 ? 1 : 0;
      }
      EXPECT_EQ(withoutLeaf > 10, !emptyLeaves);
      filter->SetMaxPointsPerLeaf(3);
      filter->SetMaxDepth(4);
      filter->SetStartDepthModel(Filter::Fixed);
      filter->SetFixedStartDepth(6); // Deeper than the tree.
      filter.Update();
      ExpectCells(filter, points);
    }
  }
}

TEST(TestHashedOctreeLocateFilter, MergedPointsMakeTheSameLeaves)
{
  // Each point twice, so that without merging leaves end at the last depth.
  const std::vector<double> once = MakeDensities(120, 305);
  std::vector<double> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  const auto points = MakePolyData(twice);
  TestedLocateFilter filter(points, MakePolyData(MakeQueries(100, 307)));
  for (const bool merge : { false, true })
  {
    filter->SetMergePoints(merge);
    filter.Update();
    ExpectCells(filter, points);
  }
}

TEST(TestHashedOctreeLocateFilter, NumbersLeavesAsTheLocatorDoes)
{
  const auto points = MakePolyData(MakeDensities(400, 304));
  const auto queries = MakePolyData(MakeDensities(400, 306));
  TestedLocateFilter filter(points, queries);
  for (const int maxPointsPerLeaf : { 1, 20, 1000 }) // The last one: the root is the only leaf.
  {
    filter->SetMaxPointsPerLeaf(maxPointsPerLeaf);
    filter.Update();
    vtkNew<vtkHashedOctreePointLocator> locator;
    locator->SetMaxPointsPerLeaf(maxPointsPerLeaf);
    locator->SetDataSet(points);
    locator->BuildLocator();
    for (vtkIdType query = 0; query < 400; ++query)
    {
      ASSERT_EQ(filter.Get("LeafId", query), locator->GetLeafId(queries->GetPoint(query)));
      ASSERT_EQ(filter.Get("LeafDepth", query), locator->GetDepth(queries->GetPoint(query)));
    }
  }
}

TEST(TestHashedOctreeLocateFilter, EachCostIsThatOfItsModel)
{
  TestedLocateFilter filter(
    MakePolyData(MakeDensities(1000, 308)), MakePolyData(MakeQueries(500, 310)));
  for (const int frequency : { Filter::Leaves, Filter::Points, Filter::Grid })
  {
    for (const int model : { Filter::Median, Filter::Mean, Filter::Root, Filter::Fixed })
    {
      filter->SetFrequencyModel(frequency);
      filter->SetStartDepthModel(model);
      filter->SetFixedStartDepth(3);
      filter.Update();
      const char* const rowOfModel[] = { "Median", "Mean", "Root", "Fixed" };
      EXPECT_EQ(
        filter.GetFieldValue("StartDepth"), filter.GetTableValue(rowOfModel[model], "StartDepth"));
      EXPECT_EQ(filter.GetFieldValue("MeanHitCost"),
        filter.GetTableValue(rowOfModel[model], "MeasuredMean"));
      const auto expectCost = [&filter](const char* array, double startDepth, vtkIdType query)
      {
        ASSERT_EQ(static_cast<double>(filter.Get(array, query)),
          1 + std::abs(static_cast<double>(filter.Get("LeafDepth", query)) - startDepth));
      };
      for (vtkIdType query = 0; query < 500; ++query)
      {
        expectCost("HitCost", filter.GetFieldValue("StartDepth"), query);
        expectCost("RootCost", 0, query);
        expectCost("MedianCost", filter.GetTableValue("Median", "StartDepth"), query);
        expectCost("MeanCost", filter.GetTableValue("Mean", "StartDepth"), query);
        ASSERT_GE(filter.Get("LocalCost", query), 1);
        ASSERT_GE(filter.Get("DecisionTreeCost", query), 1);
        const double first = filter.GetTableValue("Decision tree", "StartDepth");
        ASSERT_EQ(filter.Get("DecisionTreeCost", query) == 1,
          static_cast<double>(filter.Get("LeafDepth", query)) == first);
      }
    }
  }
}

TEST(TestHashedOctreeLocateFilter, MeasuredMeansAreThoseOfTheArrays)
{
  TestedLocateFilter filter(
    MakePolyData(MakeDensities(3000, 312)), MakePolyData(MakeDensities(5000, 314)));
  filter->SetStartDepthModel(Filter::Fixed);
  filter->SetFixedStartDepth(9);
  filter.Update();
  const std::pair<const char*, const char*> rows[] = { { "Root", "RootCost" },
    { "Median", "MedianCost" }, { "Mean", "MeanCost" }, { "Fixed", "HitCost" },
    { "Local", "LocalCost" }, { "Decision tree", "DecisionTreeCost" } };
  for (const auto& [model, array] : rows)
  {
    EXPECT_EQ(filter.GetTableValue(model, "MeasuredMean"), filter.GetMean(array)) << model;
  }
  EXPECT_LT(filter.GetMean("LocalCost"), filter.GetMean("MedianCost")) << "two densities";
  EXPECT_LE(
    filter.GetTableValue("Entropy bound", "MeasuredMean"), filter.GetMean("DecisionTreeCost"));
}

TEST(TestHashedOctreeLocateFilter, TheBestStartDepthIsTheBestOfAll)
{
  TestedLocateFilter filter(MakePolyData(MakeDensities(3000, 316)), nullptr);
  const std::vector<double> samples[] = { MakeQueries(777, 318), MakeDensities(778, 319),
    MakeUniformPoints<3, double>(50, 321, 0.0, 1.0 / 128.0), { 0.5, 0.5, 0.5 } };
  for (const auto& queries : samples)
  {
    filter->SetInputData(1, MakePolyData(queries));
    filter.Update();
    std::array<double, 22> costs{};
    for (std::size_t start = 0; start < costs.size(); ++start)
    {
      for (vtkIdType query = 0; query < filter.GetLocated()->GetNumberOfPoints(); ++query)
      {
        const auto depth = static_cast<double>(filter.Get("LeafDepth", query));
        costs[start] += 1 + std::abs(depth - static_cast<double>(start));
      }
    }
    const auto best = std::min_element(costs.begin(), costs.end());
    const auto bestDepth = static_cast<double>(best - costs.begin());
    const auto count = static_cast<double>(filter.GetLocated()->GetNumberOfPoints());
    EXPECT_EQ(filter.GetFieldValue("BestStartDepth"), bestDepth);
    EXPECT_EQ(filter.GetTableValue("Best for these queries", "StartDepth"), bestDepth);
    EXPECT_EQ(filter.GetTableValue("Best for these queries", "MeasuredMean"), *best / count);
  }
}

TEST(TestHashedOctreeLocateFilter, QueriesThatAreThePointsCostWhatThePointsModelPredicts)
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const auto points = MakePolyData(MakeDensities(3000, 322), type);
    TestedLocateFilter filter(points, points);
    filter->SetFrequencyModel(Filter::Points);
    for (const int maxPointsPerLeaf : { 1, 10 })
    {
      filter->SetMaxPointsPerLeaf(maxPointsPerLeaf);
      filter.Update();
      ASSERT_EQ(filter.GetTable()->GetNumberOfRows(), 7);
      for (vtkIdType row = 0; row < 7; ++row)
      {
        EXPECT_EQ(filter.GetTable()->GetValueByName(row, "PredictedMean").ToDouble(),
          filter.GetTable()->GetValueByName(row, "MeasuredMean").ToDouble())
          << row;
      }
      EXPECT_EQ(filter.GetFieldValue("BestStartDepth"), filter.GetFieldValue("StartDepth"));
    }
  }
}

TEST(TestHashedOctreeLocateFilter, PredictsWhatTheOctreeFilterPredicts)
{
  const auto points = MakePolyData(MakeDensities(500, 324));
  TestedLocateFilter filter(points, MakePolyData(MakeQueries(10, 326)));
  TestedFilter shown;
  shown->SetInputData(points);
  const char* const columns[] = { "CostLeaves", "CostPoints", "CostGrid" };
  for (const int frequency : { Filter::Leaves, Filter::Points, Filter::Grid })
  {
    filter->SetFrequencyModel(frequency);
    filter.Update();
    shown->SetFrequencyModel(frequency);
    shown.Update();
    for (const char* model : { "Root", "Median", "Mean", "Best for these queries" })
    {
      const auto depth = static_cast<vtkIdType>(filter.GetTableValue(model, "StartDepth"));
      EXPECT_EQ(filter.GetTableValue(model, "PredictedMean"),
        shown.GetCosts()->GetValueByName(depth, columns[frequency]).ToDouble())
        << model;
    }
    EXPECT_EQ(filter.GetTableValue("Median", "PredictedMean"), shown.GetFieldValue("MeanHitCost"));
    const double byDecisions = filter.GetTableValue("Decision tree", "PredictedMean");
    EXPECT_LE(byDecisions, filter.GetTableValue("Median", "PredictedMean"));
    EXPECT_GE(byDecisions, filter.GetTableValue("Entropy bound", "PredictedMean"));
  }
}

TEST(TestHashedOctreeLocateFilter, TheTableHasARowForEachModel)
{
  TestedLocateFilter filter(
    MakePolyData(MakeDensities(100, 327)), MakePolyData(MakeQueries(10, 329)));
  for (const int model : { Filter::Median, Filter::Fixed })
  {
    filter->SetStartDepthModel(model);
    filter.Update();
    vtkTable* table = filter.GetTable();
    ASSERT_EQ(table->GetNumberOfColumns(), 4);
    const char* const columns[] = { "Model", "StartDepth", "PredictedMean", "MeasuredMean" };
    const int types[] = { VTK_STRING, VTK_INT, VTK_DOUBLE, VTK_DOUBLE };
    for (vtkIdType column = 0; column < 4; ++column)
    {
      EXPECT_STREQ(table->GetColumn(column)->GetName(), columns[column]);
      EXPECT_EQ(table->GetColumn(column)->GetDataType(), types[column]);
    }
    std::vector<std::string> models{ "Root", "Median", "Mean", "Local", "Decision tree",
      "Best for these queries", "Entropy bound" };
    if (model == Filter::Fixed)
    {
      models.insert(models.begin() + 3, "Fixed");
    }
    ASSERT_EQ(table->GetNumberOfRows(), static_cast<vtkIdType>(models.size()));
    for (std::size_t row = 0; row < models.size(); ++row)
    {
      EXPECT_EQ(table->GetValue(static_cast<vtkIdType>(row), 0).ToString(), models[row]);
    }
    EXPECT_EQ(filter.GetTableValue("Root", "StartDepth"), 0);
    EXPECT_EQ(filter.GetTableValue("Local", "StartDepth"), -1);
    EXPECT_EQ(filter.GetTableValue("Entropy bound", "StartDepth"), -1);
  }
}

TEST(TestHashedOctreeLocateFilter, RunsOnlyAfterAChange)
{
  TestedLocateFilter filter(
    MakePolyData(MakeDensities(100, 330)), MakePolyData(MakeQueries(10, 332)));
  filter.Update();
  filter->Update(1);
  filter->SetMaxPointsPerLeaf(0); // Clamped to what it is.
  filter.Update();
  int executions = 1;
  EXPECT_EQ(filter.Executions, executions);
  const auto expectRun = [&]
  {
    filter.Update();
    EXPECT_EQ(filter.Executions, ++executions);
  };
  filter->SetPlane(Filter::XZ);
  expectRun();
  filter->SetDimension(Filter::Three);
  expectRun();
  filter->SetMaxPointsPerLeaf(2);
  expectRun();
  filter->MergePointsOn();
  expectRun();
  filter->SetMaxDepth(3);
  expectRun();
  filter->SetFrequencyModel(Filter::Grid);
  expectRun();
  filter->SetStartDepthModel(Filter::Fixed);
  expectRun();
  filter->SetFixedStartDepth(2);
  expectRun();
  filter->IncludeEmptyLeavesOn();
  expectRun();
  filter->SetInputData(1, MakePolyData(MakeQueries(10, 333)));
  expectRun();
}
