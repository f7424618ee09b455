// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_SortedPoints_h
#define Testing_Benchmarks_SortedPoints_h

#include "MortonOrder.h"

#include <algorithm>

/**
 * The points of a tree in Morton order, and the splitting of them into nodes by the paper's rule
 * (paper section 5; README, row 43): a node is split while it holds more than `maxPointsPerLeaf`
 * points and is not at MaxDepth; all its children are nodes, empty ones too. The trees that ours is
 * compared with are all built from it, with Core's own order and grid: so they have the same
 * leaves, and their build times differ by what their nodes cost.
 */
template <int Dim>
class SortedPoints
{
public:
  using Key = hashedoctree::MortonKey<Dim>;
  using Point = hashedoctree::KeyedPoint<Dim>;

  /** At least one point must be selected. O(n). */
  template <typename Real>
  SortedPoints(hashedoctree::PointSpan<Dim, Real> points,
    const hashedoctree::PointSelection<Dim>& selection, std::size_t maxPointsPerLeaf)
    : RootGrid(selection.GetBox())
    , Points(
        hashedoctree::MakeKeyedPoints(points, selection, this->RootGrid, hashedoctree::Execution()))
    , MaxPointsPerLeaf(static_cast<std::ptrdiff_t>(maxPointsPerLeaf))
  {
    hashedoctree::SortAlongMortonCurve(
      this->Points, maxPointsPerLeaf, Key::MaxDepth, hashedoctree::Execution());
  }

  const hashedoctree::Grid<Dim>& GetGrid() const { return this->RootGrid; }

  /**
   * Makes all nodes from `root` downwards, depth first: maker.MakeLeaf(node, points) where a node
   * is a leaf, with its first point, the others being those that follow within the leaf, or with
   * null; and maker.MakeChildren(node) where it is not, which returns what maker.GetChild(children,
   * octant) takes. O(nodes * log(points)).
   */
  template <typename Maker, typename Node>
  void Split(Maker& maker, Node root) const
  {
    const Point* first = this->Points.GetData();
    this->SplitNode(maker, root, first, first + this->Points.GetSize(), 0);
  }

private:
  template <typename Maker, typename Node>
  void SplitNode(Maker& maker, Node node, const Point* first, const Point* last, int depth) const
  {
    if (last - first <= this->MaxPointsPerLeaf || depth == Key::MaxDepth)
    {
      maker.MakeLeaf(node, first == last ? nullptr : first);
      return;
    }
    const auto children = maker.MakeChildren(node);
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      const Point* end = std::partition_point(first, last,
        [=](const Point& point)
        { return point.GetKey().AtDepth(depth + 1).GetOctant() <= octant; });
      this->SplitNode(maker, maker.GetChild(children, octant), first, end, depth + 1);
      first = end;
    }
  }

  hashedoctree::Grid<Dim> RootGrid;
  hashedoctree::Buffer<Point> Points;
  std::ptrdiff_t MaxPointsPerLeaf;
};

#endif
