// SPDX-License-Identifier: BSD-3-Clause
#ifndef QueryArrays_h
#define QueryArrays_h

#include "PointsAdaptor.h"
#include "SearchComparison.h"

class vtkDataSet;

namespace hashedoctree
{
/**
 * Searches in the tree for the points of a data set, and adds to it what is found and what each
 * search examines: the point arrays LeafId, LeafDepth, LeafKey, HitCost (active), RootCost,
 * MedianCost, MeanCost, LocalCost and DecisionTreeCost of vtkHashedOctreeLocateFilter. Returns the
 * nodes that each search examines for all finite points together. Throws Interrupted, with a data
 * set that must be emptied. The same whatever the threads. Private to the module.
 */
SearchComparison<3>::Costs AddQueryArrays(vtkDataSet* queries, const PointsAdaptor& points,
  const Octree<3>& tree, EmptyOctants reading, const SearchComparison<3>& searches,
  const Execution& execution);
}

#endif
