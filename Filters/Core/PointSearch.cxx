// SPDX-License-Identifier: BSD-3-Clause
#include "PointSearch.h"

#include "PointBoxWalk.h"
#include "PointCollectors.h"
#include "PointWalk.h"

#include <cmath>

namespace hashedoctree
{
namespace
{
template <int Dim>
bool IsFinite(const Position<Dim>& x)
{
  bool finite = true;
  for (const double coordinate : x)
  {
    finite &= std::isfinite(coordinate);
  }
  return finite;
}

template <int Dim, typename Real, typename Count>
bool FindClosestCounted(const PointTree<Dim, Real>& tree, const Position<Dim>& x, double radius2,
  FoundPoint& found, Count& count)
{
  if (!IsFinite<Dim>(x) || !(radius2 >= 0.0) || tree.GetNumberOfPoints() == 0)
  {
    return false;
  }
  ClosestOne closest(radius2);
  PointWalk<Dim, Real, ClosestOne, Count>(tree, x, closest, count).Search(1);
  if (closest.HasFound())
  {
    found = closest.GetBest();
  }
  return closest.HasFound();
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
  if (!IsFinite<Dim>(x) || count == 0 || this->Tree.GetNumberOfPoints() == 0)
  {
    return;
  }
  NoCount nodes;
  if (count <= ClosestFew::MostWanted)
  {
    ClosestFew closest(count);
    PointWalk<Dim, Real, ClosestFew, NoCount>(this->Tree, x, closest, nodes).Search(count);
    closest.CopyTo(found);
  }
  else
  {
    ClosestMany closest(count, found);
    PointWalk<Dim, Real, ClosestMany, NoCount>(this->Tree, x, closest, nodes).Search(count);
    closest.PutInOrder();
  }
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Position<Dim>& x, double radius, std::vector<FoundPoint>& found) const
{
  found.clear();
  if (!IsFinite<Dim>(x) || !(radius >= 0.0) || this->Tree.GetNumberOfPoints() == 0)
  {
    return;
  }
  AllMeasured within(radius * radius, found);
  NoCount nodes;
  PointWalk<Dim, Real, AllMeasured, NoCount>(this->Tree, x, within, nodes).Search(1);
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Box<Dim>& box, std::vector<std::uint32_t>& found) const
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
  const Position<Dim>& x, double radius, std::vector<std::uint32_t>& found) const
{
  found.clear();
  if (!IsFinite<Dim>(x) || !(radius >= 0.0) || this->Tree.GetNumberOfPoints() == 0)
  {
    return;
  }
  AllWithin within(radius * radius, found);
  NoCount nodes;
  PointWalk<Dim, Real, AllWithin, NoCount>(this->Tree, x, within, nodes).Search(1);
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
