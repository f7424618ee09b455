// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_ExpectOctree_h
#define Testing_Cxx_ExpectOctree_h

#include "ExpectCells.h"
#include "ExpectTables.h"
#include "SameOutputs.h"

#include <vector>

inline void ExpectFieldData(TestedFilter& filter, const OracleOctree& expected)
{
  const int model = filter->GetFrequencyModel();
  const int startDepth = GetExpectedStartDepth(filter.GetFilter(), expected, model);
  const auto hitCost = static_cast<double>(expected.GetMeanCost(GetWeight(model), startDepth));
  const auto rootCost = static_cast<double>(expected.GetMeanCost(GetWeight(model), 0));
  const std::int64_t leaves = expected.Sum([](const auto&) { return 1; });
  const std::int64_t points =
    expected.Sum([](const auto& leaf) { return static_cast<std::int64_t>(leaf.Points.size()); });
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), startDepth);
  EXPECT_NEAR(filter.GetFieldValue("MeanHitCost") / hitCost, 1.0, 1e-12);
  EXPECT_NEAR(filter.GetFieldValue("MeanRootCost") / rootCost, 1.0, 1e-12);
  EXPECT_NEAR(filter.GetFieldValue("CostRatio") / (rootCost / hitCost), 1.0, 1e-12);
  EXPECT_EQ(filter.GetFieldValue("NumberOfPoints"), points);
  EXPECT_EQ(filter.GetFieldValue("NumberOfNodes"), expected.GetNodes().size());
  EXPECT_EQ(filter.GetFieldValue("NumberOfLeaves"), leaves);
  EXPECT_EQ(filter.GetFieldValue("NumberOfEmptyLeaves"),
    expected.Sum([](const auto& leaf) { return leaf.Points.empty(); }));
  EXPECT_EQ(filter.GetFieldValue("DeepestDepth"), expected.GetDeepestDepth());
  EXPECT_EQ(filter.GetFieldValue("StartDepthLeaves"),
    GetExpectedStartDepth(filter.GetFilter(), expected, vtkHashedOctreeFilter::Leaves));
  EXPECT_EQ(filter.GetFieldValue("StartDepthPoints"),
    GetExpectedStartDepth(filter.GetFilter(), expected, vtkHashedOctreeFilter::Points));
  EXPECT_EQ(filter.GetFieldValue("StartDepthGrid"),
    GetExpectedStartDepth(filter.GetFilter(), expected, vtkHashedOctreeFilter::Grid));
  EXPECT_GT(filter.GetFieldValue("BuildSeconds"), 0.0);
  // Of each internal node where the points of its children begin, at least, and two slots.
  const double internal = filter.GetFieldValue("NumberOfNodes") - static_cast<double>(leaves);
  EXPECT_GE(filter.GetFieldValue("TreeBytes"), (9 * 4 + 2 * 16) * internal);
  EXPECT_EQ(filter.GetFieldValue("Dimension"), 3);
  EXPECT_EQ(filter.GetCells()->GetFieldData()->GetNumberOfArrays(), 17);
  ExpectSameArrays(filter.GetHistogram()->GetFieldData(), filter.GetCells()->GetFieldData());
  ExpectSameArrays(filter.GetCosts()->GetFieldData(), filter.GetCells()->GetFieldData());
}

/** Everything that the filter says of its points, against the plain octree of the same points. */
inline void ExpectOctree(TestedFilter& filter, const OracleOctree& expected)
{
  ASSERT_NO_FATAL_FAILURE(ExpectCellArrays(filter, expected));
  if (filter->GetOutputType() == vtkHashedOctreeFilter::Outlines)
  {
    ExpectOutlines(filter, expected);
  }
  else
  {
    ExpectVoxels(filter, expected);
  }
  ExpectHistogram(filter.GetHistogram(), expected);
  ExpectCosts(filter.GetCosts(), expected);
  ExpectMark(
    filter.GetCosts(), filter.GetFieldValue("StartDepth"), filter.GetFieldValue("MeanHitCost"));
  ExpectFieldData(filter, expected);
}

/** Updates the filter and expects the plain octree of the points, which are its input's. */
inline void UpdateAndExpectOctree(TestedFilter& filter, const std::vector<double>& coordinates)
{
  ASSERT_NO_FATAL_FAILURE(filter.Update());
  ExpectOctree(filter,
    OracleOctree(
      coordinates, static_cast<std::size_t>(filter->GetMaxPointsPerLeaf()), filter->GetMaxDepth()));
}

#endif
