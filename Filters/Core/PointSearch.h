// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointSearch_h
#define hashedoctree_PointSearch_h

#include "PointTree.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace hashedoctree
{
/** A point that a search found: its id in the data set, and its squared distance in world units. */
struct FoundPoint
{
  double Dist2;
  PointIndex Id;

  /** Nearer first, equally near ones by id. */
  friend bool operator<(const FoundPoint& a, const FoundPoint& b)
  {
    return a.Dist2 != b.Dist2 ? a.Dist2 < b.Dist2 : a.Id < b.Id;
  }
};

/**
 * Searches for points, exact and deterministic: what is found depends on the points and the
 * position only, never on the start depth. Distances are computed in double as the sum of squared
 * differences, axis by axis in order; of equally near points the one with the smallest id wins.
 *
 * A search begins at the leaf of the position, which it finds from the start depth. A ball around
 * the position that reaches further is covered by the at most 2^Dim cells of the deepest depth
 * whose cells are as wide as the ball, or by one cell that is hardly larger. They are reached
 * directly through the table, and only they are descended into, past the boxes of their children.
 * From start depth 0 it is the classical search, down from the root without the table. A ball that
 * is given from the start is first looked up in the tree's free space (FreeSpace.h), and is done
 * where that holds it; closest points of a position in free space are searched for from the root.
 *
 * Positions may lie anywhere; one that is not finite has no points near it. All members are thread
 * safe. Mean cost of the closest point is O(1) near the points, about O(depth * 2^Dim) far from
 * them.
 */
template <int Dim, typename Real>
class PointSearch
{
public:
  /** The tree, which says where searches start, must outlive the search. */
  explicit PointSearch(const PointTree<Dim, Real>& tree)
    : Tree(tree)
  {
  }

  /** The closest point within a squared radius, on it included. Returns false, and leaves `found`
   * alone, when there is none, the radius is negative, or it or the position is not a number. */
  bool FindClosest(const Position<Dim>& x, FoundPoint& found,
    double radius2 = std::numeric_limits<double>::infinity()) const;

  /** The `count` closest points in order, or all where there are fewer. `found` is replaced. */
  void FindClosest(const Position<Dim>& x, std::size_t count, std::vector<FoundPoint>& found) const;

  /** The points with squared distances of at most radius * radius, in an order that depends on the
   * points, the position and the start depths. `found` is replaced. No point for a radius that is
   * negative or no number. */
  void FindWithin(const Position<Dim>& x, double radius, std::vector<PointIndex>& found) const;

  /** The same with their squared distances. */
  void FindWithin(const Position<Dim>& x, double radius, std::vector<FoundPoint>& found) const;

  /** The points in a box, those on its faces included, in an order that depends on the points and
   * the box only. `found` is replaced. No point for a box whose upper corner lies below its lower
   * one, or with a corner that is no number; corners may be infinite. */
  void FindWithin(const Box<Dim>& box, std::vector<PointIndex>& found) const;

  ///@{
  /** How many nodes these searches examine: looks into the table, and blocks whose children they
   * measure, all of which count as one. Searches that do not count are not slowed by it. */
  std::uint64_t CountNodesForClosest(const Position<Dim>& x) const;
  std::uint64_t CountNodesForClosest(const Position<Dim>& x, std::size_t count) const;
  std::uint64_t CountNodesForWithin(const Position<Dim>& x, double radius) const;
  std::uint64_t CountNodesForWithin(const Box<Dim>& box) const;
  ///@}

private:
  const PointTree<Dim, Real>& Tree;
};
}

#endif
