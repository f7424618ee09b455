// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointBoxWalk_h
#define hashedoctree_PointBoxWalk_h

#include "BlockSearch.h"
#include "PointTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace hashedoctree
{
/**
 * One search for the points in a box, faces included: down from the smallest node that holds the
 * box, reached directly, past children whose tight boxes lie outside, taking those inside as a
 * whole. Private to PointSearch.cxx.
 */
template <int Dim, typename Real, typename Count>
class PointBoxWalk
{
public:
  PointBoxWalk(const PointTree<Dim, Real>& tree, const Box<Dim>& box,
    std::vector<PointIndex>& found, Count& count)
    : Tree(tree)
    , Nodes(tree.GetOctree())
    , Wanted(box)
    , Found(found)
    , Examined(count)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Before[axis] = this->GetPlaceBeside(box.Lower[axis], axis, -infinity);
      this->Lower[axis] = BeforeEnd(this->GetPlace(box.Lower[axis], axis));
      this->Upper[axis] = this->GetPlace(box.Upper[axis], axis);
      this->Behind[axis] = BeforeEnd(this->GetPlaceBeside(box.Upper[axis], axis, infinity));
    }
  }

  void Search()
  {
    if (!this->Nodes.IsRootInternal())
    {
      this->Examined.AddNode();
      this->ScanLeaf(0, static_cast<PointIndex>(this->Nodes.GetNumberOfPoints()));
      return;
    }
    const Grid<Dim>& grid = this->Nodes.GetGrid();
    const Key key = grid.GetKey(this->Wanted.Lower.data());
    const int depth = Key::GetCommonDepth(key, grid.GetKey(this->Wanted.Upper.data()));
    this->Descend(
      FindBlock(this->Nodes, key, std::min(depth, Key::MaxDepth - 1), this->Examined).Block);
  }

private:
  using Key = MortonKey<Dim>;
  /** How a child's box lies to the wanted one. */
  enum class Overlap
  {
    Outside,
    Across,
    Inside
  };

  /** As Grid has it: in cells of MaxDepth from the lower corner of the root. The greater of two
   * coordinates never has the smaller place, however it is rounded. */
  double GetPlace(double x, int axis) const
  {
    const Grid<Dim>& grid = this->Nodes.GetGrid();
    return (x - grid.GetLower()[axis]) / grid.GetSide() * Key::CellsPerSide;
  }

  /** The place of the next coordinate in a direction, where it matters: of one whose place is on no
   * face of any child's box the place itself tells the same. */
  double GetPlaceBeside(double x, int axis, double direction) const
  {
    constexpr double size = Key::CellsPerSide;
    const double place = this->GetPlace(x, axis);
    const double steps = place * ChildBoxes<Dim>::Steps; // The smallest.
    const bool isOnFace = 0.0 <= place && place <= size &&
      steps == static_cast<double>(static_cast<std::int64_t>(steps));
    return isOnFace ? this->GetPlace(std::nextafter(x, direction), axis) : place;
  }

  /** Cells end before their upper faces, but for the last ones: points may be on these. */
  static double BeforeEnd(double place)
  {
    constexpr double end = Key::CellsPerSide;
    constexpr double before = end * (1.0 - std::numeric_limits<double>::epsilon() / 2.0);
    return place == end ? before : place;
  }

  /** `origin` is the lower corner of the block, `step` a step of its boxes. The places of a child's
   * points are at `lower` or above it, and below `upper`, both of which are exact: where these are
   * on the one side of a place, so are the points of its coordinate. */
  Overlap GetOverlap(
    const ChildBoxes<Dim>& boxes, unsigned octant, const GridPlace<Dim>& origin, double step) const
  {
    bool isInside = true;
    bool isOutside = false;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const double lower = origin[axis] + step * boxes.Lower[axis][octant];
      const double upper = origin[axis] + step * (boxes.Upper[axis][octant] + 1);
      isOutside |= upper <= this->Lower[axis] || lower > this->Upper[axis];
      isInside &= lower > this->Before[axis] && upper <= this->Behind[axis];
    }
    return isOutside ? Overlap::Outside : isInside ? Overlap::Inside : Overlap::Across;
  }

  void Descend(std::uint32_t top)
  {
    this->Examined.AddNode();
    const std::uint32_t block = this->Tree.GetFork(top);
    const auto& ranges = this->Nodes.GetBlock(block);
    const auto octants = this->Nodes.GetOctants(block);
    const Key key = this->Nodes.GetBlockKey(block);
    const double width = std::ldexp(1.0, Key::MaxDepth - key.GetDepth());
    const Cell<Dim> cell = key.GetCell();
    GridPlace<Dim> origin;
    for (int axis = 0; axis < Dim; ++axis)
    {
      origin[axis] = width * cell[axis];
    }
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      if ((octants.Occupied >> octant & 1U) == 0)
      {
        continue;
      }
      const Overlap overlap = this->GetOverlap(
        this->Tree.GetChildBoxes(block), octant, origin, width / ChildBoxes<Dim>::Steps);
      const PointIndex first = ranges.FirstPoint[octant];
      const PointIndex last = ranges.FirstPoint[octant + 1];
      if (overlap == Overlap::Inside)
      {
        this->Found.insert(
          this->Found.end(), this->Tree.GetIds() + first, this->Tree.GetIds() + last);
      }
      else if (overlap == Overlap::Across && (octants.Internal >> octant & 1U) != 0)
      {
        this->Descend(this->Nodes.GetChildBlock(block, octant));
      }
      else if (overlap == Overlap::Across)
      {
        this->ScanLeaf(first, last);
      }
    }
  }

  void ScanLeaf(PointIndex first, PointIndex last)
  {
    if (const PointTree<Dim, Real>* nested = this->Tree.FindNested(first))
    {
      PointBoxWalk(*nested, this->Wanted, this->Found, this->Examined).Search();
      return;
    }
    const Real* coordinates = this->Tree.GetLeafCoordinates(first);
    const std::size_t count = last - first;
    for (std::size_t i = 0; i < count; ++i)
    {
      bool isIn = true;
      for (std::size_t axis = 0; axis < Dim; ++axis)
      {
        const auto x = static_cast<double>(coordinates[axis * count + i]);
        isIn &= x >= this->Wanted.Lower[axis] && x <= this->Wanted.Upper[axis];
      }
      if (isIn)
      {
        this->Found.push_back(this->Tree.GetIds()[first + i]);
      }
    }
  }

  const PointTree<Dim, Real>& Tree;
  const Octree<Dim>& Nodes;
  const Box<Dim>& Wanted;
  std::vector<PointIndex>& Found;
  Count& Examined;
  /** Places of the wanted box, of the last coordinates before it, and of the first behind it. */
  GridPlace<Dim> Lower;
  GridPlace<Dim> Upper;
  GridPlace<Dim> Before;
  GridPlace<Dim> Behind;
};
}

#endif
