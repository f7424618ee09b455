// SPDX-License-Identifier: BSD-3-Clause
#ifndef QueryArrays_h
#define QueryArrays_h

#include "LeafNumbers.h"
#include "PointsAdaptor.h"
#include "PointsOctree.h"
#include "SearchComparison.h"

#include "vtkDataSet.h"

namespace hashedoctree
{
/**
 * Searches in the tree for the points of a data set, and adds to it what is found and what each
 * search examines: the point arrays LeafId, LeafDepth, LeafKey, HitCost (active), RootCost,
 * MedianCost, MeanCost, LocalCost and DecisionTreeCost of vtkHashedOctreeLocateFilter. Returns the
 * nodes that each search examines for all finite points together. `numbers` are the leaves' in the
 * reading that queries are searched for in. Throws Interrupted, with a data set that must be
 * emptied. The same whatever the threads. Instantiated for 2 and 3 dimensions. Private to the
 * module.
 */
template <int Dim>
typename SearchComparison<Dim>::Costs AddQueryArrays(vtkDataSet* queries,
  const PointsAdaptor& points, const PointsOctree<Dim>& octree, const LeafNumbers<Dim>& numbers,
  const SearchComparison<Dim>& searches, const Execution& execution);
}

#endif
