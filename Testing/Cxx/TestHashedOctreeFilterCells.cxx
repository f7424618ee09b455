// SPDX-License-Identifier: BSD-3-Clause
#include "ExpectOctree.h"
#include "PointSamples.h"
#include "SameOutputs.h"

#include "vtkBoundingBox.h"

#include <random>

namespace
{
/** Calls function() for all combinations of leaves without points and internal nodes. */
template <typename Function>
void ForAllSelections(TestedFilter& filter, const Function& function)
{
  for (const bool emptyLeaves : { false, true })
  {
    for (const bool internalNodes : { false, true })
    {
      SCOPED_TRACE(std::string(emptyLeaves ? "" : "no ") + "empty leaves, " +
        (internalNodes ? "" : "no ") + "internal nodes");
      filter->SetIncludeEmptyLeaves(emptyLeaves);
      filter->SetIncludeInternalNodes(internalNodes);
      function();
    }
  }
}
}

TEST(TestHashedOctreeFilterCells, VoxelsAreThoseOfThePlainOctree)
{
  for (const auto& sample : MakeFinitePointSamples<3, double>())
  {
    SCOPED_TRACE(sample.Name);
    TestedFilter filter(sample.Coordinates);
    filter->SetDimension(vtkHashedOctreeFilter::Three); // One is flat.
    ForAllSelections(filter, [&] { UpdateAndExpectOctree(filter, sample.Coordinates); });
  }
}

TEST(TestHashedOctreeFilterCells, OutlinesAreThoseOfThePlainOctree)
{
  // In samples where all corners of a node have positions of their own.
  for (const auto& coordinates : { MakeUniformPoints<3, double>(300, 5),
         MakeSpherePoints<3, double>(300, 6), MakeClusteredPoints<3, double>(300, 7) })
  {
    TestedFilter filter(coordinates);
    filter->SetOutputType(vtkHashedOctreeFilter::Outlines);
    ForAllSelections(filter, [&] { UpdateAndExpectOctree(filter, coordinates); });
  }
}

TEST(TestHashedOctreeFilterCells, OutlinesHaveTheArraysAndCornersOfVoxels)
{
  for (const auto& sample : MakeFinitePointSamples<3, double>())
  {
    SCOPED_TRACE(sample.Name);
    TestedFilter voxels(sample.Coordinates);
    TestedFilter outlines(sample.Coordinates);
    outlines->SetOutputType(vtkHashedOctreeFilter::Outlines);
    voxels.Update();
    outlines.Update();
    ExpectSameArrays(voxels.GetCells()->GetCellData(), outlines.GetCells()->GetCellData());
    ExpectSameArrays(voxels.GetCells()->GetFieldData(), outlines.GetCells()->GetFieldData());
    EXPECT_EQ(voxels.GetCells()->GetNumberOfPoints(), outlines.GetCells()->GetNumberOfPoints());
    EXPECT_STREQ(outlines.GetCells()->GetCellData()->GetScalars()->GetName(), "Depth");
  }
}

TEST(TestHashedOctreeFilterCells, EachLeafHoldsItsPointsAndNoOthers)
{
  for (const auto& coordinates :
    { MakeUniformPoints<3, double>(200, 8), MakeSpherePoints<3, double>(200, 9) })
  {
    TestedFilter filter(coordinates);
    filter->SetMaxPointsPerLeaf(3);
    filter->IncludeEmptyLeavesOn();
    filter.Update();
    std::vector<int> leavesOfPoint(coordinates.size() / 3, 0);
    for (vtkIdType cell = 0; cell < filter.GetCells()->GetNumberOfCells(); ++cell)
    {
      double box[6];
      filter.GetCells()->GetCellBounds(cell, box);
      int inside = 0;
      for (std::size_t i = 0; i < leavesOfPoint.size(); ++i)
      {
        const double* x = coordinates.data() + 3 * i;
        if (x[0] >= box[0] && x[0] <= box[1] && x[1] >= box[2] && x[1] <= box[3] &&
          x[2] >= box[4] && x[2] <= box[5])
        {
          ++inside;
          ++leavesOfPoint[i];
        }
      }
      ASSERT_EQ(filter.GetCells()->GetCellData()->GetArray("PointCount")->GetTuple1(cell), inside);
    }
    // Random points do not lie on the faces between leaves.
    EXPECT_EQ(leavesOfPoint, std::vector<int>(leavesOfPoint.size(), 1));
  }
}

TEST(TestHashedOctreeFilterCells, LeavesAddUpToTheRoot)
{
  for (const auto& sample : MakeFinitePointSamples<3, double>())
  {
    if (sample.Name == "far offset") // Its leaves are smaller than the doubles there can tell.
    {
      continue;
    }
    SCOPED_TRACE(sample.Name);
    TestedFilter filter(sample.Coordinates);
    filter->SetDimension(vtkHashedOctreeFilter::Three);
    filter->IncludeEmptyLeavesOn();
    filter.Update();
    const double side = OracleOctree(sample.Coordinates).GetRootSide();
    double volume = 0.0; // In roots.
    vtkBoundingBox all;
    for (vtkIdType cell = 0; cell < filter.GetCells()->GetNumberOfCells(); ++cell)
    {
      double box[6];
      filter.GetCells()->GetCellBounds(cell, box);
      volume += (box[1] - box[0]) / side * ((box[3] - box[2]) / side) * ((box[5] - box[4]) / side);
      all.AddBounds(box);
    }
    EXPECT_NEAR(volume, 1.0, 1e-9);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(all.GetLength(axis) / side, 1.0, 1e-9);
    }
  }
}

TEST(TestHashedOctreeFilterCells, DoNotDependOnTheOrderOfThePoints)
{
  std::vector<double> coordinates = MakeClusteredPoints<3, double>(2000, 10);
  TestedFilter filter(coordinates);
  filter->SetMaxPointsPerLeaf(2);
  const auto outputs = TakeOutputs(filter.GetFilter());
  std::mt19937_64 random(11);
  for (std::size_t last = coordinates.size() / 3 - 1; last > 0; --last)
  {
    const std::size_t other = random() % (last + 1);
    std::swap_ranges(coordinates.begin() + static_cast<std::ptrdiff_t>(3 * last),
      coordinates.begin() + static_cast<std::ptrdiff_t>(3 * last + 3),
      coordinates.begin() + static_cast<std::ptrdiff_t>(3 * other));
  }
  filter->SetInputData(MakePolyData(coordinates));
  ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
}
