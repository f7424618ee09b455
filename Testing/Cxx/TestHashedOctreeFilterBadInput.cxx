// SPDX-License-Identifier: BSD-3-Clause
#include "EmptyAmr.h"
#include "ExpectOctree.h"
#include "MemoryLimit.h"
#include "PointSamples.h"
#include "SameOutputs.h"
#include "Sanitized.h"

#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** After an error the same filter must do its work as if nothing had happened. */
void ExpectToWorkAgain(TestedFilter& filter)
{
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(50, 40);
  filter->SetInputData(MakePolyData(coordinates));
  filter->UseCustomBoundsOff();
  UpdateAndExpectOctree(filter, coordinates);
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}
}

TEST(TestHashedOctreeFilterBadInput, NoPointsMakeNothing)
{
  for (const int outputType : { vtkHashedOctreeFilter::Voxels, vtkHashedOctreeFilter::Outlines })
  {
    TestedFilter filter(std::vector<double>{});
    filter->SetOutputType(outputType);
    filter.UpdateToNothing();
    ExpectToWorkAgain(filter);
    filter->SetInputData(vtkSmartPointer<vtkPolyData>::New()); // Not even an array of points.
    filter.UpdateToNothing();
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeFilterBadInput, NothingOfAnEarlierRunIsLeft)
{
  TestedFilter filter(MakeUniformPoints<3, double>(50, 41));
  filter.Update();
  ASSERT_GT(filter.GetCells()->GetNumberOfCells(), 0);
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(1, 0, 0, 1, 0, 1);
  filter.UpdateInError("bounds");
  filter->UseCustomBoundsOff();
  filter.Update();
  ASSERT_GT(filter.GetCells()->GetNumberOfCells(), 0);
  filter->SetInputData(MakePolyData({}));
  filter.UpdateToNothing();
}

TEST(TestHashedOctreeFilterBadInput, AnErrorIsSaidOnce)
{
  TestedFilter filter(MakeUniformPoints<3, double>(50, 41));
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(1, 0, 0, 1, 0, 1);
  filter.UpdateInError("bounds");
  filter.UpdateToNothing(); // It would find the same.
}

TEST(TestHashedOctreeFilterBadInput, AmrIsRefusedOnce)
{
  const auto grids = MakeEmptyAmr({ 2, 1 });
  TestedFilter filter;
  filter->SetInputData(grids);
  filter.UpdateToNothing();
  for (const auto& [level, block] : { std::pair(0U, 0U), std::pair(0U, 1U), std::pair(1U, 0U) })
  {
    vtkNew<vtkUniformGrid> grid;
    grid->SetDimensions(3, 3, 3);
    grids->SetDataSet(level, block, grid);
  }
  grids->Modified();
  filter.UpdateExpectingError("no coordinates of their own");
}

TEST(TestHashedOctreeFilterBadInput, NoFinitePointMakesNothing)
{
  TestedFilter filter({ NotANumber, 0, 0, 0, Infinity, 0, 0, 0, -Infinity });
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("3 of 3 points");
  filter.ExpectEmptyOutputs();
  ExpectToWorkAgain(filter);
}

TEST(TestHashedOctreeFilterBadInput, AnEmptyPieceMakesNothing)
{
  for (const int port : { 0, 1, 2 })
  {
    TestedFilter filter(std::vector<double>{});
    filter.UpdatePiece(port, 1, 4);
    EXPECT_EQ(filter.Errors, std::vector<std::string>());
    EXPECT_EQ(filter.PipelineErrors, std::vector<std::string>());
    EXPECT_EQ(filter.Warnings, std::vector<std::string>());
    filter.ExpectEmptyOutputs();
  }

  TestedFilter filter({ 1, 2, 3 });
  filter->UseCustomBoundsOn(); // The unit cube, in which others may have points.
  filter.UpdatePiece(0, 1, 4);
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
  filter.ExpectEmptyOutputs();
}

TEST(TestHashedOctreeFilterBadInput, PointsThatAreNotFiniteAreSkippedWithOneWarning)
{
  const std::vector<double> good = MakeUniformPoints<3, double>(500, 42);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    std::vector<double> finite;
    std::vector<double> all;
    const double bad[] = { NotANumber, Infinity, -Infinity };
    for (std::size_t i = 0; i < good.size(); ++i)
    {
      const double x =
        type == VTK_FLOAT ? static_cast<double>(static_cast<float>(good[i])) : good[i];
      finite.push_back(x);
      all.push_back(x);
      if (i % 60 == 59) // After 20 good points, one that has a bad coordinate.
      {
        all.insert(all.end(), { 0.5, 0.5, 0.5 });
        all[all.size() - 1 - i / 60 % 3] = bad[i / 180 % 3];
      }
    }
    TestedFilter filter;
    filter->SetInputData(MakePolyData(all, type));
    filter.Update();
    filter.ExpectWarning("25 of 525 points");
    EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 25);
    EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 0);
    ExpectOctree(filter, OracleOctree(finite));
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeFilterBadInput, PointsOfOtherPiecesAreLeftOut)
{
  std::vector<double> own = MakeUniformPoints<3, double>(300, 49);
  own.insert(own.end(), own.begin(), own.begin() + 60); // Some twice.
  std::vector<double> all = own;
  const std::vector<double> others = MakeUniformPoints<3, double>(100, 50, -0.5, 2.0);
  all.insert(all.begin() + 30, others.begin(), others.end());
  const auto input = MakePolyData(all);
  double bounds[6]; // Of all, since a piece has those of the whole.
  input->GetBounds(bounds);
  vtkUnsignedCharArray* ghosts = input->AllocatePointGhostArray();
  std::fill_n(ghosts->GetPointer(10), 100, vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENPOINT); // Which is one, though it is not shown.
  for (const int dimension : { vtkHashedOctreeFilter::Two, vtkHashedOctreeFilter::Three })
  {
    for (const bool merge : { false, true })
    {
      TestedFilter filter;
      filter->SetDimension(dimension);
      filter->SetMergePoints(merge);
      filter->UseCustomBoundsOn();
      filter->SetCustomBounds(bounds);
      filter->SetInputData(MakePolyData(own));
      const auto expected = TakeOutputs(filter.GetFilter());
      filter->UseCustomBoundsOff();
      filter->SetInputData(input);
      ExpectSameOutputs(TakeOutputs(filter.GetFilter()), expected);
      EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), merge ? 300 : 320);
    }
  }
  std::fill_n(ghosts->GetPointer(0), 420, vtkDataSetAttributes::DUPLICATEPOINT);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateToNothing();
  for (const int marks : { 419, 421, 840 }) // Not one for each point: nothing is marked.
  {
    ghosts->SetNumberOfTuples(marks);
    ghosts->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
    filter->Modified();
    filter.Update();
    EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 420) << marks;
  }
  ghosts->SetNumberOfComponents(2);
  for (const int marks : { 210, 420 }) // As many values as points, or tuples.
  {
    ghosts->SetNumberOfTuples(marks);
    ghosts->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
    filter->Modified();
    filter.Update();
    EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 420) << marks;
  }
}

