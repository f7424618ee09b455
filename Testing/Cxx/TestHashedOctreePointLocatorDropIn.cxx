// SPDX-License-Identifier: BSD-3-Clause

// In the filters that take a locator, in place of vtkStaticPointLocator: the same output. The data
// have no ties, in which the static locator picks any point. Points within a radius come in another
// order, so that sums may differ in their last digits.
#include "PointSamples.h"
#include "TestedLocator.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkClosestNPointsStrategy.h"
#include "vtkClosestPointStrategy.h"
#include "vtkConnectedPointsFilter.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkEuclideanClusterExtraction.h"
#include "vtkFloatArray.h"
#include "vtkGaussianKernel.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkInterpolationKernel.h"
#include "vtkLinearKernel.h"
#include "vtkPCACurvatureEstimation.h"
#include "vtkPCANormalEstimation.h"
#include "vtkPointData.h"
#include "vtkPointDensityFilter.h"
#include "vtkPointInterpolator.h"
#include "vtkPointInterpolator2D.h"
#include "vtkPointSmoothingFilter.h"
#include "vtkPoissonDiskSampler.h"
#include "vtkProbeFilter.h"
#include "vtkRadiusOutlierRemoval.h"
#include "vtkSMPTools.h"
#include "vtkSPHInterpolator.h"
#include "vtkSPHQuinticKernel.h"
#include "vtkShepardKernel.h"
#include "vtkSignedDistance.h"
#include "vtkStaticPointLocator.h"
#include "vtkStatisticalOutlierRemoval.h"
#include "vtkUnsignedDistance.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVoronoiKernel.h"

#include <array>
#include <cmath>
#include <functional>
#include <set>

namespace
{
/** A wavy sheet, with a scalar and normals. */
vtkSmartPointer<vtkPolyData> MakeSheet(std::size_t count, unsigned seed)
{
  std::vector<float> coordinates = MakeUniformPoints<3, float>(count, seed);
  vtkNew<vtkFloatArray> height;
  height->SetName("height");
  vtkNew<vtkFloatArray> normals;
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < count; ++i)
  {
    float* x = &coordinates[3 * i];
    const float slope = std::cos(7 * x[0]);
    x[2] = x[2] * 0.01F + std::sin(7 * x[0]) / 7;
    height->InsertNextValue(x[2] + x[1]);
    const float length = std::sqrt(1 + slope * slope);
    normals->InsertNextTuple3(-slope / length, 0, 1 / length);
  }
  auto sheet = MakePolyData(coordinates);
  sheet->GetPointData()->SetScalars(height);
  sheet->GetPointData()->SetNormals(normals);
  return sheet;
}

void ExpectNearArray(vtkDataArray* expected, vtkDataArray* actual, const std::string& name)
{
  ASSERT_TRUE(expected != nullptr && actual != nullptr) << name;
  ASSERT_EQ(expected->GetNumberOfTuples(), actual->GetNumberOfTuples()) << name;
  ASSERT_EQ(expected->GetNumberOfComponents(), actual->GetNumberOfComponents()) << name;
  for (int component = 0; component < expected->GetNumberOfComponents(); ++component)
  {
    double range[2];
    expected->GetRange(range, component);
    const double slack = 1e-5 * std::max({ std::abs(range[0]), std::abs(range[1]), 1e-30 });
    for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
    {
      ASSERT_NEAR(expected->GetComponent(i, component), actual->GetComponent(i, component), slack)
        << name << ", tuple " << i;
    }
  }
}

void ExpectNearAttributes(vtkDataSetAttributes* expected, vtkDataSetAttributes* actual)
{
  ASSERT_EQ(expected->GetNumberOfArrays(), actual->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    ExpectNearArray(expected->GetArray(i), actual->GetArray(i), expected->GetArrayName(i));
  }
}

/** Tetrahedra that fill [0, 3] on each axis, with a scalar. */
vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(7, 7, 7);
  image->SetSpacing(0.5, 0.5, 0.5);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("scalars");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i * i % 101));
  }
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(image);
  filter->Update();
  return filter->GetOutput();
}

