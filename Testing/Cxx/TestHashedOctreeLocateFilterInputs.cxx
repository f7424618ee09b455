// SPDX-License-Identifier: BSD-3-Clause
#include "FieldValue.h"
#include "PointSamples.h"
#include "SameOutputs.h"
#include "TestedLocateFilter.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** The executive does not run the filter, and says one error with `words` in it. */
void ExpectToBeRefused(TestedLocateFilter& filter, const std::string& words)
{
  EXPECT_FALSE(filter->GetExecutive()->Update());
  ASSERT_EQ(filter.PipelineErrors.size(), 1U);
  EXPECT_NE(filter.PipelineErrors[0].find(words), std::string::npos) << filter.PipelineErrors[0];
  filter.PipelineErrors.clear();
}

/** After an error the same filter must do its work as if nothing had happened. */
void ExpectToWorkAgain(TestedLocateFilter& filter)
{
  filter->SetInputData(0, MakeUniform(50, 340));
  filter->SetInputData(1, MakeUniform(20, 341));
  filter.Update();
  EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), 20);
  EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 7);
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}

/** The same values of all arrays that the filter makes, for queries at the same places. */
void ExpectSameLocations(TestedLocateFilter& filter, TestedLocateFilter& other)
{
  for (const char* name : { "LeafId", "LeafDepth", "LeafKey", "HitCost", "RootCost", "MedianCost",
         "MeanCost", "LocalCost", "DecisionTreeCost" })
  {
    ExpectSameArray(filter.GetLocated()->GetPointData()->GetArray(name),
      other.GetLocated()->GetPointData()->GetArray(name), name);
  }
}
}

TEST(TestHashedOctreeLocateFilterInputs, NoPointsMakeNothing)
{
  for (const auto& empty : { MakePolyData({}), vtkSmartPointer<vtkPolyData>::New() })
  {
    TestedLocateFilter filter(empty, MakeUniform(10, 342));
    filter.Update();
    filter.ExpectEmptyOutputs();
    EXPECT_EQ(filter.Warnings, std::vector<std::string>());
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeLocateFilterInputs, NoQueriesAreNotCompared)
{
  for (const auto& empty : { MakePolyData({}), vtkSmartPointer<vtkPolyData>::New() })
  {
    TestedLocateFilter filter(MakeUniform(10, 343), empty);
    for (int run = 0; run < 2; ++run) // Nothing of the run before is left.
    {
      filter->SetInputData(1, empty);
      filter.Update();
      EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), 0);
      EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 0);
      EXPECT_EQ(filter.GetTable()->GetNumberOfColumns(), 4);
      EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), 0);
      EXPECT_EQ(filter.Warnings, std::vector<std::string>());
      ExpectToWorkAgain(filter);
    }
  }
}

TEST(TestHashedOctreeLocateFilterInputs, NoFiniteQueryIsLocated)
{
  TestedLocateFilter filter(
    MakeUniform(10, 344), MakePolyData({ NotANumber, 0, 0, 0, Infinity, 0, 0, 0, -Infinity }));
  filter.Update();
  filter.ExpectWarning("3 of 3 query points");
  ASSERT_EQ(filter.GetLocated()->GetNumberOfPoints(), 3);
  for (vtkIdType query = 0; query < 3; ++query)
  {
    EXPECT_EQ(filter.Get("LeafId", query), -1);
  }
  EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 0);
  ExpectToWorkAgain(filter);
}

TEST(TestHashedOctreeLocateFilterInputs, QueriesOfAnotherPieceDoNotCount)
{
  const auto points = MakeUniform(500, 351);
  std::vector<double> all = MakeUniformPoints<3, double>(90, 352, -0.5, 1.5);
  TestedLocateFilter ofAll(points, MakePolyData(all));
  ofAll.Update();
  const auto queries = MakePolyData(all);
  vtkUnsignedCharArray* ghosts = queries->AllocatePointGhostArray();
  std::fill_n(ghosts->GetPointer(60), 30, vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  TestedLocateFilter filter(points, queries);
  filter.Update();
  ExpectSameLocations(filter, ofAll);
  all.resize(3 * 60);
  TestedLocateFilter ofOwn(points, MakePolyData(all));
  ofOwn.Update();
  EXPECT_NE(ofOwn.GetFieldValue("MeanHitCost"), ofAll.GetFieldValue("MeanHitCost"));
  EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), ofOwn.GetFieldValue("MeanHitCost"));
  for (const char* model : { "Root", "Local", "Best for these queries", "Entropy bound" })
  {
    EXPECT_EQ(
      filter.GetTableValue(model, "MeasuredMean"), ofOwn.GetTableValue(model, "MeasuredMean"))
      << model;
  }

  std::fill_n(ghosts->GetPointer(0), 90, vtkDataSetAttributes::DUPLICATEPOINT);
  filter->SetInputData(1, queries);
  filter->Modified();
  filter.Update();
  EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 0);
  EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), 0);
  ghosts->SetNumberOfTuples(89); // Not one for each query: nothing is marked.
  filter->Modified();
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), ofAll.GetFieldValue("MeanHitCost"));
}

