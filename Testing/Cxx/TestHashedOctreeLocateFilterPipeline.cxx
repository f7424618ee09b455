// SPDX-License-Identifier: BSD-3-Clause
#include "EmptyAmr.h"
#include "PointSamples.h"
#include "TestedLocateFilter.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkStructuredGridAlgorithm.h"
#include "vtkUniformGrid.h"

#include <algorithm>
#include <vector>

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/** One point more than its number of the time step, at given times. */
class PointsOfTime : public vtkPolyDataAlgorithm
{
public:
  static PointsOfTime* New();
  vtkTypeMacro(PointsOfTime, vtkPolyDataAlgorithm);

  std::vector<double> Times;

protected:
  PointsOfTime() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* output = outputVector->GetInformationObject(0);
    const double range[] = { this->Times.front(), this->Times.back() };
    output->Set(Pipeline::TIME_STEPS(), this->Times.data(), static_cast<int>(this->Times.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const double time = outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_TIME_STEP());
    const auto step = std::lower_bound(this->Times.begin(), this->Times.end(), time);
    const auto count = static_cast<std::size_t>(1 + (step - this->Times.begin()));
    vtkPolyData* points = vtkPolyData::GetData(outputVector);
    points->SetPoints(MakePoints(MakeUniformPoints<3, double>(count, 358)));
    points->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};

vtkStandardNewMacro(PointsOfTime);

vtkSmartPointer<PointsOfTime> MakePointsOfTime(const std::vector<double>& times)
{
  auto points = vtkSmartPointer<PointsOfTime>::New();
  points->Times = times;
  return points;
}

/** A grid of 10 x 5 x 5 points, of which it makes the extent that is asked for, as readers do. */
class GridOfExtent : public vtkStructuredGridAlgorithm
{
public:
  static GridOfExtent* New();
  vtkTypeMacro(GridOfExtent, vtkStructuredGridAlgorithm);

protected:
  GridOfExtent() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* output = outputVector->GetInformationObject(0);
    output->Set(Pipeline::WHOLE_EXTENT(), 0, 9, 0, 4, 0, 4);
    output->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkInformation* own = vtkDataObject::SetActiveAttribute(
      output, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Own", vtkDataSetAttributes::SCALARS);
    own->Set(vtkDataObject::FIELD_ARRAY_TYPE(), VTK_FLOAT);
    vtkDataObject::SetActiveAttribute(
      output, vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells", vtkDataSetAttributes::SCALARS);
    return 1;
  }
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkStructuredGrid* grid = vtkStructuredGrid::GetData(outputVector);
    int* extent = outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_EXTENT());
    grid->SetExtent(extent);
    const auto count = static_cast<std::size_t>(vtkStructuredData::GetNumberOfPoints(extent));
    grid->SetPoints(MakePoints(MakeUniformPoints<3, double>(count, 360)));
    return 1;
  }
};

vtkStandardNewMacro(GridOfExtent);

/** Points on a grid of their own. */
vtkSmartPointer<vtkStructuredGrid> MakeGrid(int width, int height)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(width, height, 1);
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  grid->SetPoints(MakePoints(MakeUniformPoints<3, double>(count, 357)));
  return grid;
}
}