TEST(TestHashedOctreeFilterBadInput, PointsWithoutThreeCoordinatesAreAnError)
{
  for (const int components : { 1, 2, 4 })
  {
    const auto input = MakePolyData(MakeUniformPoints<3, double>(48, 51));
    input->GetPoints()->GetData()->SetNumberOfComponents(components);
    TestedFilter filter;
    filter->SetInputData(input);
    filter.UpdateInError("three components");
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeFilterBadInput, CornersOfCellsOfAnOctreeAreTakenWithAWarning)
{
  for (const int outputType : { vtkHashedOctreeFilter::Voxels, vtkHashedOctreeFilter::Outlines })
  {
    TestedFilter first(MakeUniformPoints<3, double>(50, 52));
    first->SetOutputType(outputType);
    first.Update();
    EXPECT_EQ(first.Warnings, std::vector<std::string>());
    TestedFilter second;
    second->SetInputData(first.GetCells());
    second.Update();
    second.ExpectWarning("corners");
    EXPECT_EQ(second.GetFieldValue("NumberOfPoints"), first.GetCells()->GetNumberOfPoints());
  }
  const auto others = MakePolyData(MakeUniformPoints<3, double>(50, 52));
  vtkNew<vtkIntArray> keys;
  keys->SetName("MortonKey"); // Of whoever.
  others->GetCellData()->AddArray(keys);
  TestedFilter filter;
  filter->SetInputData(others);
  filter.UpdateSilently();
}

TEST(TestHashedOctreeFilterBadInput, PointsOfOtherPiecesAreCountedThere)
{
  // Of two points each that are in the bounds, outside, and not finite, one is another piece's.
  const auto input =
    MakePolyData({ 0, 0, 0, 1, 1, 1, 5, 0, 0, 6, 0, 0, NotANumber, 0, 0, 0, Infinity, 0 });
  vtkUnsignedCharArray* ghosts = input->AllocatePointGhostArray();
  for (const int point : { 1, 3, 5 })
  {
    ghosts->SetValue(point, vtkDataSetAttributes::DUPLICATEPOINT);
  }
  TestedFilter filter;
  filter->SetInputData(input);
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(0, 2, 0, 2, 0, 2);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("1 of 3 points");
  EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), 1);
  EXPECT_EQ(filter.GetFieldValue("OutsidePoints"), 1);
  EXPECT_EQ(filter.GetFieldValue("SkippedPoints"), 1);
  // Now the other piece alone has some in the bounds.
  ghosts->SetValue(0, vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->SetValue(4, vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->Modified();
  input->Modified();
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("CustomBounds");
  filter.ExpectEmptyOutputs();
}

TEST(TestHashedOctreeFilterBadInput, CustomBoundsThatCannotBeAreAnError)
{
  const std::array<double, 6> boxes[] = { { 1, 0, 0, 1, 0, 1 }, { 0, 1, 1, 0, 0, 1 },
    { 0, 1, 0, 1, 1, 0 }, { NotANumber, 1, 0, 1, 0, 1 }, { 0, 1, 0, NotANumber, 0, 1 },
    { 0, 1, 0, 1, -Infinity, 1 }, { 0, 1, 0, 1, 0, Infinity } };
  for (const auto& box : boxes)
  {
    TestedFilter filter(MakeUniformPoints<3, double>(50, 43));
    filter->UseCustomBoundsOn();
    filter->SetCustomBounds(box.data());
    filter.UpdateInError("bounds");
    ExpectToWorkAgain(filter);
    filter->UseCustomBoundsOn();
    filter->SetInputData(MakePolyData({}));
    filter.UpdateInError("bounds");
    ExpectToWorkAgain(filter);
  }
}

TEST(TestHashedOctreeFilterBadInput, CustomBoundsWithoutPointsMakeNothing)
{
  TestedFilter filter(MakeUniformPoints<3, double>(50, 44));
  filter->UseCustomBoundsOn();
  filter->SetCustomBounds(2, 3, 2, 3, 2, 3);
  filter.UpdateWithoutErrors();
  filter.ExpectWarning("CustomBounds");
  filter.ExpectEmptyOutputs();
  ExpectToWorkAgain(filter);
}

TEST(TestHashedOctreeFilterBadInput, CustomBoundsWithoutFinitePointsMakeNothing)
{
  TestedFilter filter({ 5, 5, 5, NotANumber, 0, 0 });
  filter->UseCustomBoundsOn();
  filter.UpdateWithoutErrors();
  ASSERT_EQ(filter.Warnings.size(), 2U);
  EXPECT_NE(filter.Warnings[0].find("1 of 2 points"), std::string::npos);
  EXPECT_NE(filter.Warnings[1].find("CustomBounds"), std::string::npos);
  filter.ExpectEmptyOutputs();
}

TEST(TestHashedOctreeFilterBadInput, NoPointsMayHaveAnyComponents)
{
  const auto input = MakePolyData({});
  input->GetPoints()->GetData()->SetNumberOfComponents(2);
  TestedFilter filter;
  filter->SetInputData(input);
  filter.UpdateToNothing();
}

TEST(TestHashedOctreeFilterBadInput, OnePointIsOneLeaf)
{
  const std::vector<double> coordinates{ -4, 5, 6 };
  TestedFilter filter(coordinates);
  UpdateAndExpectOctree(filter, coordinates);
  EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 1);
  const std::vector<double> bounds(
    filter.GetCells()->GetBounds(), filter.GetCells()->GetBounds() + 6);
  EXPECT_EQ(bounds, std::vector<double>({ -4, -3, 5, 6, 6, 7 }));
}

