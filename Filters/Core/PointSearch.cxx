// SPDX-License-Identifier: BSD-3-Clause
#include "PointSearch.h"

#include "ClosestFew.h"
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
bool FindClosestCounted(const PointTree<Dim, Real>& tree, const Position<Dim>& x, double radius2,
  FoundPoint& found, Count& count)
{
  if (!CanFind<Dim, Real>(tree, x) || !(radius2 >= 0.0))
  {
    return false;
  }
  ClosestOne closest(radius2, tree.GetKernels().Select);
  SearchPoints<Dim, Real>(tree, x, closest, count, 1);
  if (closest.HasFound())
  {
    found = closest.GetBest();
  }
  return closest.HasFound();
}

/** The points within a radius, by one of the two collectors. */
template <typename Collector, int Dim, typename Real, typename Found>
void FindAllWithin(const PointTree<Dim, Real>& tree, const Position<Dim>& x, double radius,
  std::vector<Found>& found)
{
  found.clear();
  if (CanFind<Dim, Real>(tree, x) && radius >= 0.0)
  {
    Collector within(radius * radius, found);
    NoCount nodes;
    SearchPoints<Dim, Real>(tree, x, within, nodes, 1);
  }
}
}

template <int Dim, typename Real>
bool PointSearch<Dim, Real>::FindClosest(
  const Position<Dim>& x, FoundPoint& found, double radius2) const
{
  NoCount count;
  return FindClosestCounted<Dim, Real>(this->Tree, x, radius2, found, count);
}

template <int Dim, typename Real>
std::uint64_t PointSearch<Dim, Real>::CountNodesForClosest(const Position<Dim>& x) const
{
  NodeCount count;
  FoundPoint found{};
  FindClosestCounted<Dim, Real>(
    this->Tree, x, std::numeric_limits<double>::infinity(), found, count);
  return count.Nodes;
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindClosest(
  const Position<Dim>& x, std::size_t count, std::vector<FoundPoint>& found) const
{
  found.clear();
  if (!CanFind<Dim, Real>(this->Tree, x) || count == 0)
  {
    return;
  }
  NoCount nodes;
  if (count <= ClosestFew::MostWanted)
  {
    ClosestFew closest(count, this->Tree.GetKernels().Select);
    SearchPoints<Dim, Real>(this->Tree, x, closest, nodes, count);
    closest.CopyTo(found);
  }
  else
  {
    ClosestMany closest(count, found);
    SearchPoints<Dim, Real>(this->Tree, x, closest, nodes, count);
    closest.PutInOrder();
  }
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Position<Dim>& x, double radius, std::vector<FoundPoint>& found) const
{
  FindAllWithin<AllMeasured, Dim, Real>(this->Tree, x, radius, found);
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(const Box<Dim>& box, std::vector<PointIndex>& found) const
{
  found.clear();
  bool isBox = this->Tree.GetNumberOfPoints() != 0;
  for (int axis = 0; axis < Dim; ++axis)
  {
    isBox &= box.Lower[axis] <= box.Upper[axis];
  }
  if (isBox)
  {
    PointBoxWalk<Dim, Real>(this->Tree, box, found).Search();
  }
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Position<Dim>& x, double radius, std::vector<PointIndex>& found) const
{
  FindAllWithin<AllWithin, Dim, Real>(this->Tree, x, radius, found);
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class PointSearch<Dim, float>;                                                          \
  template class PointSearch<Dim, double>;
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