TEST(TestHashedOctreeLocateFilterPipeline, TellsThePipelineWhereTheQueriesAre)
{
  const auto points = MakeGrid(2, 2);
  vtkNew<vtkImageData> queries;
  queries->SetExtent(3, 7, 0, 5, -2, 2);
  queries->SetSpacing(0.11, 0.17, 0.19);
  queries->SetOrigin(0.1, 0.2, 0.3);
  TestedLocateFilter filter(points, queries);
  filter.Update();
  for (const int port : { 0, 1 })
  {
    vtkInformation* information = filter->GetOutputInformation(port);
    const int* extent = information->Get(Pipeline::WHOLE_EXTENT());
    ASSERT_NE(extent, nullptr);
    EXPECT_TRUE(std::equal(extent, extent + 6, queries->GetExtent()));
    const double* origin = information->Get(vtkDataObject::ORIGIN());
    const double* spacing = information->Get(vtkDataObject::SPACING());
    ASSERT_TRUE(origin && spacing);
    EXPECT_TRUE(std::equal(origin, origin + 3, queries->GetOrigin()));
    EXPECT_TRUE(std::equal(spacing, spacing + 3, queries->GetSpacing()));
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, QueriesOnAGridKeepItWhereNothingIsLocated)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(3, 7, 0, 5, -2, 2);
  const auto grid = MakeGrid(4, 5);
  const auto nothing = MakePolyData<double>({});
  vtkNew<vtkUniformGrid> patch;
  patch->SetDimensions(3, 3, 3);
  const auto amr = MakeEmptyAmr({ 1 }); // An error.
  amr->SetDataSet(0, 0, patch);
  for (vtkDataSet* queries : std::vector<vtkDataSet*>{ image, grid })
  {
    for (vtkDataObject* points : std::vector<vtkDataObject*>{ nothing, amr })
    {
      TestedLocateFilter filter(points, queries);
      for (const int port : { 0, 1, 0 })
      {
        filter->Update(port);
      }
      EXPECT_EQ(filter.Executions, 1);
      EXPECT_EQ(filter.Errors.size(), points == amr ? 1U : 0U);
      filter.Errors.clear();
      ASSERT_EQ(filter.GetLocated()->GetNumberOfPoints(), queries->GetNumberOfPoints());
      EXPECT_EQ(filter.GetLocated()->GetPointData()->GetNumberOfArrays(), 0);
      EXPECT_EQ(filter.GetTable()->GetNumberOfRows(), 0);
    }
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, AsksForAllQueriesWhicheverOutputIsWanted)
{
  const auto points = MakeGrid(2, 2);
  vtkNew<vtkImageData> queries;
  queries->SetExtent(3, 7, 0, 5, -2, 2);
  for (const int port : { 0, 1 })
  {
    TestedLocateFilter filter(points, queries);
    filter.UpdatePiece(port, 0, 1);
    const int* extent = filter->GetInputInformation(1, 0)->Get(Pipeline::UPDATE_EXTENT());
    ASSERT_NE(extent, nullptr);
    EXPECT_TRUE(std::equal(extent, extent + 6, queries->GetExtent())) << port;
    EXPECT_EQ(filter.PipelineErrors, std::vector<std::string>());
    EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), queries->GetNumberOfPoints());
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, AllPiecesTogetherHaveAllPointsOfAGrid)
{
  vtkNew<vtkImageData> queries;
  queries->SetExtent(3, 7, 0, 5, -2, 2);
  for (const int numberOfPieces : { 1, 2, 3, 4 })
  {
    vtkNew<GridOfExtent> points;
    TestedLocateFilter filter;
    filter->SetInputConnection(points->GetOutputPort());
    filter->SetQueryPointsData(queries);
    int cells = 0;
    for (int piece = 0; piece < numberOfPieces; ++piece)
    {
      filter->UpdatePiece(piece, numberOfPieces, 0);
      const int* extent = points->GetOutput()->GetExtent();
      cells += (extent[1] - extent[0]) * (extent[3] - extent[2]) * (extent[5] - extent[4]);
    }
    EXPECT_EQ(cells, 9 * 4 * 4) << numberOfPieces;
    EXPECT_EQ(filter.Errors, std::vector<std::string>()) << numberOfPieces;
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, AsksForGhostsOfTheQueriesOnly)
{
  TestedLocateFilter filter(MakeUniform(50, 362), MakeUniform(50, 363));
  filter->UpdatePiece(0, 2, 3);
  const auto getLevels = [&filter](int port)
  { return filter->GetInputInformation(port, 0)->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()); };
  EXPECT_EQ(getLevels(0), 0);
  EXPECT_EQ(getLevels(1), 3);
}

