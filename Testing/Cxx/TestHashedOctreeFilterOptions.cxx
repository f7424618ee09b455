// SPDX-License-Identifier: BSD-3-Clause
#include "ExpectOctree.h"
#include "PointSamples.h"
#include "SameOutputs.h"

#include "vtkSOADataArrayTemplate.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <array>

TEST(TestHashedOctreeFilterOptions, MaxPointsPerLeafAndMaxDepth)
{
  const std::vector<double> samples[] = { MakeClusteredPoints<3, double>(400, 30),
    MakeUniformPoints<3, double>(400, 31) };
  for (const std::vector<double>& coordinates : samples)
  {
    TestedFilter filter(coordinates);
    for (const int maxPointsPerLeaf : { 1, 8, 100, 400, VTK_INT_MAX })
    {
      for (const int maxDepth : { 0, 1, 5, 21 })
      {
        SCOPED_TRACE(std::to_string(maxPointsPerLeaf) + " points per leaf, max depth " +
          std::to_string(maxDepth));
        filter->SetMaxPointsPerLeaf(maxPointsPerLeaf);
        filter->SetMaxDepth(maxDepth);
        UpdateAndExpectOctree(filter, coordinates);
        EXPECT_LE(filter.GetFieldValue("DeepestDepth"), maxDepth);
      }
    }
  }
}

TEST(TestHashedOctreeFilterOptions, CustomBoundsGiveTheRoot)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(400, 32, -1.0, 1.0);
  const std::array<double, 6> boxes[] = { { -1, 1, -1, 1, -1, 1 }, { 0, 1, 0, 1, 0, 1 },
    { -0.5, 0.25, -0.5, 1, -1, 7 }, { -3, -0.9, -3, 0, -3, 0 }, { -1e6, 1e6, -1, 1, -1, 1 } };
  for (const auto& box : boxes)
  {
    TestedFilter filter(coordinates);
    filter->UseCustomBoundsOn();
    filter->SetCustomBounds(box.data());
    filter.Update();
    const OracleOctree expected(coordinates, box);
    ExpectOctree(filter, expected);
    const auto inside = static_cast<double>(expected.GetNodes().front().Points.size());
    EXPECT_GT(inside, 0);
    EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 400 - inside);
    EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 0);
  }
}

TEST(TestHashedOctreeFilterOptions, FacesOfCustomBoundsAreInside)
{
  const double out = std::nextafter(2.0, 3.0);
  const std::vector<double> coordinates{ 1, 1, 1, 2, 2, 2, 1, 2, 1.5, out, 1, 1, 1, out, 1, 1, 1,
    out, 1, 1, std::nextafter(1.0, 0.0) };
  TestedFilter filter(coordinates);
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(1, 2, 1, 2, 1, 2);
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 3);
  EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 4);
  ExpectOctree(filter, OracleOctree(coordinates, { 1, 2, 1, 2, 1, 2 }));
}

TEST(TestHashedOctreeFilterOptions, FlatCustomBoundsHaveARootOfSideOne)
{
  const std::vector<double> coordinates{ 3, 3, 3, 3, 3, 3, 3, 3, 4 };
  TestedFilter filter(coordinates);
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(3, 3, 3, 3, 3, 3);
  filter->SetMaxDepth(2);
  filter.Update();
  EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 2);
  ExpectOctree(filter, OracleOctree(coordinates, { 3, 3, 3, 3, 3, 3 }, 1, 2));
}

TEST(TestHashedOctreeFilterOptions, CustomBoundsNeedUseCustomBounds)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(50, 33);
  TestedFilter filter(coordinates);
  filter->SetCustomBounds(5, 4, 3, 2, 1, 0);
  UpdateAndExpectOctree(filter, coordinates);
}

namespace
{
template <typename Array>
vtkSmartPointer<vtkPolyData> MakePolyDataOf(const std::vector<double>& coordinates)
{
  vtkNew<Array> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(coordinates.size() / 3));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetTuple(i, coordinates.data() + 3 * i);
  }
  auto data = MakePolyData({});
  data->GetPoints()->SetData(array);
  return data;
}
}

TEST(TestHashedOctreeFilterOptions, ArraysOfAnyTypeGiveTheSameTree)
{
  // Whole numbers, which all types hold; more points than a thread copies at a time.
  std::vector<double> coordinates = MakeUniformPoints<3, double>(20000, 34, -100.0, 100.0);
  for (double& x : coordinates)
  {
    x = std::round(x);
  }
  TestedFilter filter(coordinates);
  UpdateAndExpectOctree(filter, coordinates);
  const auto outputs = TakeOutputs(filter.GetFilter());
  const vtkSmartPointer<vtkPolyData> inputs[] = { MakePolyData(coordinates, VTK_FLOAT),
    MakePolyData(coordinates, VTK_INT), MakePolyData(coordinates, VTK_SIGNED_CHAR),
    MakePolyData(coordinates, VTK_LONG_LONG),
    MakePolyDataOf<vtkSOADataArrayTemplate<float>>(coordinates),
    MakePolyDataOf<vtkSOADataArrayTemplate<double>>(coordinates) };
  for (const auto& input : inputs)
  {
    SCOPED_TRACE(input->GetPoints()->GetData()->GetClassName());
    filter->SetInputData(input);
    ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
  }
}

TEST(TestHashedOctreeFilterOptions, FloatsAreTakenAsTheDoublesThatTheyAre)
{
  std::vector<double> coordinates = MakeSpherePoints<3, double>(300, 35);
  for (double& x : coordinates)
  {
    x = static_cast<double>(static_cast<float>(x));
  }
  TestedFilter filter;
  filter->SetInputData(MakePolyData(coordinates, VTK_FLOAT));
  UpdateAndExpectOctree(filter, coordinates);
}

TEST(TestHashedOctreeFilterOptions, AnyPointSetGivesTheSameTree)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(60, 36);
  TestedFilter filter(coordinates);
  UpdateAndExpectOctree(filter, coordinates);
  const auto outputs = TakeOutputs(filter.GetFilter());

  vtkNew<vtkUnstructuredGrid> unstructured;
  unstructured->SetPoints(MakePoints(coordinates));
  filter->SetInputData(unstructured);
  ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);

  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(3, 4, 5);
  structured->SetPoints(MakePoints(coordinates));
  filter->SetInputData(structured);
  ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
}

TEST(TestHashedOctreeFilterOptions, CellsOfTheInputDoNotMatter)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->Update();
  std::vector<double> coordinates;
  for (vtkIdType i = 0; i < sphere->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double* x = sphere->GetOutput()->GetPoint(i);
    coordinates.insert(coordinates.end(), x, x + 3);
  }
  TestedFilter filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  UpdateAndExpectOctree(filter, coordinates);
}