TEST(TestHashedOctreeLocateFilterInputs, WarnsOnlyOfQueriesThatCount)
{
  const auto queries =
    MakePolyData({ NotANumber, 0, 0, 0.5, 0.5, 0.5, 0.1, 0.1, 0.1, 0, Infinity, 0 });
  vtkUnsignedCharArray* ghosts = queries->AllocatePointGhostArray();
  ghosts->SetValue(3, vtkDataSetAttributes::DUPLICATEPOINT);
  TestedLocateFilter filter(MakeUniform(10, 344), queries);
  filter.Update();
  filter.ExpectWarning("1 of 3 query points");
  ghosts->SetValue(0, vtkDataSetAttributes::DUPLICATEPOINT);
  filter->Modified();
  filter.UpdateSilently();
}

TEST(TestHashedOctreeLocateFilterInputs, BothInputsAreRequired)
{
  for (const int missing : { 0, 1 })
  {
    TestedLocateFilter filter;
    filter->SetInputData(1 - missing, MakeUniform(10, 345));
    ExpectToBeRefused(filter, "Input port " + std::to_string(missing));
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeLocateFilterInputs, TheExecutiveRefusesInputsOfAnotherType)
{
  const vtkNew<vtkTable> table;
  const vtkNew<vtkImageData> image;
  for (const auto& [port, input, required] :
    { std::tuple<int, vtkDataObject*, const char*>(0, table, "vtkPointSet"),
      { 0, image, "vtkPointSet" }, { 1, table, "vtkDataSet" } })
  {
    TestedLocateFilter filter;
    filter->SetInputData(port, input);
    filter->SetInputData(1 - port, MakeUniform(10, 345));
    ExpectToBeRefused(filter, std::string("a ") + required + " is required");
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeLocateFilterInputs, AnEmptyPieceIsNoError)
{
  for (const auto& nothing : { MakePolyData({}), vtkSmartPointer<vtkPolyData>::New() })
  {
    for (const auto& [empty, port] : { std::pair(0, 0), { 0, 1 }, { 1, 0 }, { 1, 1 } })
    {
      TestedLocateFilter filter;
      filter->SetInputData(empty, nothing);
      filter->SetInputData(1 - empty, MakeUniform(10, 346));
      filter.UpdatePiece(port, 1, 4);
      EXPECT_EQ(filter.Errors, std::vector<std::string>());
      EXPECT_EQ(filter.PipelineErrors, std::vector<std::string>());
      EXPECT_EQ(filter.Warnings, std::vector<std::string>());
      EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), 0);
      if (empty == 1)
      {
        EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), 0);
        EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 0);
        EXPECT_EQ(filter.GetTable()->GetNumberOfColumns(), 4);
      }
    }
  }
}

TEST(TestHashedOctreeLocateFilterInputs, QueriesThatAreNotFiniteHaveNoLeaf)
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const auto points = MakeUniform(500, 347);
    const std::vector<double> good = MakeUniformPoints<3, double>(30, 348);
    std::vector<double> all{ NotANumber, 0.5, 0.5, 0.5, Infinity, 0.5 };
    all.insert(all.end(), good.begin(), good.end());
    all.insert(all.end(), { 0.5, 0.5, -Infinity });
    TestedLocateFilter filter(points, MakePolyData(all, type));
    filter->IncludeEmptyLeavesOn();
    filter.Update();
    filter.ExpectWarning("3 of 33 query points");
    TestedLocateFilter ofGood(points, MakePolyData(good, type));
    ofGood->IncludeEmptyLeavesOn();
    ofGood.Update();
    for (const char* array : { "LeafId", "LeafDepth", "LeafKey", "HitCost", "RootCost",
           "MedianCost", "MeanCost", "LocalCost", "DecisionTreeCost" })
    {
      const bool isOfLeaf = array == std::string("LeafId") || array == std::string("LeafDepth");
      for (const vtkIdType query : { 0, 1, 32 })
      {
        EXPECT_EQ(filter.Get(array, query), isOfLeaf ? -1 : 0) << array;
      }
      for (vtkIdType query = 0; query < 30; ++query)
      {
        EXPECT_EQ(filter.Get(array, query + 2), ofGood.Get(array, query)) << array;
      }
    }
    ExpectSameArrays(filter.GetLocated()->GetFieldData(), ofGood.GetLocated()->GetFieldData());
    for (const char* model : { "Root", "Median", "Local", "Best for these queries" })
    {
      EXPECT_EQ(
        filter.GetTableValue(model, "MeasuredMean"), ofGood.GetTableValue(model, "MeasuredMean"));
    }
  }
}