/** Cells that a strategy finds must be the same with our locator as with the static one. */
template <typename Strategy>
void ExpectSameCellsFrom()
{
  const auto mesh = MakeTetrahedra();
  vtkNew<vtkStaticPointLocator> plain;
  TestedLocator ours(mesh);
  plain->SetDataSet(mesh);
  const std::vector<double> queries = MakeUniformPoints<3, double>(500, 67, -0.3, 3.3);
  std::vector<std::vector<vtkIdType>> cells;
  for (vtkAbstractPointLocator* locator :
    std::initializer_list<vtkAbstractPointLocator*>{ plain, ours.Get() })
  {
    vtkNew<Strategy> strategy;
    strategy->SetPointLocator(locator);
    ASSERT_TRUE(strategy->Initialize(mesh));
    vtkNew<vtkGenericCell> cell;
    cells.emplace_back();
    for (std::size_t i = 0; i < queries.size(); i += 3)
    {
      double x[3];
      std::copy_n(&queries[i], 3, x);
      int subId = 0;
      double parametric[3];
      double weights[8];
      cells.back().push_back(
        strategy->FindCell(x, nullptr, cell, -1, 1e-12, subId, parametric, weights));
    }
  }
  EXPECT_GT(ours->GetBuildTime(), 0U); // Has been used.
  EXPECT_GT(std::set<vtkIdType>(cells[0].begin(), cells[0].end()).size(), 100U);
  EXPECT_EQ(cells[0], cells[1]);
}

using Output = vtkSmartPointer<vtkDataSet>;

Output Execute(vtkAlgorithm* filter)
{
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  Output copy = vtk::TakeSmartPointer(output->NewInstance());
  copy->DeepCopy(output);
  return copy;
}

/** What run(locator) gives with the static locator it must give with ours, too. */
void ExpectSameOutput(const std::function<Output(vtkAbstractPointLocator*)>& run)
{
  const Output expected = run(vtkSmartPointer<vtkStaticPointLocator>::New());
  TestedLocator locator;
  const Output actual = run(locator.Get());
  EXPECT_GT(locator->GetBuildTime(), 0U); // Has been used.
  ASSERT_GT(expected->GetNumberOfPoints(), 0);
  ASSERT_EQ(expected->GetNumberOfPoints(), actual->GetNumberOfPoints());
  ASSERT_EQ(expected->GetNumberOfCells(), actual->GetNumberOfCells());
  const double size = expected->GetLength();
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    double x[3];
    double y[3];
    expected->GetPoint(i, x);
    actual->GetPoint(i, y);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(x[axis], y[axis], 1e-6 * size) << "point " << i;
    }
  }
  ExpectNearAttributes(expected->GetPointData(), actual->GetPointData());
  ExpectNearAttributes(expected->GetCellData(), actual->GetCellData());
}

/** Of filters that take points and a locator. */
template <typename Filter>
void ExpectSameOutputOf(const std::function<void(Filter*)>& setUp)
{
  ExpectSameOutput(
    [&setUp](vtkAbstractPointLocator* locator)
    {
      vtkNew<Filter> filter;
      filter->SetInputDataObject(MakeSheet(2000, 61));
      filter->SetLocator(locator);
      setUp(filter);
      return Execute(filter);
    });
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 10, 7);
  image->SetOrigin(-0.1003, -0.1007, -0.2);
  image->SetSpacing(0.1513, 0.1337, 0.07);
  return image;
}

/** Of filters that interpolate between points by a kernel. */
template <typename Filter>
void ExpectSameInterpolation(vtkInterpolationKernel* kernel)
{
  ExpectSameOutput(
    [kernel](vtkAbstractPointLocator* locator)
    {
      vtkNew<Filter> filter;
      filter->SetInputData(MakeImage());
      filter->SetSourceData(MakeSheet(2000, 62));
      filter->SetKernel(kernel);
      filter->SetLocator(locator);
      filter->SetNullPointsStrategyToClosestPoint();
      return Execute(filter);
    });
}
}

TEST(TestHashedOctreePointLocatorDropIn, PointInterpolator)
{
  vtkNew<vtkVoronoiKernel> voronoi;
  vtkNew<vtkGaussianKernel> gaussian;
  gaussian->SetRadius(0.15);
  vtkNew<vtkShepardKernel> shepard;
  shepard->SetKernelFootprintToNClosest();
  shepard->SetNumberOfPoints(8);
  vtkNew<vtkLinearKernel> linear;
  linear->SetRadius(0.1);
  const std::vector<vtkInterpolationKernel*> kernels{ voronoi, gaussian, shepard, linear };
  for (vtkInterpolationKernel* kernel : kernels)
  {
    SCOPED_TRACE(kernel->GetClassName());
    ExpectSameInterpolation<vtkPointInterpolator>(kernel);
  }
}