TEST(TestHashedOctreeFilterBadInput, EqualPointsShareOneLeaf)
{
  std::vector<double> coordinates;
  for (int i = 0; i < 1000; ++i)
  {
    coordinates.insert(coordinates.end(), { 7, -8, 9 });
  }
  TestedFilter filter(coordinates);
  for (const int maxPointsPerLeaf : { 1, 999, 1000 })
  {
    filter->SetMaxPointsPerLeaf(maxPointsPerLeaf);
    UpdateAndExpectOctree(filter, coordinates);
    EXPECT_EQ(filter.GetCells()->GetNumberOfCells(), 1);
    EXPECT_EQ(filter.GetFieldValue("DeepestDepth"), maxPointsPerLeaf < 1000 ? 21 : 0);
  }
}

TEST(TestHashedOctreeFilterBadInput, MergedPointsCountAsOne)
{
  const std::vector<double> once = MakeUniformPoints<3, double>(400, 51);
  std::vector<double> often = once;
  for (std::size_t i = 0; i < once.size(); i += 3)
  {
    for (std::size_t copy = 0; copy < i % 7; ++copy)
    {
      const double nearly = 1e-15 * static_cast<double>(copy); // In the same cell.
      often.insert(often.end(), { once[i] + nearly, once[i + 1] - nearly, once[i + 2] });
    }
  }
  for (const int dimension : { vtkHashedOctreeFilter::Two, vtkHashedOctreeFilter::Three })
  {
    for (const int most : { 1, 3 })
    {
      TestedFilter filter(once);
      filter->SetDimension(dimension);
      filter->SetMaxPointsPerLeaf(most);
      filter->UseCustomBoundsOn(); // The unit cube.
      const auto expected = TakeOutputs(filter.GetFilter());
      filter->SetInputData(MakePolyData(often));
      filter->MergePointsOn();
      ExpectSameOutputs(TakeOutputs(filter.GetFilter()), expected);
      filter->MergePointsOff();
      filter.Update();
      EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), static_cast<double>(often.size()) / 3);
    }
  }
}