TEST(TestHashedOctreeLocateFilterInputs, PointsThatAreNotFiniteAreLeftOut)
{
  TestedLocateFilter filter(
    MakePolyData({ NotANumber, 0, 0, 0, 0, 0, 1, 1, 1 }), MakeUniform(10, 349));
  filter.Update();
  filter.ExpectWarning("1 of 3 points");
  EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 1);
}

TEST(TestHashedOctreeLocateFilterInputs, QueriesFarAwayAreInTheNearestLeaf)
{
  const double most = std::numeric_limits<double>::max();
  // A leaf in each octant, in key order: x is the high bit.
  std::vector<double> corners;
  for (unsigned octant = 0; octant < 8; ++octant)
  {
    corners.insert(
      corners.end(), { octant & 4U ? 1.0 : 0.0, octant & 2U ? 1.0 : 0.0, octant & 1U ? 1.0 : 0.0 });
  }
  TestedLocateFilter filter(MakePolyData(corners),
    MakePolyData({ -9, -9, -9, 9, -9, 0.2, most, most, most, 0.2, 0.8, -most }));
  filter.Update();
  const std::vector<std::int64_t> expected{ 0, 4, 7, 2 };
  for (vtkIdType query = 0; query < 4; ++query)
  {
    EXPECT_EQ(filter.Get("LeafId", query), expected[static_cast<std::size_t>(query)]);
    EXPECT_EQ(filter.Get("LeafKey", query), 8 + expected[static_cast<std::size_t>(query)]);
    EXPECT_EQ(filter.Get("LeafDepth", query), 1);
  }
}

TEST(TestHashedOctreeLocateFilterInputs, OnePointIsFoundAtTheRoot)
{
  TestedLocateFilter filter(MakePolyData({ 1, 2, 3 }), MakePolyData({ 4, 5, 6, 1, 2, 3 }));
  filter.Update();
  for (vtkIdType query = 0; query < 2; ++query)
  {
    EXPECT_EQ(filter.Get("LeafId", query), 0);
    EXPECT_EQ(filter.Get("LeafDepth", query), 0);
    EXPECT_EQ(filter.Get("LeafKey", query), 1);
    EXPECT_EQ(filter.Get("LocalCost", query), 1);
    EXPECT_EQ(filter.Get("DecisionTreeCost", query), 1);
  }
  EXPECT_EQ(filter.GetTableValue("Local", "PredictedMean"), 1);
  EXPECT_EQ(filter.GetTableValue("Entropy bound", "MeasuredMean"), 0);
}

TEST(TestHashedOctreeLocateFilterInputs, QueriesAreGivenBackWithAllThatTheyHave)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkPolyData> queries;
  queries->DeepCopy(sphere->GetOutput());
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  heat->SetNumberOfValues(queries->GetNumberOfPoints());
  heat->FillValue(7.0);
  vtkNew<vtkDoubleArray> stale; // Of an earlier run, say.
  stale->DeepCopy(heat);
  stale->SetName("LeafId");
  queries->GetPointData()->AddArray(heat);
  queries->GetPointData()->AddArray(stale);
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("OfCells");
  ofCells->SetNumberOfValues(queries->GetNumberOfCells());
  queries->GetCellData()->AddArray(ofCells);
  queries->GetFieldData()->AddArray(heat);

  TestedLocateFilter filter(MakeUniform(100, 350), queries);
  filter.Update();
  auto* located = vtkPolyData::SafeDownCast(filter.GetLocated());
  ASSERT_NE(located, nullptr);
  EXPECT_EQ(located->GetPoints(), queries->GetPoints()) << "no copy";
  EXPECT_EQ(located->GetPolys(), queries->GetPolys());
  EXPECT_EQ(located->GetPointData()->GetArray("Heat"), heat);
  EXPECT_EQ(located->GetPointData()->GetNormals(), queries->GetPointData()->GetNormals());
  EXPECT_EQ(located->GetPointData()->GetArray("LeafId")->GetDataType(), VTK_ID_TYPE);
  EXPECT_STREQ(located->GetPointData()->GetScalars()->GetName(), "HitCost");
  EXPECT_EQ(located->GetCellData()->GetArray("OfCells"), ofCells);
  EXPECT_EQ(located->GetFieldData()->GetArray("Heat"), heat);
  EXPECT_EQ(located->GetFieldData()->GetNumberOfArrays(), 5);
  EXPECT_EQ(queries->GetPointData()->GetNumberOfArrays(), 3) << "the input is left alone";
  EXPECT_EQ(queries->GetPointData()->GetArray("LeafId"), stale);
  EXPECT_EQ(queries->GetFieldData()->GetNumberOfArrays(), 1);
}

