// SPDX-License-Identifier: BSD-3-Clause
#ifndef OctreeCells_h
#define OctreeCells_h

#include "Octree.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace hashedoctree
{
/**
 * Nodes of an octree as VTK cells, one cell each in the order of the list, with shared corners in
 * double precision and the cell arrays Depth (active), HitCost, RootCost, PointCount and MortonKey.
 * HitCost and RootCost are the nodes that a counted search for the leaf examines from `startDepth`
 * and from the root; 0 on internal nodes, which no search ends at. The tree and the list must
 * outlive it. Both outputs throw Interrupted, and must then be emptied. Private to the module.
 */
class OctreeCells
{
public:
  using Nodes = Buffer<Octree<3>::Node>;

  OctreeCells(const Octree<3>& tree, int startDepth, const Nodes& nodes)
    : Tree(tree)
    , StartDepth(startDepth)
    , Listed(nodes)
  {
  }

  /** One VTK_VOXEL for each node. */
  void MakeVoxels(vtkUnstructuredGrid* output, const Execution& execution) const;
  /** One VTK_POLY_LINE of 16 points for each node, along all edges of its box. */
  void MakeOutlines(vtkPolyData* output, const Execution& execution) const;

private:
  template <typename IdArray>
  void FillVoxels(vtkUnstructuredGrid* output, const Execution& execution) const;
  template <typename IdArray>
  void FillOutlines(vtkPolyData* output, const Execution& execution) const;
  template <typename DataSet>
  void AddArrays(DataSet* output, const Execution& execution) const;

  const Octree<3>& Tree;
  int StartDepth;
  const Nodes& Listed;
};
}

#endif