TEST(TestHashedOctreePointLocatorDropIn, PointInterpolatorOfAnImage)
{
  ExpectSameOutput(
    [](vtkAbstractPointLocator* locator)
    {
      const auto source = MakeImage();
      vtkNew<vtkFloatArray> values;
      values->SetName("values");
      for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
      {
        values->InsertNextValue(static_cast<float>(i % 17));
      }
      source->GetPointData()->SetScalars(values);
      vtkNew<vtkGaussianKernel> kernel;
      kernel->SetRadius(0.3);
      vtkNew<vtkPointInterpolator> filter;
      filter->SetInputData(MakeSheet(500, 63));
      filter->SetSourceData(source);
      filter->SetKernel(kernel);
      filter->SetLocator(locator);
      return Execute(filter);
    });
}

/** All points in the plane z = 0, which the filter makes of its source. */
TEST(TestHashedOctreePointLocatorDropIn, PointInterpolator2D)
{
  vtkNew<vtkGaussianKernel> kernel;
  kernel->SetRadius(0.15);
  ExpectSameInterpolation<vtkPointInterpolator2D>(kernel);
}

TEST(TestHashedOctreePointLocatorDropIn, SPHInterpolator)
{
  ExpectSameOutput(
    [](vtkAbstractPointLocator* locator)
    {
      vtkNew<vtkSPHQuinticKernel> kernel;
      kernel->SetSpatialStep(0.05);
      vtkNew<vtkSPHInterpolator> filter;
      filter->SetInputData(MakeImage());
      filter->SetSourceData(MakeSheet(2000, 64));
      filter->SetKernel(kernel);
      filter->SetLocator(locator);
      return Execute(filter);
    });
}

TEST(TestHashedOctreePointLocatorDropIn, PCANormalEstimation)
{
  for (const int orientation :
    { vtkPCANormalEstimation::POINT, vtkPCANormalEstimation::GRAPH_TRAVERSAL })
  {
    ExpectSameOutputOf<vtkPCANormalEstimation>(
      [orientation](vtkPCANormalEstimation* filter)
      {
        filter->SetSampleSize(12);
        filter->SetNormalOrientation(orientation);
        filter->SetOrientationPoint(0.5, 0.5, 100.0);
      });
  }
}

TEST(TestHashedOctreePointLocatorDropIn, PCACurvatureEstimation)
{
  ExpectSameOutputOf<vtkPCACurvatureEstimation>(
    [](vtkPCACurvatureEstimation* filter) { filter->SetSampleSize(12); });
}

TEST(TestHashedOctreePointLocatorDropIn, StatisticalOutlierRemoval)
{
  ExpectSameOutputOf<vtkStatisticalOutlierRemoval>(
    [](vtkStatisticalOutlierRemoval* filter) { filter->SetSampleSize(10); });
}

TEST(TestHashedOctreePointLocatorDropIn, RadiusOutlierRemoval)
{
  ExpectSameOutputOf<vtkRadiusOutlierRemoval>(
    [](vtkRadiusOutlierRemoval* filter)
    {
      filter->SetRadius(0.03);
      filter->SetNumberOfNeighbors(5);
    });
}

TEST(TestHashedOctreePointLocatorDropIn, EuclideanClusterExtraction)
{
  // The points come out as the clusters grow, in the order of those within the radius.
  const auto run = [](vtkAbstractPointLocator* locator)
  {
    vtkNew<vtkEuclideanClusterExtraction> filter;
    filter->SetInputData(MakeSheet(2000, 61));
    filter->SetLocator(locator);
    filter->SetRadius(0.02);
    filter->SetExtractionModeToAllClusters();
    filter->ColorClustersOn();
    const Output output = Execute(filter);
    vtkDataArray* clusters = output->GetPointData()->GetArray("ClusterId");
    std::vector<std::array<double, 4>> points;
    for (vtkIdType i = 0; clusters != nullptr && i < output->GetNumberOfPoints(); ++i)
    {
      const double* x = output->GetPoint(i);
      points.push_back({ x[0], x[1], x[2], clusters->GetTuple1(i) });
    }
    std::sort(points.begin(), points.end());
    return points;
  };
  vtkNew<vtkStaticPointLocator> plain;
  TestedLocator ours;
  const auto expected = run(plain);
  ASSERT_EQ(expected.size(), 2000U);
  EXPECT_EQ(run(ours.Get()), expected);
}

