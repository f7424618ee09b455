// SPDX-License-Identifier: BSD-3-Clause
#ifndef OctreeCells_h
#define OctreeCells_h

#include "Octree.h"
#include "TreeFrame.h"

#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace hashedoctree
{
/**
 * Nodes of an octree or quadtree as VTK cells, one cell each in the order of the list, with shared
 * corners in double precision and the arrays of AddNodeArrays() for searches from `startDepth`. The
 * first `apart` nodes share no corners with others; theirs come last. The tree and the list must
 * outlive it. Both outputs throw Interrupted, and must then be emptied. Instantiated for 2 and 3
 * dimensions. Private to the module.
 */
template <int Dim>
class OctreeCells
{
public:
  using Nodes = Buffer<typename Octree<Dim>::Node>;

  OctreeCells(const Octree<Dim>& tree, int startDepth, const Nodes& nodes,
    const TreeFrame<Dim>& frame = TreeFrame<Dim>(), std::size_t apart = 0)
    : Tree(tree)
    , StartDepth(startDepth)
    , Listed(nodes)
    , Frame(frame)
    , Apart(apart)
  {
  }

  /** One VTK_VOXEL for each node of an octree, one VTK_PIXEL of a quadtree. */
  void MakeVoxels(vtkUnstructuredGrid* output, const Execution& execution) const;
  /** One VTK_POLY_LINE for each node, along all edges of its box (16 points) or square (5). */
  void MakeOutlines(vtkPolyData* output, const Execution& execution) const;

private:
  template <typename IdArray>
  void FillVoxels(vtkUnstructuredGrid* output, const Execution& execution) const;
  template <typename IdArray>
  void FillOutlines(vtkPolyData* output, const Execution& execution) const;

  const Octree<Dim>& Tree;
  int StartDepth;
  const Nodes& Listed;
  TreeFrame<Dim> Frame;
  std::size_t Apart;
};
}

#endif
