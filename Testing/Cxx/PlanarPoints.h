// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_PlanarPoints_h
#define Testing_Cxx_PlanarPoints_h

#include "vtkHashedOctreeAlgorithm.h"

#include "NodeBox.h"
#include "SampleTree.h"

#include <array>
#include <cmath>
#include <vector>

/** A plane across an axis of space: which coordinates of space are its own. */
struct SpacePlane
{
  int Name; ///< One of vtkHashedOctreeAlgorithm::Planes.
  std::array<std::size_t, 2> Axes;
  std::size_t Across;
};
constexpr std::array<SpacePlane, 3> AllPlanes{ { { vtkHashedOctreeAlgorithm::XY, { 0, 1 }, 2 },
  { vtkHashedOctreeAlgorithm::YZ, { 1, 2 }, 0 }, { vtkHashedOctreeAlgorithm::XZ, { 0, 2 }, 1 } } };

/** Points of a plane, two coordinates each, in space. */
inline std::vector<double> PutInSpace(
  const std::vector<double>& planar, const SpacePlane& plane, double across)
{
  std::vector<double> coordinates(planar.size() / 2 * 3, across);
  for (std::size_t i = 0; i < planar.size(); ++i)
  {
    coordinates[i / 2 * 3 + plane.Axes[i % 2]] = planar[i];
  }
  return coordinates;
}

/** Of points in space, the coordinates that are those of a plane. */
inline std::vector<double> TakeFromSpace(
  const std::vector<double>& coordinates, const SpacePlane& plane)
{
  std::vector<double> planar;
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
  {
    planar.push_back(coordinates[i + plane.Axes[0]]);
    planar.push_back(coordinates[i + plane.Axes[1]]);
  }
  return planar;
}

/** The core's quadtree over points of a plane. */
inline SampleTree<2, double> MakeCoreQuadtree(const std::vector<double>& planar, int maxDepth = 21)
{
  return SampleTree<2, double>({ "planar", planar }, { 1, maxDepth });
}

/** Where the lower and the upper corner of a node are in space, by the bits of its key. */
inline std::array<std::array<double, 3>, 2> GetCornersInSpace(const hashedoctree::Octree<2>& tree,
  hashedoctree::MortonKey<2> key, const SpacePlane& plane, double across)
{
  const NodeBox<2> box(key);
  std::array<std::array<double, 3>, 2> corners;
  corners[0].fill(across);
  corners[1].fill(across);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double lower = tree.GetGrid().GetLower()[axis];
    const double side = tree.GetGrid().GetSide();
    corners[0][plane.Axes[axis]] =
      lower + side * std::ldexp(static_cast<double>(box.Lower[axis]), -31);
    corners[1][plane.Axes[axis]] =
      lower + side * std::ldexp(static_cast<double>(box.Upper[axis]), -31);
  }
  return corners;
}

#endif
