// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointWalk_h
#define hashedoctree_PointWalk_h

#include "BallInGrid.h"
#include "DirectSearch.h"
#include "PointTree.h"

#include <limits>
#include <type_traits>

namespace hashedoctree
{
/**
 * One search around a position. It hands the points of the leaves that may matter to a collector
 * (PointCollectors.h), always including every point within the collector's bound. Private to
 * PointSearch.cxx.
 *
 * It finds the leaf of the position from the start depth and scans it; as long as the collector's
 * ball reaches further, it searches the block around the leaf, and then the cells that cover the
 * ball, which it reaches directly. A search that starts at the root is the classical one: down from
 * the root, nearer children first, without the table.
 */
template <int Dim, typename Real, typename Collector, typename Count>
class PointWalk
{
public:
  PointWalk(
    const PointTree<Dim, Real>& tree, const Position<Dim>& x, Collector& collector, Count& count)
    : Tree(tree)
    , Nodes(tree.GetOctree())
    , X(x)
    , Points(collector)
    , Examined(count)
    , Ball(this->Nodes.GetGrid(), x)
  {
  }

  /** `wanted` points at least are asked for; a hint where to begin. */
  void Search(std::size_t wanted)
  {
    if (!this->Nodes.IsRootInternal())
    {
      this->Examined.AddNode();
      this->ScanLeaf(0, static_cast<std::uint32_t>(this->Nodes.GetNumberOfPoints()));
      return;
    }
    const Key key = Key::FromCell(this->Ball.GetHome(), Key::MaxDepth);
    const int startDepth = this->Tree.GetStartDepths().Get(key);
    if (startDepth == 0)
    {
      this->SearchBlock(0, this->Ball.GetHome(), 0);
    }
    else if constexpr (Collector::HasFixedBall)
    {
      this->SearchFixedBall(key, startDepth);
    }
    else
    {
      this->SearchOutwards(key, startDepth, wanted);
    }
  }

private:
  using Key = MortonKey<Dim>;
  using Block = typename Octree<Dim>::Block;
  using Entry = typename Octree<Dim>::Entry;
  static constexpr unsigned NumberOfOctants = Octree<Dim>::NumberOfOctants;
  static constexpr std::uint32_t Nothing = ~std::uint32_t(0);

  void SearchFixedBall(Key key, int startDepth)
  {
    if (!this->ReachesPoints())
    {
      return;
    }
    this->Ball.SetRadius2(this->Points.GetBound2());
    const FoundLeaf<Dim> leaf =
      FindLeaf(this->Nodes, key, std::min(startDepth, this->Ball.GetCoverDepth()), this->Examined);
    const int depth = leaf.Key.GetDepth();
    if (this->Ball.GetDepth() >= depth)
    {
      this->ScanChild(this->Nodes.GetBlock(leaf.ParentBlock), leaf.Key.GetOctant());
      return;
    }
    this->SearchBall(key, depth - 1);
  }

  /** Whether the ball reaches into the box of any child of the root. */
  bool ReachesPoints() const
  {
    const Visit root = this->GetVisit(0, this->Ball.GetHome(), 0);
    float dist2[NumberOfOctants];
    const double limit =
      this->GetReach2(root) / root.StepSize2 * (1.0 + 3.0 * DistanceKernels<Dim, Real>::BoxError);
    return (this->Nodes.GetBlock(0).Occupied &
             this->Kernels.ToBoxes(this->Tree.GetChildBoxes(0), root.Steps.data(),
               static_cast<float>(limit), dist2)) != 0;
  }

  void SearchOutwards(Key key, int startDepth, std::size_t wanted)
  {
    const FoundLeaf<Dim> leaf = FindLeaf(this->Nodes, key, startDepth, this->Examined);
    std::uint32_t block = leaf.ParentBlock;
    __builtin_prefetch(&this->Tree.GetChildBoxes(block));
    const Block& parent = this->Nodes.GetBlock(block);
    const unsigned octant = leaf.Key.GetOctant();
    int depth = leaf.Key.GetDepth();
    if (parent.FirstPoint[octant + 1] - parent.FirstPoint[octant] >= wanted)
    {
      this->ScanChild(parent, octant);
      this->Ball.SetRadius2(this->Points.GetBound2());
      if (this->Ball.GetDepth() >= depth)
      {
        return;
      }
      this->ScannedPoint = parent.FirstPoint[octant];
    }

    // The block around the leaf, or the smallest above it with enough points.
    --depth;
    while (depth > 0 && CountPoints(this->Nodes.GetBlock(block)) < wanted)
    {
      --depth;
      block = depth > 0 ? this->Find(key.AtDepth(depth))->Block : 0;
    }
    this->SearchBlock(block, this->Ball.GetHome(), depth);
    if (depth > 0)
    {
      this->Ball.SetRadius2(this->Points.GetBound2());
      if (this->Ball.GetDepth() < depth)
      {
        this->SearchedBlock = block;
        this->SearchedDepth = depth;
        this->SearchBall(key, depth);
      }
    }
  }

