// SPDX-License-Identifier: BSD-3-Clause
#ifndef OctreeTables_h
#define OctreeTables_h

#include "DepthStatistics.h"
#include "MeasuredCost.h"

#include "vtkTable.h"

#include <vector>

namespace hashedoctree
{
/** Fills the columns Depth, Leaves, EmptyLeaves, Points (integers) and GridWeight (double; the
 * leaves' volume in cells of the deepest depth), one row for each depth from 0 to the deepest of a
 * tree in `dimension` dimensions. Private to the module. */
void FillDepthHistogram(vtkTable* table, const DepthCounts& counts, int dimension);

/** Fills the columns StartDepth, CostLeaves, CostPoints, CostGrid (modelled), MeasuredLeaves,
 * MeasuredPoints (counted) and ContinuousLeaves (the differentiable cost at StartDepth + 1/2, paper
 * E8): mean nodes examined by one search, one row for each start depth from 0 to the deepest, and
 * to 1 at least, of a tree in `dimension` dimensions. Private to the module. */
void FillCostCurves(
  vtkTable* table, const DepthCounts& counts, const MeasuredCost& measured, int dimension);

/** Adds the column MeanHitCost to cost curves: `meanHitCost` in the row of `startDepth`, if there
 * is one, and NaN in all others, so that a chart draws it as a mark. Private to the module. */
void MarkStartDepth(vtkTable* costs, int startDepth, double meanHitCost);

/** What one way to search costs: mean nodes that a search examines. */
struct SearchRow
{
  const char* Model;
  int StartDepth;
  double PredictedMean;
  double MeasuredMean;
};

/** Fills the columns Model (string), StartDepth (integer), PredictedMean and MeasuredMean, one row
 * for each of the given. Private to the module. */
void FillSearchTable(vtkTable* table, const std::vector<SearchRow>& rows);
}

#endif
