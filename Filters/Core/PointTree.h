// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointTree_h
#define hashedoctree_PointTree_h

#include "DistanceKernels.h"
#include "Octree.h"

namespace hashedoctree
{
/**
 * An octree with what searches for points need beside it: the points in Morton order, in the
 * precision of the input, and the tight box of every child. The input may go away
 * once the tree is built. Immutable once built; const members may be called from many threads at
 * once.
 */
template <int Dim, typename Real>
class PointTree
{
public:
  using Options = typename Octree<Dim>::Options;

  /** The tree of no points. */
  PointTree() = default;

  /** Of the selected points; O(n). Throws as Octree does. */
  PointTree(PointSpan<Dim, Real> points, const PointSelection<Dim>& selection,
    const Options& options, const Execution& execution);

  const Octree<Dim>& GetOctree() const { return this->Tree; }
  std::size_t GetNumberOfPoints() const { return this->Tree.GetNumberOfPoints(); }
  /** Coordinates of the points of a leaf, given where its range begins: axis after axis, so that
   * the points of a leaf are near each other in memory and of one kind in a vector. */
  const Real* GetLeafCoordinates(std::uint32_t firstPoint) const
  {
    return this->Coordinates.GetData() + Dim * static_cast<std::size_t>(firstPoint);
  }
  const std::uint32_t* GetIds() const { return this->Tree.GetPointIds(); }
  const ChildBoxes<Dim>& GetChildBoxes(std::size_t block) const { return this->Boxes[block]; }

  /** Bytes of all of it: tree, order, boxes and coordinates. */
  std::size_t GetBytes() const
  {
    return this->Tree.GetTreeBytes() + this->Tree.GetOrderBytes() + this->Boxes.GetBytes() +
      this->Coordinates.GetBytes();
  }

private:
  void CopyCoordinates(PointSpan<Dim, Real> points, const Execution& execution);
  void CopyLeaf(PointSpan<Dim, Real> points, std::uint32_t firstPoint, std::uint32_t lastPoint);
  void MeasureBoxes(const Execution& execution);
  std::size_t FindFirstBlockAt(int depth) const;

  Octree<Dim> Tree;
  Buffer<Real> Coordinates;
  Buffer<ChildBoxes<Dim>> Boxes;
};
}

#endif
