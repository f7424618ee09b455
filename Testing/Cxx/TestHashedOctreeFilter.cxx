// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeFilter.h"

#include "ExpectOctree.h"
#include "PointSamples.h"
#include "SameOutputs.h"

#include "vtkDummyController.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"

#include <sstream>

// The class itself: its properties, and when it runs. What it computes is tested by topic in
// TestHashedOctreeFilter<Topic>.cxx.

TEST(TestHashedOctreeFilter, HasTheDocumentedDefaults)
{
  vtkNew<vtkHashedOctreeFilter> filter;
  EXPECT_EQ(filter->GetDimension(), vtkHashedOctreeFilter::Auto);
  EXPECT_EQ(filter->GetPlane(), vtkHashedOctreeFilter::Widest);
  EXPECT_EQ(filter->GetMaxPointsPerLeaf(), 1);
  EXPECT_FALSE(filter->GetMergePoints());
  EXPECT_EQ(filter->GetMaxDepth(), 21);
  EXPECT_EQ(filter->GetFrequencyModel(), vtkHashedOctreeFilter::Leaves);
  EXPECT_EQ(filter->GetStartDepthModel(), vtkHashedOctreeFilter::Median);
  EXPECT_EQ(filter->GetFixedStartDepth(), 0);
  EXPECT_EQ(filter->GetOutputType(), vtkHashedOctreeFilter::Voxels);
  EXPECT_FALSE(filter->GetIncludeEmptyLeaves());
  EXPECT_FALSE(filter->GetIncludeInternalNodes());
  EXPECT_FALSE(filter->GetUseCustomBounds());
  const std::vector<double> bounds(filter->GetCustomBounds(), filter->GetCustomBounds() + 6);
  EXPECT_EQ(bounds, std::vector<double>({ 0, 1, 0, 1, 0, 1 }));
  EXPECT_EQ(filter->GetNumberOfInputPorts(), 1);
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 3);
}

TEST(TestHashedOctreeFilter, ClampsValuesThatAreOutOfRange)
{
  vtkNew<vtkHashedOctreeFilter> filter;
  const auto clamped = [&filter](void (vtkHashedOctreeFilter::*set)(int),
                         int (vtkHashedOctreeFilter::*get)(), int value)
  {
    (filter->*set)(value);
    return (filter->*get)();
  };
  using F = vtkHashedOctreeFilter;
  EXPECT_EQ(clamped(&F::SetDimension, &F::GetDimension, -1), F::Auto);
  EXPECT_EQ(clamped(&F::SetDimension, &F::GetDimension, 1), F::Auto);
  EXPECT_EQ(clamped(&F::SetDimension, &F::GetDimension, 2), F::Two);
  EXPECT_EQ(clamped(&F::SetDimension, &F::GetDimension, 3), F::Three);
  EXPECT_EQ(clamped(&F::SetDimension, &F::GetDimension, 4), F::Three);
  EXPECT_EQ(clamped(&F::SetPlane, &F::GetPlane, -1), F::Widest);
  EXPECT_EQ(clamped(&F::SetPlane, &F::GetPlane, 4), F::XZ);
  EXPECT_EQ(clamped(&F::SetMaxPointsPerLeaf, &F::GetMaxPointsPerLeaf, 0), 1);
  EXPECT_EQ(clamped(&F::SetMaxPointsPerLeaf, &F::GetMaxPointsPerLeaf, VTK_INT_MIN), 1);
  EXPECT_EQ(clamped(&F::SetMaxPointsPerLeaf, &F::GetMaxPointsPerLeaf, VTK_INT_MAX), VTK_INT_MAX);
  EXPECT_EQ(clamped(&F::SetMaxDepth, &F::GetMaxDepth, -1), 0);
  EXPECT_EQ(clamped(&F::SetMaxDepth, &F::GetMaxDepth, 32), 31);
  EXPECT_EQ(clamped(&F::SetFrequencyModel, &F::GetFrequencyModel, -1), F::Leaves);
  EXPECT_EQ(clamped(&F::SetFrequencyModel, &F::GetFrequencyModel, 3), F::Grid);
  EXPECT_EQ(clamped(&F::SetStartDepthModel, &F::GetStartDepthModel, -1), F::Median);
  EXPECT_EQ(clamped(&F::SetStartDepthModel, &F::GetStartDepthModel, 4), F::Fixed);
  EXPECT_EQ(clamped(&F::SetFixedStartDepth, &F::GetFixedStartDepth, -1), 0);
  EXPECT_EQ(clamped(&F::SetFixedStartDepth, &F::GetFixedStartDepth, 32), 31);
  EXPECT_EQ(clamped(&F::SetOutputType, &F::GetOutputType, -1), F::Voxels);
  EXPECT_EQ(clamped(&F::SetOutputType, &F::GetOutputType, 3), F::HyperTreeGrid);
}