TEST(TestHashedOctreePointLocatorDropIn, ConnectedPointsFilter)
{
  ExpectSameOutputOf<vtkConnectedPointsFilter>(
    [](vtkConnectedPointsFilter* filter)
    {
      filter->SetRadius(0.02);
      filter->SetExtractionModeToLargestRegion();
    });
}

TEST(TestHashedOctreePointLocatorDropIn, PointDensityFilter)
{
  ExpectSameOutputOf<vtkPointDensityFilter>(
    [](vtkPointDensityFilter* filter)
    {
      filter->SetSampleDimensions(12, 13, 8);
      filter->SetDensityEstimateToFixedRadius();
      filter->SetRadius(0.11);
    });
}

TEST(TestHashedOctreePointLocatorDropIn, PointSmoothingFilter)
{
  ExpectSameOutputOf<vtkPointSmoothingFilter>(
    [](vtkPointSmoothingFilter* filter)
    {
      filter->SetNeighborhoodSize(8);
      filter->SetNumberOfIterations(5);
      filter->SetNumberOfSubIterations(2);
      filter->SetSmoothingModeToUniform();
    });
}

TEST(TestHashedOctreePointLocatorDropIn, PoissonDiskSampler)
{
  // On several threads it gives other points each time, whatever its locator.
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    []
    {
      ExpectSameOutputOf<vtkPoissonDiskSampler>(
        [](vtkPoissonDiskSampler* filter) { filter->SetRadius(0.04); });
    });
}

TEST(TestHashedOctreePointLocatorDropIn, SignedDistance)
{
  ExpectSameOutputOf<vtkSignedDistance>(
    [](vtkSignedDistance* filter)
    {
      filter->SetDimensions(15, 16, 17);
      filter->SetBounds(-0.1, 1.1, -0.1, 1.1, -0.3, 0.3);
      filter->SetRadius(0.1);
    });
}

TEST(TestHashedOctreePointLocatorDropIn, UnsignedDistance)
{
  ExpectSameOutputOf<vtkUnsignedDistance>(
    [](vtkUnsignedDistance* filter)
    {
      filter->SetDimensions(15, 16, 17);
      filter->SetBounds(-0.1, 1.1, -0.1, 1.1, -0.3, 0.3);
      filter->AdjustBoundsOff();
      filter->SetRadius(0.1);
    });
}

TEST(TestHashedOctreePointLocatorDropIn, ClosestPointStrategy)
{
  ExpectSameCellsFrom<vtkClosestPointStrategy>();
}

TEST(TestHashedOctreePointLocatorDropIn, ClosestNPointsStrategy)
{
  ExpectSameCellsFrom<vtkClosestNPointsStrategy>();
}

TEST(TestHashedOctreePointLocatorDropIn, ProbeFilter)
{
  ExpectSameOutput(
    [](vtkAbstractPointLocator* locator)
    {
      const auto mesh = MakeTetrahedra();
      locator->SetDataSet(mesh);
      vtkNew<vtkClosestNPointsStrategy> strategy;
      strategy->SetPointLocator(locator);
      vtkNew<vtkProbeFilter> filter;
      filter->SetInputData(MakePolyData(MakeUniformPoints<3, double>(500, 68, -0.3, 3.3)));
      filter->SetSourceData(mesh);
      filter->SetFindCellStrategy(strategy);
      Output output = Execute(filter);
      EXPECT_GT(filter->GetValidPoints()->GetNumberOfTuples(), 200);
      return output;
    });
}

TEST(TestHashedOctreePointLocatorDropIn, PointSetFindPoint)
{
  const auto plain = MakeSheet(2000, 65);
  const auto ours = MakeSheet(2000, 65);
  TestedLocator locator;
  ours->SetPointLocator(locator.Get());
  locator->SetDataSet(ours); // SetPointLocator() leaves that to its caller.
  const std::vector<double> queries = MakeUniformPoints<3, double>(1000, 66, -0.5, 1.5);
  for (std::size_t i = 0; i < queries.size(); i += 3)
  {
    double x[3] = { queries[i], queries[i + 1], queries[i + 2] };
    ASSERT_EQ(ours->FindPoint(x), plain->FindPoint(x));
  }
  EXPECT_EQ(ours->GetPointLocator(), locator.Get());
  ours->GetPoints()->SetPoint(3, 9, 9, 9);
  ours->GetPoints()->Modified();
  double corner[3] = { 8, 8, 8 };
  EXPECT_EQ(ours->FindPoint(corner), 3);
  ours->Initialize();
  EXPECT_EQ(ours->FindPoint(corner), -1);
}