TEST(TestHashedOctreeLocateFilterInputs, OutputsKeepTheFieldDataOfBothInputs)
{
  const auto points = MakeUniform(100, 353);
  hashedoctree::AddFieldValue<vtkIntArray>(points->GetFieldData(), "OfPoints", 1);
  hashedoctree::AddFieldValue<vtkIntArray>(points->GetFieldData(), "OfBoth", 1);
  hashedoctree::AddFieldValue<vtkIntArray>(points->GetFieldData(), "StartDepth", 77); // Of another.
  const auto queries = MakeUniform(20, 354);
  hashedoctree::AddFieldValue<vtkIntArray>(queries->GetFieldData(), "OfBoth", 2);
  TestedLocateFilter filter(points, queries);
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("OfPoints"), 1);
  EXPECT_EQ(filter.GetFieldValue("OfBoth"), 2);
  EXPECT_EQ(filter.GetTable()->GetFieldData()->GetArray("OfBoth")->GetTuple1(0), 1);
  for (const char* name : { "StartDepth", "MeanHitCost", "BestStartDepth", "SkippedPoints" })
  {
    EXPECT_LT(filter.GetFieldValue(name), 77);
    EXPECT_EQ(
      filter.GetTable()->GetFieldData()->GetArray(name)->GetTuple1(0), filter.GetFieldValue(name));
  }

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, queries);
  hashedoctree::AddFieldValue<vtkIntArray>(blocks->GetFieldData(), "OfBoth", 3);
  TestedLocateFilter many(points, blocks);
  many.UpdateWithoutErrors();
  for (int port = 0; port < 2; ++port)
  {
    auto* output = many->GetOutputDataObject(port);
    EXPECT_EQ(output->GetFieldData()->GetArray("OfPoints")->GetTuple1(0), 1);
    EXPECT_EQ(output->GetFieldData()->GetArray("OfBoth")->GetTuple1(0), 3);
  }
}

TEST(TestHashedOctreeLocateFilterInputs, QueriesNeedNoFieldData)
{
  const auto points = MakeUniform(100, 355);
  const auto queries = MakeUniform(20, 356);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, queries);
  queries->SetFieldData(nullptr);
  blocks->SetFieldData(nullptr);
  TestedLocateFilter filter(points, queries);
  filter.Update();
  EXPECT_GT(filter.GetFieldValue("MeanHitCost"), 0);
  EXPECT_EQ(queries->GetFieldData(), nullptr) << "the input is left alone";
  TestedLocateFilter many(points, blocks);
  many.UpdateWithoutErrors();
}

TEST(TestHashedOctreeLocateFilterInputs, ReplacedArraysLoseTheirRole)
{
  const auto queries = MakeUniform(20, 352);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("HitCost");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(20);
  queries->GetPointData()->SetVectors(vectors);
  TestedLocateFilter filter(MakeUniform(100, 353), queries);
  filter.Update();
  EXPECT_EQ(filter.GetLocated()->GetPointData()->GetVectors(), nullptr);
  EXPECT_EQ(filter.GetLocated()->GetPointData()->GetScalars()->GetNumberOfComponents(), 1);
  EXPECT_EQ(queries->GetPointData()->GetVectors(), vectors) << "the input is left alone";
}

TEST(TestHashedOctreeLocateFilterInputs, QueriesMayBeOfAnyKind)
{
  const auto points = MakeUniform(500, 351);
  vtkNew<vtkImageData> image;
  image->SetExtent(3, 7, 0, 5, -2, 2);
  image->SetSpacing(0.11, 0.17, 0.19);
  image->SetOrigin(0.1, 0.2, 0.3);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    places->InsertNextPoint(image->GetPoint(i));
  }
  vtkNew<vtkStructuredGrid> structured;
  structured->SetExtent(image->GetExtent());
  structured->SetPoints(places);
  vtkNew<vtkUnstructuredGrid> unstructured;
  unstructured->SetPoints(places);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(places);
  vtkNew<vtkPointSet> plain;
  plain->SetPoints(places);

  TestedLocateFilter ofCloud(points, cloud);
  ofCloud.Update();
  TestedLocateFilter filter(points, nullptr);
  for (vtkDataSet* queries :
    std::initializer_list<vtkDataSet*>{ plain, image, structured, unstructured, plain })
  {
    SCOPED_TRACE(queries->GetClassName());
    filter->SetInputData(1, queries);
    filter.Update();
    EXPECT_STREQ(filter.GetLocated()->GetClassName(), queries->GetClassName());
    EXPECT_EQ(filter.GetLocated()->GetNumberOfCells(), queries->GetNumberOfCells());
    ExpectSameLocations(filter, ofCloud);
    filter->UpdateWholeExtent();
    EXPECT_EQ(filter.PipelineErrors, std::vector<std::string>());
    EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), places->GetNumberOfPoints());
  }
}
