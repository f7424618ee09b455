// SPDX-License-Identifier: BSD-3-Clause
#include "PointSearch.h"

#include "ClosestFew.h"
#include "ForEachDimension.h"
#include "PointBoxWalk.h"
#include "PointCollectors.h"
#include "PointWalk.h"

namespace hashedoctree
{
namespace
{
/** Whether anything can be near a position. */
template <int Dim, typename Real>
bool CanFind(const PointTree<Dim, Real>& tree, const Position<Dim>& x)
{
  return IsFinite(x) && tree.GetNumberOfPoints() != 0;
}

template <int Dim, typename Real, typename Count>
bool FindClosestOne(const PointTree<Dim, Real>& tree, const Position<Dim>& x, double radius2,
  FoundPoint& found, Count& nodes)
{
  if (!CanFind<Dim, Real>(tree, x) || !(radius2 >= 0.0))
  {
    return false;
  }
  ClosestOne closest(radius2, tree.GetPointKernels().Select);
  SearchPoints<Dim, Real>(tree, x, closest, nodes, 1);
  if (closest.HasFound())
  {
    found = closest.GetBest();
  }
  return closest.HasFound();
}

template <int Dim, typename Real, typename Count>
void FindClosestPoints(const PointTree<Dim, Real>& tree, const Position<Dim>& x, std::size_t count,
  std::vector<FoundPoint>& found, Count& nodes)
{
  found.clear();
  if (!CanFind<Dim, Real>(tree, x) || count == 0)
  {
    return;
  }
  if (count <= ClosestFew::MostWanted)
  {
    ClosestFew closest(count, tree.GetPointKernels().Select);
    SearchPoints<Dim, Real>(tree, x, closest, nodes, count);
    closest.CopyTo(found);
  }
  else
  {
    ClosestMany closest(count, found);
    SearchPoints<Dim, Real>(tree, x, closest, nodes, count);
    closest.PutInOrder();
  }
}

/** Hands the points within a radius to a collector. */
template <typename Collector, int Dim, typename Real, typename Count>
void FindAllWithin(const PointTree<Dim, Real>& tree, const Position<Dim>& x, double radius,
  Collector within, Count& nodes)
{
  if (CanFind<Dim, Real>(tree, x) && radius >= 0.0)
  {
    SearchPoints<Dim, Real>(tree, x, within, nodes, 1);
  }
}

template <int Dim, typename Real, typename Count>
void FindAllWithin(const PointTree<Dim, Real>& tree, const Position<Dim>& x, double radius,
  std::vector<PointIndex>& found, Count& nodes)
{
  found.clear();
  FindAllWithin<AllWithin, Dim, Real>(
    tree, x, radius, { radius * radius, found, tree.GetPointKernels().CopySelected }, nodes);
}

template <int Dim, typename Real, typename Count>
void FindAllWithin(const PointTree<Dim, Real>& tree, const Box<Dim>& box,
  std::vector<PointIndex>& found, Count& nodes)
{
  found.clear();
  bool isBox = tree.GetNumberOfPoints() != 0;
  for (int axis = 0; axis < Dim; ++axis)
  {
    isBox &= box.Lower[axis] <= box.Upper[axis];
  }
  if (isBox)
  {
    PointBoxWalk<Dim, Real, Count>(tree, box, found, nodes).Search();
  }
}
}

template <int Dim, typename Real>
bool PointSearch<Dim, Real>::FindClosest(
  const Position<Dim>& x, FoundPoint& found, double radius2) const
{
  NoCount nodes;
  return FindClosestOne<Dim, Real>(this->Tree, x, radius2, found, nodes);
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindClosest(
  const Position<Dim>& x, std::size_t count, std::vector<FoundPoint>& found) const
{
  NoCount nodes;
  FindClosestPoints<Dim, Real>(this->Tree, x, count, found, nodes);
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Position<Dim>& x, double radius, std::vector<FoundPoint>& found) const
{
  NoCount nodes;
  found.clear();
  FindAllWithin<AllMeasured, Dim, Real>(this->Tree, x, radius, { radius * radius, found }, nodes);
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Position<Dim>& x, double radius, std::vector<PointIndex>& found) const
{
  NoCount nodes;
  FindAllWithin<Dim, Real>(this->Tree, x, radius, found, nodes);
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(const Box<Dim>& box, std::vector<PointIndex>& found) const
{
  NoCount nodes;
  FindAllWithin<Dim, Real>(this->Tree, box, found, nodes);
}

template <int Dim, typename Real>
std::uint64_t PointSearch<Dim, Real>::CountNodesForClosest(const Position<Dim>& x) const
{
  NodeCount nodes;
  FoundPoint found{};
  FindClosestOne<Dim, Real>(this->Tree, x, std::numeric_limits<double>::infinity(), found, nodes);
  return nodes.Nodes;
}

template <int Dim, typename Real>
std::uint64_t PointSearch<Dim, Real>::CountNodesForClosest(
  const Position<Dim>& x, std::size_t count) const
{
  NodeCount nodes;
  std::vector<FoundPoint> found;
  FindClosestPoints<Dim, Real>(this->Tree, x, count, found, nodes);
  return nodes.Nodes;
}

template <int Dim, typename Real>
std::uint64_t PointSearch<Dim, Real>::CountNodesForWithin(
  const Position<Dim>& x, double radius) const
{
  NodeCount nodes;
  std::vector<PointIndex> found;
  FindAllWithin<Dim, Real>(this->Tree, x, radius, found, nodes);
  return nodes.Nodes;
}

template <int Dim, typename Real>
std::uint64_t PointSearch<Dim, Real>::CountNodesForWithin(const Box<Dim>& box) const
{
  NodeCount nodes;
  std::vector<PointIndex> found;
  FindAllWithin<Dim, Real>(this->Tree, box, found, nodes);
  return nodes.Nodes;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class PointSearch<Dim, float>;                                                          \
  template class PointSearch<Dim, double>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
