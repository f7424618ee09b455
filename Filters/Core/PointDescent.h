// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointDescent_h
#define hashedoctree_PointDescent_h

#include "PlaceInBlock.h"
#include "PointTree.h"

#include <algorithm>
#include <type_traits>

namespace hashedoctree
{
/** Searches a whole tree around a position for a collector; PointWalk.h defines it. */
template <int Dim, typename Real, typename Collector, typename Count>
void SearchPoints(const PointTree<Dim, Real>& tree, const Position<Dim>& x, Collector& collector,
  Count& count, std::size_t wanted);

/**
 * The way down of a search around a position: from a block through the children that reach into the
 * collector's ball (PointCollectors.h), nearer ones first, to the points of the leaves. Private to
 * PointSearch.cxx.
 *
 * The boxes of all children of a block are measured at once. Blocks with nothing but one internal
 * child are passed over. While no closest point is found yet, boxes promise one: no further away
 * than the nearest of their farthest corners.
 */
template <int Dim, typename Real, typename Collector, typename Count>
class PointDescent
{
public:
  using Block = typename Octree<Dim>::Block;

  /** `place` is the position in cells of MaxDepth from the root's lower corner. */
  PointDescent(const PointTree<Dim, Real>& tree, const Position<Dim>& x,
    const GridPlace<Dim>& place, Collector& collector, Count& count)
    : Tree(tree)
    , X(x)
    , PlaceInRoot(place)
    , Found(collector)
    , Examined(count)
  {
  }

  /** Searches a block, given a cell of MaxDepth in it and its depth. */
  void SearchBlock(std::uint32_t block, const Cell<Dim>& inside, int depth)
  {
    const Place place = this->GetPlace(inside, depth);
    if (place.IsNear())
    {
      this->template Descend<float>(block, place);
    }
    else
    {
      this->template Descend<double>(block, place);
    }
  }

  /** Asks the machine to load the boxes of a block. (Inline for the reason of
   * NodeTable::Prefetch().) */
  [[gnu::always_inline]] void PrefetchBoxes(std::uint32_t block) const
  {
    const auto* boxes = reinterpret_cast<const char*>(&this->Tree.GetChildBoxes(block));
    __builtin_prefetch(boxes);
    __builtin_prefetch(boxes + sizeof(ChildBoxes<Dim>) - 1);
  }

  /** Searches a child that is a leaf. */
  void ScanChild(const Block& ranges, unsigned octant)
  {
    this->ScanLeaf(ranges.FirstPoint[octant], ranges.FirstPoint[octant + 1]);
  }

  /** Searches a leaf, given where its points begin and end. */
  void ScanLeaf(PointIndex first, PointIndex last)
  {
    const std::size_t stride = last - first;
    std::size_t size = stride;
    if (first == this->ScannedPoint || size == 0)
    {
      return;
    }
    if (size > this->Tree.GetMostAtLastDepth())
    {
      size = this->PrepareLargeLeaf(first, size);
      if (size == 0)
      {
        return;
      }
    }
    const Real* coordinates = this->Tree.GetLeafCoordinates(first);
    const PointIndex* ids = this->Tree.GetIds() + first;
    if (this->Found.NeedsIds())
    {
      // Now, while the points are measured: in a large tree each wait for memory counts.
      __builtin_prefetch(ids);
      __builtin_prefetch(ids + size - 1);
    }
    using Kernels = PointKernels<Dim, Real>;
    const Kernels& kernels = this->Tree.GetPointKernels();
    double dist2[Kernels::MostPoints];
    for (std::size_t done = 0; done < size; done += Kernels::MostPoints)
    {
      const std::size_t count = std::min<std::size_t>(Kernels::MostPoints, size - done);
      const Real* some = coordinates + done;
      const double* x = this->X.data();
      const double bound2 = this->Found.GetBound2();
      if constexpr (Collector::TakesWithin)
      {
        const std::uint64_t within =
          kernels.MeasurePointsWithin(some, stride, count, x, bound2, dist2);
        if (within != 0)
        {
          this->Found.Add(dist2, within, ids + done, count);
        }
      }
      else
      {
        const double least = kernels.MeasurePoints(some, stride, count, x, dist2);
        if (least <= bound2)
        {
          this->Found.Add(dist2, least, ids + done, count);
        }
      }
    }
  }

  /** From now on leaves out the leaf whose points begin there: it has been searched. */
  void LeaveOutLeaf(PointIndex firstPoint) { this->ScannedPoint = firstPoint; }
  /** From now on leaves out a block: all of it has been searched. */
  void LeaveOutBlock(std::uint32_t block) { this->SearchedBlock = this->Tree.GetFork(block); }

private:
  using Key = MortonKey<Dim>;
  using Place = PlaceInBlock<Dim>;
  static constexpr unsigned NumberOfOctants = Octree<Dim>::NumberOfOctants;
  static constexpr PointIndex NoPoint = ~PointIndex(0);
  static constexpr std::uint32_t NoBlock = ~std::uint32_t(0);
  /** Balls that reach less far than half a child's side seldom hold one. Squared, in steps. */
  static constexpr double LeastToHoldNodes2 =
    ChildBoxes<Dim>::Steps * ChildBoxes<Dim>::Steps / 16.0;

  /** How many points of a leaf with more than Tree.GetMostAtLastDepth() are to be measured: none if
   * it has a nested tree, which is searched; where all are at one place, as many as are wanted. */
  [[gnu::noinline]] std::size_t PrepareLargeLeaf(PointIndex first, std::size_t size)
  {
    if (const PointTree<Dim, Real>* nested = this->Tree.FindNested(first))
    {
      SearchPoints<Dim, Real>(*nested, this->X, this->Found, this->Examined, 1);
      return 0;
    }
    if (!this->Tree.PartsAllPlaces())
    {
      return size;
    }
    if constexpr (Collector::HasFixedBall)
    {
      return this->IsWithin(first, size) ? size : 0;
    }
    else
    {
      return std::min(size, this->Found.GetMostAtOnePlace());
    }
  }