TEST(TestHashedOctreeFilterBadInput, OddPlacesHaveTheirPlainOctree)
{
  const double least = std::numeric_limits<double>::denorm_min();
  const double large = std::numeric_limits<double>::max() / 4;
  std::vector<double> huge = MakeUniformPoints<3, double>(200, 45, -1e300, 1e300);
  std::vector<double> tiny = MakeUniformPoints<3, double>(200, 46, 0.0, 1e-310);
  std::vector<double> far = MakeUniformPoints<3, double>(200, 47, 1e6, 1e6 + 1e-9);
  std::vector<double> upperFaces;
  for (const double x : { 0.0, 1.0, 2.0, 3.0 })
  {
    for (const double y : { 0.0, 1.0, 2.0, 3.0 })
    {
      upperFaces.insert(upperFaces.end(), { x, y, 3.0, x, 3.0, y, 3.0, x, y, x, y, 1.0 });
    }
  }
  const PointSample<3, double> samples[] = { { "huge", huge }, { "denormal extent", tiny },
    { "box 1e-9 wide at 1e6", far }, { "points on all faces", upperFaces },
    { "the smallest extent", { 0, 0, 0, 0, 0, least, 0, least, 0 } },
    { "the largest extent", { -large, 0, 0, large, 1, 1, 1, large, -large } },
    { "the next double", { 1, 1, 1, std::nextafter(1.0, 2.0), 1, 1 } },
    { "far apart", { 0, 0, 0, 1e-300, 0, 0, 1e300, 0, 0 } } };
  for (const auto& sample : samples)
  {
    SCOPED_TRACE(sample.Name);
    TestedFilter filter(sample.Coordinates);
    filter->SetDimension(vtkHashedOctreeFilter::Three); // One is flat.
    for (const bool all : { false, true })
    {
      filter->SetIncludeEmptyLeaves(all);
      filter->SetIncludeInternalNodes(all);
      UpdateAndExpectOctree(filter, sample.Coordinates);
      EXPECT_EQ(filter.Warnings, std::vector<std::string>());
    }
  }
}

TEST(TestHashedOctreeFilterBadInput, CoordinatesWithoutAFiniteExtentAreSkipped)
{
  const double most = std::numeric_limits<double>::max();
  TestedFilter filter({ -most, 0, 0, most, 0, 0, 1, 2, 3, 4, 5, 6 });
  filter.Update();
  filter.ExpectWarning("2 of 4 points");
  ExpectOctree(filter, OracleOctree({ 1, 2, 3, 4, 5, 6 }));
}

TEST(TestHashedOctreeFilterBadInput, TooLittleMemoryIsAnError)
{
  if (Sanitized)
  {
    GTEST_SKIP() << "sanitizers reserve more memory than the limit";
  }
  TestedFilter filter(MakeUniformPoints<3, double>(100000, 48));
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false }, // A thread takes more.
    [&filter]
    {
      const MemoryLimit limit(Megabyte);
      filter->Update();
    });
  ASSERT_EQ(filter.Errors.size(), 1U);
  EXPECT_NE(filter.Errors[0].find("not enough memory"), std::string::npos) << filter.Errors[0];
  filter.ExpectEmptyOutputs();
  filter.Errors.clear();
  ExpectToWorkAgain(filter);
}
