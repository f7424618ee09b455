// SPDX-License-Identifier: BSD-3-Clause
#ifndef QuadtreeFrame_h
#define QuadtreeFrame_h

#include "TreeFrame.h"

#include <optional>

class vtkHashedOctreeAlgorithm;

namespace hashedoctree
{
/** The frame of the quadtree that the properties Dimension and Plane ask for over points with this
 * box, in the plane through its lower corner; nothing where they ask for an octree. Private to the
 * module. */
std::optional<TreeFrame<2>> FindQuadtreeFrame(
  vtkHashedOctreeAlgorithm* algorithm, const Box<3>& box);
}

#endif