  static std::size_t CountPoints(const Block& block)
  {
    return block.FirstPoint[NumberOfOctants] - block.FirstPoint[0];
  }

  const Entry* Find(Key key)
  {
    this->Examined.AddNode();
    return this->Nodes.GetTable().Find(key.GetValue());
  }

  /** Searches where the ball is: the few cells that cover it, not below `deepest`, or the one
   * around it where that is hardly larger. */
  void SearchBall(Key key, int deepest)
  {
    const int coverDepth = std::min(deepest, this->Ball.GetCoverDepth());
    if (this->Ball.GetDepth() + 1 < coverDepth)
    {
      Cell<Dim> cell;
      this->SearchCells(cell, coverDepth, 0);
      return;
    }
    int depth = std::min(this->Ball.GetDepth(), Key::MaxDepth - 1);
    const Entry* entry = nullptr;
    while (depth > 0 && (entry = this->Find(key.AtDepth(depth))) == nullptr)
    {
      --depth;
    }
    this->SearchBlock(depth > 0 ? entry->Block : 0, this->Ball.GetHome(), depth);
  }

  /** Searches the cells of a depth between the ball's corners, axis after axis. */
  void SearchCells(Cell<Dim>& cell, int depth, int axis)
  {
    if (axis == Dim)
    {
      this->SearchCell(cell, depth);
      return;
    }
    const int shift = Key::MaxDepth - depth;
    const std::uint32_t last = this->Ball.GetUpper()[axis] >> shift;
    for (std::uint32_t c = this->Ball.GetLower()[axis] >> shift; c <= last; ++c)
    {
      cell[axis] = c;
      this->SearchCells(cell, depth, axis + 1);
    }
  }

  /** The node of a cell, or the leaf above it; a leaf only for the first of its cells. */
  void SearchCell(const Cell<Dim>& cell, int depth)
  {
    if (this->IsSearched(cell, depth))
    {
      return;
    }
    const int shift = Key::MaxDepth - depth;
    const Key key = Key::FromCell(cell, depth);
    if (const Entry* entry = this->Find(key))
    {
      Cell<Dim> inside = cell;
      for (std::uint32_t& coordinate : inside)
      {
        coordinate <<= shift;
      }
      this->SearchBlock(entry->Block, inside, depth);
      return;
    }
    Key leaf = key;
    const Entry* parent = nullptr;
    while ((parent = this->Find(leaf.GetParent())) == nullptr)
    {
      leaf = leaf.GetParent();
    }
    const int levels = depth - leaf.GetDepth();
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::uint32_t lower = this->Ball.GetLower()[axis] >> shift;
      if (cell[axis] != std::max(lower, cell[axis] >> levels << levels))
      {
        return;
      }
    }
    this->ScanChild(this->Nodes.GetBlock(parent->Block), leaf.GetOctant());
  }

