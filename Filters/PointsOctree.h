// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointsOctree_h
#define PointsOctree_h

#include "Octree.h"
#include "TreeFrame.h"

#include <variant>

namespace hashedoctree
{
/** The octree or quadtree over the points of one data set, and what became of the points that are
 * not in it. Private to the module. */
template <int Dim>
struct PointsOctree
{
  Octree<Dim> Tree;
  TreeFrame<Dim> Frame;
  std::size_t SkippedPoints = 0; ///< Not finite, or too large.
  std::size_t OutsidePoints = 0; ///< Outside the given root.
  double BuildSeconds = 0.0;
};

using AnyPointsOctree = std::variant<PointsOctree<2>, PointsOctree<3>>;
}

#endif