  /** Whether the first point of a leaf with `size` points is within the ball. */
  bool IsWithin(PointIndex firstPoint, std::size_t size) const
  {
    double dist2[PointKernels<Dim, Real>::MostPoints];
    return this->Tree.GetPointKernels().MeasurePoints(this->Tree.GetLeafCoordinates(firstPoint),
             size, 1, this->X.data(), dist2) <= this->Found.GetBound2();
  }

  Place GetPlace(const Cell<Dim>& inside, int depth) const
  {
    return { this->PlaceInRoot, inside, depth,
      this->Tree.GetOctree().GetGrid().GetCellsPerLength() };
  }

  /** The squared reach of the ball in steps, beyond which a child is of no use. */
  double GetReach2(const Place& place) const { return place.ToSteps2(this->Found.GetBound2()); }

  template <typename T>
  unsigned Measure(std::uint32_t block, const Place& place, T* dist2) const
  {
    return place.Measure(
      this->Tree.GetBoxKernels(), this->Tree.GetChildBoxes(block), this->GetReach2(place), dist2);
  }

  /** Searches the children of a block, with distances in float, or from far away in double. */
  template <typename T>
  void Descend(std::uint32_t block, const Place& place)
  {
    if (block == this->SearchedBlock)
    {
      return;
    }
    this->Examined.AddNode();
    if (this->Tree.IsLink(block))
    {
      this->SearchFork(block);
      return;
    }
    T dist2[NumberOfOctants];
    const Octree<Dim>& octree = this->Tree.GetOctree();
    const auto octants = octree.GetOctants(block);
    unsigned left = octants.Occupied & this->Measure(block, place, dist2);
    if constexpr (Collector::TakesWholeNodes)
    {
      left = this->template TakeWholeNodes<T>(block, place, left);
    }
    if constexpr (Collector::TakesPromises && std::is_same_v<T, float>)
    {
      if (!this->Found.HasFound())
      {
        this->Found.Promise(
          place.GetPromise2(this->Tree.GetBoxKernels(), this->Tree.GetChildBoxes(block), left));
      }
    }
    while (left != 0)
    {
      const unsigned octant = GetNearest(left, dist2);
      if (!Collector::HasFixedBall &&
        static_cast<double>(dist2[octant]) > this->GetReach2(place) * Place::template Room<T>)
      {
        return;
      }
      left &= ~(1U << octant);
      if ((octants.Internal >> octant & 1U) == 0)
      {
        this->ScanChild(octree.GetBlock(block), octant);
      }
      else if (std::is_same_v<T, float> && Place::IsNearToChild(static_cast<float>(dist2[octant])))
      {
        this->template Descend<float>(
          octree.GetChildBlock(block, octant), place.GetInChild(octant));
      }
      else
      {
        this->template Descend<double>(
          octree.GetChildBlock(block, octant), place.GetInChild(octant));
      }
    }
  }

  /** One of some octants: the nearest, or, where the ball stays as it is, any. */
  template <typename T>
  static unsigned GetNearest(unsigned octants, const T* dist2)
  {
    auto nearest = static_cast<unsigned>(__builtin_ctz(octants));
    if (!Collector::HasFixedBall)
    {
      T least = dist2[nearest];
      for (unsigned others = octants & (octants - 1); others != 0; others &= others - 1)
      {
        const auto octant = static_cast<unsigned>(__builtin_ctz(others));
        // (In this form compilers do without a branch, which nobody could foresee.)
        nearest = dist2[octant] < least ? octant : nearest;
        least = dist2[octant] < least ? dist2[octant] : least;
      }
    }
    return nearest;
  }

  /** Searches where the points of a block part. */
  void SearchFork(std::uint32_t block)
  {
    const std::uint32_t fork = this->Tree.GetFork(block);
    const Key key = this->Tree.GetOctree().GetBlockKey(fork);
    this->SearchBlock(fork, key.GetFirstAtMaxDepth().GetCell(), key.GetDepth());
  }

  /** Hands over the points of the children that lie in the ball as a whole; returns the others. */
  template <typename T>
  unsigned TakeWholeNodes(std::uint32_t block, const Place& place, unsigned octants)
  {
    // Where squares are not exact, points are looked at one by one.
    const double reach2 = this->GetReach2(place);
    if (!(place.IsExact() && reach2 > LeastToHoldNodes2))
    {
      return octants;
    }
    const Block& ranges = this->Tree.GetOctree().GetBlock(block);
    const unsigned whole = octants &
      place.template GetWhole<T>(
        this->Tree.GetBoxKernels(), this->Tree.GetChildBoxes(block), reach2);
    for (unsigned rest = whole; rest != 0; rest &= rest - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
      const PointIndex first = ranges.FirstPoint[octant];
      this->Found.AddAll(this->Tree.GetIds() + first, ranges.FirstPoint[octant + 1] - first);
    }
    return octants & ~whole;
  }

  const PointTree<Dim, Real>& Tree;
  const Position<Dim>& X;
  const GridPlace<Dim>& PlaceInRoot;
  Collector& Found;
  Count& Examined;
  PointIndex ScannedPoint = NoPoint;     ///< The leaf that begins there is left out,
  std::uint32_t SearchedBlock = NoBlock; ///< and this block.
};
}

#endif