TEST(TestHashedOctreeLocateFilterPipeline, TellsThePipelineOfTheActiveArray)
{
  vtkNew<GridOfExtent> queries;
  TestedLocateFilter filter;
  filter->SetInputData(MakeUniform(50, 361));
  filter->SetQueryPointsConnection(queries->GetOutputPort());
  filter->UpdateInformation();
  const auto getActive = [](vtkInformation* information)
  {
    return vtkDataObject::GetActiveFieldInformation(
      information, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  };
  vtkInformation* active = getActive(filter->GetOutputInformation(0));
  ASSERT_NE(active, nullptr);
  EXPECT_STREQ(active->Get(vtkDataObject::FIELD_NAME()), "HitCost");
  EXPECT_EQ(active->Get(vtkDataObject::FIELD_ARRAY_TYPE()), VTK_INT);
  EXPECT_EQ(active->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()), 1);
  // What the queries have is told of, too, and they still tell of it themselves.
  vtkInformation* own = vtkDataObject::GetNamedFieldInformation(
    filter->GetOutputInformation(0), vtkDataObject::FIELD_ASSOCIATION_POINTS, "Own");
  ASSERT_NE(own, nullptr);
  EXPECT_EQ(own->Get(vtkDataObject::FIELD_ARRAY_TYPE()), VTK_FLOAT);
  active = getActive(queries->GetOutputInformation(0));
  ASSERT_NE(active, nullptr);
  EXPECT_STREQ(active->Get(vtkDataObject::FIELD_NAME()), "Own");
}

TEST(TestHashedOctreeLocateFilterPipeline, TellsThePipelineOfTheArraysOfTheQueriesOnly)
{
  vtkNew<GridOfExtent> grid;
  TestedLocateFilter filter;
  for (const int port : { 1, 0 }) // Nothing is left of what was told before.
  {
    filter->SetInputConnection(port, grid->GetOutputPort());
    filter->SetInputData(1 - port, MakeUniform(50, 364));
    filter->UpdateInformation();
    vtkInformation* output = filter->GetOutputInformation(0);
    EXPECT_EQ(vtkDataObject::GetNamedFieldInformation(
                output, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Own") != nullptr,
      port == 1);
    EXPECT_EQ(vtkDataObject::GetNamedFieldInformation(
                output, vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells") != nullptr,
      port == 1);
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, FollowsTheTimeOfTheQueries)
{
  TestedLocateFilter filter;
  filter->SetInputData(0, MakeUniform(50, 359));
  filter->SetInputConnection(1, MakePointsOfTime({ 1.0, 2.0, 4.0 })->GetOutputPort());
  for (const auto& [time, expected] : { std::pair(1.0, 1), { 4.0, 3 }, { 2.0, 2 } })
  {
    filter->UpdateTimeStep(time);
    EXPECT_EQ(filter.GetLocated()->GetNumberOfPoints(), expected);
    EXPECT_EQ(filter.GetLocated()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, TellsThePipelineTheTimesOfBothInputs)
{
  TestedLocateFilter filter;
  filter->SetInputConnection(0, MakePointsOfTime({ 1.0, 2.0, 4.0 })->GetOutputPort());
  filter->SetInputConnection(1, MakePointsOfTime({ 0.5, 2.0, 3.0 })->GetOutputPort());
  filter->UpdateInformation();
  for (const int port : { 0, 1 })
  {
    vtkInformation* information = filter->GetOutputInformation(port);
    const double* steps = information->Get(Pipeline::TIME_STEPS());
    EXPECT_EQ(std::vector<double>(steps, steps + information->Length(Pipeline::TIME_STEPS())),
      std::vector<double>({ 0.5, 1.0, 2.0, 3.0, 4.0 }));
    const double* range = information->Get(Pipeline::TIME_RANGE());
    EXPECT_EQ(std::vector<double>(range, range + 2), std::vector<double>({ 0.5, 4.0 }));
  }
}

TEST(TestHashedOctreeLocateFilterPipeline, TellsNoTimesWhereThereAreNone)
{
  TestedLocateFilter filter;
  filter->SetInputData(0, MakeUniform(50, 360));
  filter->SetInputConnection(1, MakePointsOfTime({ 1.0, 2.0 })->GetOutputPort());
  filter.Update();
  filter->SetInputData(1, MakeUniform(5, 361)); // Nothing is left of what was told before.
  filter.Update();
  EXPECT_FALSE(filter->GetOutputInformation(0)->Has(Pipeline::TIME_STEPS()));
  EXPECT_FALSE(filter->GetOutputInformation(0)->Has(Pipeline::TIME_RANGE()));
}
