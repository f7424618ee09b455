// SPDX-License-Identifier: BSD-3-Clause
#include "Octree.h"

#include "ForEachDimension.h"
#include "MortonOrder.h"
#include "OctreeBuilder.h"
#include "PlaneSpan.h"

#include <cassert>

namespace hashedoctree
{
namespace
{
/** Shares of the progress: of all, and of what is done with the keys. */
constexpr double KeysShare = 0.2;
constexpr double NumberingShare = 0.05; // Of keys that are given.
constexpr double SortingShare = 0.375;
}

template <int Dim>
template <typename Points>
Octree<Dim>::Octree(Points points, const PointSelection<Dim>& selection, const Options& options,
  const Execution& execution, SpareMemory spare)
  : BuildOptions(options)
{
  if (selection.GetNumberOfPoints() == 0)
  {
    return;
  }
  this->RootGrid = Grid<Dim>(selection.GetBox());
  Buffer<KeyedPoint<Dim>> keyed =
    MakeKeyedPoints(points, selection, this->RootGrid, execution.Part(0.0, KeysShare));
  this->Build(keyed, execution.Part(KeysShare, 1.0), spare);
}

template <int Dim>
Octree<Dim>::Octree(const Grid<Dim>& grid, const std::vector<Key>& keys, const Options& options,
  const Execution& execution)
  : RootGrid(grid)
  , BuildOptions(options)
{
  if (keys.empty())
  {
    return;
  }
  Buffer<KeyedPoint<Dim>> keyed = NumberKeys(keys, execution.Part(0.0, NumberingShare));
  this->Build(keyed, execution.Part(NumberingShare, 1.0), {});
}

template <int Dim>
void Octree<Dim>::Build(
  Buffer<KeyedPoint<Dim>>& points, const Execution& execution, SpareMemory spare)
{
  assert(this->BuildOptions.AreInRange());
  SortAlongMortonCurve(points, this->BuildOptions.MaxPointsPerLeaf, this->BuildOptions.MaxDepth,
    execution.Part(0.0, SortingShare), spare);
  OctreeBuilder<Dim>(*this, points).Build(execution.Part(SortingShare, 1.0));
}

template <int Dim>
std::size_t Octree<Dim>::GetNumberOfLeaves() const
{
  return GetTotal(this->Counts.Leaves);
}

template <int Dim>
std::size_t Octree<Dim>::GetNumberOfEmptyLeaves() const
{
  return GetTotal(this->Counts.EmptyLeaves);
}

template <int Dim>
typename Octree<Dim>::Node Octree<Dim>::GetRoot() const
{
  return Node{ Key::Root(), 0, static_cast<PointIndex>(this->GetNumberOfPoints()),
    this->IsRootInternal() };
}

template <int Dim>
std::optional<typename Octree<Dim>::Node> Octree<Dim>::FindNode(Key key, EmptyOctants reading) const
{
  std::optional<Node> node;
  if (key == Key::Root())
  {
    node = this->GetRoot();
  }
  else if (key.GetParent() != Key()) // which no table knows
  {
    if (const Entry* parent = this->Table.Find(key.GetParent().GetValue()))
    {
      node = this->GetChild(parent->Block, key.GetOctant());
    }
  }
  if (node && node->IsEmpty() && reading == EmptyOctants::Missing)
  {
    node.reset();
  }
  return node;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class Octree<Dim>;                                                                      \
  template Octree<Dim>::Octree(PointSpan<Dim, float>, const PointSelection<Dim>&,                  \
    const Octree<Dim>::Options&, const Execution&, SpareMemory);                                   \
  template Octree<Dim>::Octree(PointSpan<Dim, double>, const PointSelection<Dim>&,                 \
    const Octree<Dim>::Options&, const Execution&, SpareMemory);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
template Octree<2>::Octree(PlaneSpan<float>, const PointSelection<2>&, const Octree<2>::Options&,
  const Execution&, SpareMemory);
template Octree<2>::Octree(PlaneSpan<double>, const PointSelection<2>&, const Octree<2>::Options&,
  const Execution&, SpareMemory);
}
