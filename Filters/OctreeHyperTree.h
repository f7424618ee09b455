// SPDX-License-Identifier: BSD-3-Clause
#ifndef OctreeHyperTree_h
#define OctreeHyperTree_h

#include "PointsOctree.h"

#include "vtkHyperTreeGrid.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace hashedoctree
{
/** VTK numbers the vertices of a hyper tree by 32 bits; the last number stands for none. */
constexpr std::size_t MaxNumberOfHyperTreeVertices = std::numeric_limits<std::uint32_t>::max();

/** Children of a node along each axis. */
constexpr unsigned BranchFactor = 2;

/** Throws std::length_error, with what to tell the user, for more nodes than can be vertices. */
inline void RequireHyperTreeVertices(std::size_t nodes)
{
  if (nodes > MaxNumberOfHyperTreeVertices)
  {
    throw std::length_error(
      "The tree has more nodes than a vtkHyperTreeGrid can hold; choose Voxels "
      "or Outlines, or allow more points per leaf or less depth.");
  }
}

/**
 * An octree or quadtree as a vtkHyperTreeGrid with a single tree, whose vertices are all of its
 * nodes, with the arrays of AddNodeArrays() for searches from `startDepth`. Vertex 0 is the root;
 * the children of the internal nodes follow in the order of these, by depth, then by key, of each
 * in VTK's own order, in which the first axis is the low bit. Leaves without points are masked
 * unless they are shown, and all that are not in the tree's part of the curve. O(nodes); the tree
 * itself on one thread. Throws Interrupted, and std::length_error for too many nodes; the grid must
 * then be emptied. Instantiated for 2 and 3 dimensions. Private to the module.
 */
template <int Dim>
void FillHyperTreeGrid(const PointsOctree<Dim>& octree, int startDepth, bool showsEmptyLeaves,
  vtkHyperTreeGrid* output, const Execution& execution);

/** Gives what a data object holds to another of its type. As ShallowCopy(), but that a hyper tree
 * grid loses its mask to the other: to copy one that has a mask VTK visits all of its nodes, for
 * seconds and heeding no abort. (Whoever copies the other next has that to wait for.) */
void HandOver(vtkDataObject* from, vtkDataObject* to);
}

#endif