  /** Whether a cell lies in the block that has been searched. */
  bool IsSearched(const Cell<Dim>& cell, int depth) const
  {
    if (this->SearchedBlock == Nothing || depth < this->SearchedDepth)
    {
      return false;
    }
    bool isIn = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      isIn &= cell[axis] >> (depth - this->SearchedDepth) ==
        this->Ball.GetHome()[axis] >> (Key::MaxDepth - this->SearchedDepth);
    }
    return isIn;
  }

  /** A block on the way down, and where the position lies in its cell. */
  struct Visit
  {
    std::uint32_t Block;
    Position<Dim> Steps; ///< From the cell's lower corner, in steps of its boxes.
    double StepSize2;    ///< Squared side of a step, in world units.
  };

  void SearchBlock(std::uint32_t block, const Cell<Dim>& inside, int depth)
  {
    const Visit visit = this->GetVisit(block, inside, depth);
    double farthest = 0.0;
    for (const double steps : visit.Steps)
    {
      farthest = std::max(farthest, std::abs(steps));
    }
    if (farthest * farthest <= Far2)
    {
      this->template Descend<float>(visit);
    }
    else
    {
      this->template Descend<double>(visit);
    }
  }

  /** Of a block, given a cell of MaxDepth in it and its depth. */
  Visit GetVisit(std::uint32_t block, const Cell<Dim>& inside, int depth) const
  {
    const int shift = Key::MaxDepth - depth;
    const double step =
      static_cast<double>(std::uint64_t(1) << shift) / static_cast<double>(ChildBoxes<Dim>::Steps);
    Visit visit;
    visit.Block = block;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const auto lower = static_cast<double>(inside[axis] >> shift << shift);
      visit.Steps[axis] = (this->Ball.GetPlace()[axis] - lower) / step;
    }
    const double stepSize = step * this->Ball.GetCellSize();
    visit.StepSize2 = stepSize * stepSize;
    return visit;
  }

  static Visit GoDown(const Visit& visit, const Block& block, unsigned octant)
  {
    Visit child;
    child.Block = Octree<Dim>::GetChildBlock(block, octant);
    for (int axis = 0; axis < Dim; ++axis)
    {
      const bool upper = (octant >> (Dim - 1 - axis) & 1U) != 0;
      child.Steps[axis] = 2.0 * visit.Steps[axis] - (upper ? ChildBoxes<Dim>::Steps : 0);
    }
    child.StepSize2 = 0.25 * visit.StepSize2;
    return child;
  }

  /** Searches the children of a block, nearer ones first, as long as they reach into the ball. With
   * distances in float, or from far away in double. */
  template <typename T>
  void Descend(const Visit& visit)
  {
    if (visit.Block == this->SearchedBlock)
    {
      return;
    }
    this->Examined.AddNode();
    const Block& block = this->Nodes.GetBlock(visit.Block);
    const ChildBoxes<Dim>& boxes = this->Tree.GetChildBoxes(visit.Block);
    T dist2[NumberOfOctants];
    constexpr double error =
      std::is_same_v<T, float> ? DistanceKernels<Dim, Real>::BoxError : FarError;
    const double scale = visit.StepSize2 * (1.0 - error);
    // Where distances overflow, the limit is no number, and nothing is left out.
    const auto limit = static_cast<T>(this->GetReach2(visit) / scale * (1.0 + error));
    unsigned left = block.Occupied;
    if constexpr (std::is_same_v<T, float>)
    {
      left &= this->Kernels.ToBoxes(boxes, visit.Steps.data(), limit, dist2);
    }
    else
    {
      left &= MeasureFarBoxes(boxes, visit.Steps, limit, dist2);
    }
    if constexpr (Collector::TakesWholeNodes)
    {
      left = this->TakeWholeNodes(visit, block, boxes, left);
    }
    while (left != 0)
    {
      auto nearest = static_cast<unsigned>(__builtin_ctz(left));
      for (unsigned others = left & (left - 1); others != 0; others &= others - 1)
      {
        const auto octant = static_cast<unsigned>(__builtin_ctz(others));
        nearest = dist2[octant] < dist2[nearest] ? octant : nearest;
      }
      // (A distance that has overflowed tells nothing.)
      if (static_cast<double>(dist2[nearest]) * scale > this->GetReach2(visit) &&
        dist2[nearest] <= std::numeric_limits<T>::max())
      {
        return;
      }
      left &= ~(1U << nearest);
      if ((block.Internal >> nearest & 1U) == 0)
      {
        this->ScanChild(block, nearest);
      }
      else if (std::is_same_v<T, float> && dist2[nearest] <= T(Far2 / 4.0))
      {
        this->template Descend<float>(GoDown(visit, block, nearest));
      }
      else
      {
        this->template Descend<double>(GoDown(visit, block, nearest));
      }
    }
  }

  /** Beyond this squared distance in steps a block is so far away, beside its size, that the
   * children's boxes are all one to a float. */
  static constexpr double Far2 = (64.0 * ChildBoxes<Dim>::Steps) * (64.0 * ChildBoxes<Dim>::Steps);

  /** As DistanceKernels::ToBoxes(), in double. */
  static unsigned MeasureFarBoxes(
    const ChildBoxes<Dim>& boxes, const Position<Dim>& steps, double limit, double* dist2)
  {
    unsigned mask = 0;
    for (unsigned octant = 0; octant < NumberOfOctants; ++octant)
    {
      dist2[octant] = 0.0;
      for (int axis = 0; axis < Dim; ++axis)
      {
        const double t = steps[axis];
        const double slack = 1e-3 + FarError * std::abs(t);
        const double below = boxes.Lower[axis][octant] - t - slack;
        const double above = t - slack - (boxes.Upper[axis][octant] + 1.0);
        const double distance = std::max(0.0, std::max(below, above));
        dist2[octant] += distance * distance;
      }
      mask |= (dist2[octant] > limit ? 0U : 1U) << octant;
    }
    return mask;
  }
  static constexpr double FarError = 4e-15; ///< More than rounding does to a place, or a square.

  /** The squared distance beyond which a child of a block is of no use. Where squares are too small
   * to be exact there is none. */
  double GetReach2(const Visit& visit) const
  {
    return visit.StepSize2 > SmallestExact ? this->Points.GetBound2()
                                           : std::numeric_limits<double>::infinity();
  }
  static constexpr double SmallestExact = 1e-280;

  /** Hands over the points of the children that lie in the ball as a whole; returns the others. */
  unsigned TakeWholeNodes(
    const Visit& visit, const Block& block, const ChildBoxes<Dim>& boxes, unsigned octants)
  {
    // Where squares are too small to be exact, points are looked at one by one.
    const double radius2 = this->Points.GetBound2() / visit.StepSize2;
    if (!(visit.StepSize2 > SmallestExact && radius2 > 1.0))
    {
      return octants;
    }
    for (unsigned rest = octants; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      if (GetFarthest2(visit, boxes, octant) < radius2)
      {
        const std::uint32_t first = block.FirstPoint[octant];
        this->Points.AddAll(this->Tree.GetIds() + first, block.FirstPoint[octant + 1] - first);
        octants &= ~(1U << octant);
      }
    }
    return octants;
  }

  /** Squared distance to the farthest corner of a child's box in steps, rounded up. */
  static double GetFarthest2(const Visit& visit, const ChildBoxes<Dim>& boxes, unsigned octant)
  {
    double sum = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const double t = visit.Steps[axis];
      const double toLower = t - boxes.Lower[axis][octant];
      const double toUpper = boxes.Upper[axis][octant] + 1.0 - t;
      const double distance = std::max(toLower, toUpper) + 1e-3 + 1e-9 * std::abs(t);
      sum += distance * distance;
    }
    return sum;
  }

  void ScanChild(const Block& block, unsigned octant)
  {
    this->ScanLeaf(block.FirstPoint[octant], block.FirstPoint[octant + 1]);
  }

  void ScanLeaf(std::uint32_t first, std::uint32_t last)
  {
    const std::size_t size = last - first;
    if (first == this->ScannedPoint || size == 0)
    {
      return;
    }
    if (size > this->Nodes.GetOptions().MaxPointsPerLeaf)
    {
      if (const PointTree<Dim, Real>* nested = this->Tree.FindNested(first))
      {
        PointWalk(*nested, this->X, this->Points, this->Examined).Search(1);
        return;
      }
    }
    const Real* coordinates = this->Tree.GetLeafCoordinates(first);
    const std::uint32_t* ids = this->Tree.GetIds() + first;
    double dist2[DistanceKernels<Dim, Real>::MostPoints];
    for (std::size_t done = 0; done < size; done += DistanceKernels<Dim, Real>::MostPoints)
    {
      const std::size_t count =
        std::min<std::size_t>(DistanceKernels<Dim, Real>::MostPoints, size - done);
      const double least =
        this->Kernels.ToPoints(coordinates + done, size, count, this->X.data(), dist2);
      if (least <= this->Points.GetBound2())
      {
        this->Points.Add(dist2, least, ids + done, count);
      }
    }
  }

  const PointTree<Dim, Real>& Tree;
  const DistanceKernels<Dim, Real>& Kernels = GetDistanceKernels<Dim, Real>();
  const Octree<Dim>& Nodes;
  const Position<Dim>& X;
  Collector& Points;
  Count& Examined;
  BallInGrid<Dim> Ball;
  std::uint32_t ScannedPoint = Nothing;  ///< The leaf that begins there has been scanned.
  std::uint32_t SearchedBlock = Nothing; ///< All of this block has been searched,
  int SearchedDepth = 0;                 ///< which is the ancestor of the home cell at this depth.
};
}

#endif