TEST(TestHashedOctreeFilter, PrintsEveryProperty)
{
  vtkNew<vtkHashedOctreeFilter> filter;
  filter->SetDimension(vtkHashedOctreeFilter::Two);
  filter->SetPlane(vtkHashedOctreeFilter::YZ);
  filter->SetMaxPointsPerLeaf(11);
  filter->MergePointsOn();
  filter->SetMaxDepth(12);
  filter->SetFrequencyModel(vtkHashedOctreeFilter::Grid);
  filter->SetStartDepthModel(vtkHashedOctreeFilter::Fixed);
  filter->SetFixedStartDepth(13);
  filter->SetOutputType(vtkHashedOctreeFilter::Outlines);
  filter->IncludeEmptyLeavesOn();
  filter->SetCustomBounds(14, 15, 16, 17, 18, 19);
  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "Dimension: 2", "Plane: 2", "MaxPointsPerLeaf: 11", "MergePoints: 1",
         "MaxDepth: 12", "FrequencyModel: 2", "StartDepthModel: 3", "FixedStartDepth: 13",
         "OutputType: 1", "IncludeEmptyLeaves: 1", "IncludeInternalNodes: 0", "UseCustomBounds: 0",
         "CustomBounds: 14, 15, 16, 17, 18, 19" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line << " is not in\n" << text.str();
  }
}

TEST(TestHashedOctreeFilter, MakesInstancesOfItself)
{
  vtkNew<vtkHashedOctreeFilter> filter;
  filter->SetMaxDepth(3);
  const auto instance = vtk::TakeSmartPointer(filter->NewInstance());
  EXPECT_STREQ(instance->GetClassName(), "vtkHashedOctreeFilter");
  EXPECT_TRUE(instance->IsA("vtkDataObjectAlgorithm"));
  EXPECT_EQ(instance->GetMaxDepth(), 21);
}

TEST(TestHashedOctreeFilter, RunsOnceWhereThePointsAreOnAGrid)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetExtent(3, 7, 0, 4, -2, 2);
  grid->SetPoints(MakePoints(MakeUniformPoints<3, double>(125, 1)));
  for (int type = vtkHashedOctreeFilter::Voxels; type <= vtkHashedOctreeFilter::HyperTreeGrid;
       ++type)
  {
    TestedFilter filter;
    filter->SetInputData(grid);
    filter->SetOutputType(type);
    for (const int port : { 0, 1, 2, 0 })
    {
      filter->Update(port);
    }
    EXPECT_EQ(filter.Executions, 1) << type;
    EXPECT_EQ(filter.Errors, std::vector<std::string>());
    EXPECT_GE(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL), 125);
  }
}

TEST(TestHashedOctreeFilter, TellsThePipelineOfNoPlaceOfThePoints)
{
  TestedFilter filter(MakeUniformPoints<3, double>(10, 1));
  vtkInformation* input = filter->GetInputInformation(0, 0);
  for (auto* place : { vtkDataObject::ORIGIN(), vtkDataObject::SPACING() })
  {
    input->Set(place, 1.0, 2.0, 3.0); // As of points that were an image's.
  }
  filter->UpdateInformation();
  for (int port = 0; port < 3; ++port)
  {
    EXPECT_FALSE(filter->GetOutputInformation(port)->Has(vtkDataObject::ORIGIN())) << port;
    EXPECT_FALSE(filter->GetOutputInformation(port)->Has(vtkDataObject::SPACING())) << port;
  }
}

