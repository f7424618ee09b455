// SPDX-License-Identifier: BSD-3-Clause
#ifndef NodeArrays_h
#define NodeArrays_h

#include "Octree.h"

#include "vtkCellData.h"

namespace hashedoctree
{
/**
 * Adds to the data of cells, which stand for nodes of an octree or quadtree in the order of a list,
 * the arrays Depth (active), HitCost, RootCost, PointCount and MortonKey. HitCost and RootCost are
 * the nodes that a counted search for the leaf examines from `startDepth` and from the root; 0 on
 * internal nodes, which no search ends at. O(nodes). Throws Interrupted. Instantiated for 2 and 3
 * dimensions. Private to the module.
 */
template <int Dim>
void AddNodeArrays(const Octree<Dim>& tree, int startDepth,
  const Buffer<typename Octree<Dim>::Node>& nodes, vtkCellData* cellData,
  const Execution& execution);

/** Whether cells have these arrays, so that their points are corners of nodes. */
bool HaveNodeArrays(vtkCellData* cellData);
}

#endif