TEST(TestHashedOctreeFilter, AllOutputsAreUpdatedAtOnce)
{
  const std::vector<double> points = MakeUniformPoints<3, double>(100, 1);
  TestedFilter filter(points);
  filter->Update(-1); // No output in particular.
  EXPECT_EQ(filter.Executions, 1);
  ExpectOctree(filter, OracleOctree(points, 1));
}

TEST(TestHashedOctreeFilter, RunsOnlyAfterAChange)
{
  const std::vector<double> points = MakeUniformPoints<3, double>(100, 1);
  TestedFilter filter(points);
  filter.Update();
  EXPECT_EQ(filter.Executions, 1);
  for (int port = 0; port < 3; ++port)
  {
    filter->Update(port);
  }
  filter->SetMaxDepth(filter->GetMaxDepth());
  // Clamped to what they are.
  filter->SetMaxPointsPerLeaf(0);
  filter->SetDimension(1);
  // What they are.
  filter->SetFrequencyModel(filter->GetFrequencyModel());
  filter->SetStartDepthModel(filter->GetStartDepthModel());
  filter->SetFixedStartDepth(filter->GetFixedStartDepth());
  filter->SetIncludeEmptyLeaves(filter->GetIncludeEmptyLeaves());
  filter->SetController(filter->GetController());
  filter.Update();
  EXPECT_EQ(filter.Executions, 1);

  int executions = 1;
  const auto expectRun = [&]
  {
    filter.Update();
    EXPECT_EQ(filter.Executions, ++executions);
  };
  vtkNew<vtkDummyController> controller;
  filter->SetController(controller);
  expectRun();
  filter->SetPlane(vtkHashedOctreeFilter::XZ);
  expectRun();
  filter->SetDimension(vtkHashedOctreeFilter::Three);
  expectRun();
  filter->SetMaxPointsPerLeaf(2);
  expectRun();
  filter->MergePointsOn();
  expectRun();
  filter->SetMaxDepth(3);
  expectRun();
  filter->SetFrequencyModel(vtkHashedOctreeFilter::Grid);
  expectRun();
  filter->SetStartDepthModel(vtkHashedOctreeFilter::Fixed);
  expectRun();
  filter->SetFixedStartDepth(2);
  expectRun();
  filter->SetOutputType(vtkHashedOctreeFilter::Outlines);
  expectRun();
  filter->IncludeEmptyLeavesOn();
  expectRun();
  filter->IncludeInternalNodesOn();
  expectRun();
  ExpectOctree(filter, OracleOctree(points, 2, 3));
  filter->UseCustomBoundsOn();
  expectRun();
  filter->SetCustomBounds(0, 2, 0, 2, 0, 2);
  expectRun();
  ExpectOctree(filter, OracleOctree(points, { 0, 2, 0, 2, 0, 2 }, 2, 3));
}

TEST(TestHashedOctreeFilter, LeavesItsInputAlone)
{
  vtkNew<vtkSphereSource> sphere; // With normals of its points.
  sphere->Update();
  vtkPolyData* const input = sphere->GetOutput();
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Numbers");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<int>(i));
  }
  input->GetCellData()->SetScalars(numbers);
  input->GetFieldData()->AddArray(numbers);
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(input);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.Update();
  ExpectSameArray(input->GetPoints()->GetData(), copy->GetPoints()->GetData(), "points");
  ASSERT_EQ(input->GetPointData()->GetNumberOfArrays(), 1);
  ExpectSameArrays(input->GetPointData(), copy->GetPointData());
  ExpectSameArrays(input->GetCellData(), copy->GetCellData());
  EXPECT_EQ(input->GetCellData()->GetScalars(), numbers);
  ExpectSameArrays(input->GetFieldData(), copy->GetFieldData());
  ExpectSameArray(input->GetPolys()->GetConnectivityArray(),
    copy->GetPolys()->GetConnectivityArray(), "polygons");
}
