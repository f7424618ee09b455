// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_BatchOrder_h
#define hashedoctree_BatchOrder_h

#include "MortonOrder.h"
#include "PointTree.h"

namespace hashedoctree
{
/**
 * The order in which a batch takes some positions: along the Morton curve, so that what one search
 * has loaded is there for the next, or as they come where that would not help, since the tree stays
 * in the machine's caches anyway, or since most positions come next to their forerunners.
 *
 * Depends on the tree and the positions alone. Positions outside the root, and those that are not
 * finite, stand where the cells nearest to them do.
 */
template <int Dim>
class BatchOrder
{
public:
  /** How many positions an order is made of at most, which takes 24 bytes for each meanwhile, 32
   * with 64-bit ids. */
  static constexpr std::size_t MostPositions = std::size_t(1) << 20;

  /** Of the positions [first, last), at most MostPositions. O(last - first). Throws Interrupted. */
  template <typename Real, typename Positions>
  BatchOrder(const PointTree<Dim, Real>& tree, const Positions& positions, std::size_t first,
    std::size_t last, const Execution& execution)
    : First(first)
    , Count(last - first)
  {
    const Octree<Dim>& nodes = tree.GetOctree();
    if (tree.GetBytes() > BytesInCaches && !AreTogether(nodes, positions, first, last))
    {
      this->Sort(nodes.GetGrid(), positions, execution);
    }
  }

  std::size_t GetCount() const { return this->Count; }
  /** The position that stands at a place in [0, GetCount()). */
  std::size_t operator[](std::size_t place) const
  {
    return this->First + (this->Places.GetSize() == 0 ? place : this->Places[place]);
  }

private:
  using Key = MortonKey<Dim>;
  static constexpr std::size_t BytesInCaches = std::size_t(2) << 20;
  static constexpr std::size_t PositionsPerCell = 8; ///< In a cell of so many order is of no use.
  static constexpr std::size_t Grain = 8192; ///< Positions whose keys a thread makes at a time.
  static constexpr std::size_t SampleDistance = 61; ///< From one position that is looked at to
                                                    ///< the next; in no step with rows of 2^n.
  /** Positions in one cell so many depths above most points' leaves count as near each other. */
  static constexpr int DepthsTogether = 3;

  template <typename Positions>
  static bool AreTogether(
    const Octree<Dim>& nodes, const Positions& positions, std::size_t first, std::size_t last)
  {
    const int depth = GetMedianDepth(nodes.GetDepthCounts().Points) - DepthsTogether;
    std::size_t looks = 0;
    std::size_t together = 0;
    for (std::size_t i = first; i + 1 < last; i += SampleDistance)
    {
      const Key key = nodes.GetGrid().GetKey(GetPosition<Dim>(positions, i));
      const Key next = nodes.GetGrid().GetKey(GetPosition<Dim>(positions, i + 1));
      together += Key::GetCommonDepth(key, next) >= depth ? 1 : 0;
      ++looks;
    }
    return 2 * together >= looks;
  }

  template <typename Positions>
  void Sort(const Grid<Dim>& grid, const Positions& positions, const Execution& execution)
  {
    Buffer<KeyedPoint<Dim>> keyed(this->Count);
    execution.Part(0.0, 0.3).ForEach(this->Count, Grain,
      [&](std::size_t i)
      {
        keyed[i] = KeyedPoint<Dim>(
          grid.GetKey(GetPosition<Dim>(positions, this->First + i)), static_cast<PointIndex>(i));
      });
    SortAlongMortonCurve(keyed, PositionsPerCell, Key::MaxDepth, execution.Part(0.3, 1.0));
    this->Places = Buffer<PointIndex>(this->Count);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Places[i] = keyed[i].GetId();
    }
  }

  std::size_t First;
  std::size_t Count;
  Buffer<PointIndex> Places; ///< From First on; none where positions are taken as they come.
};
}

#endif
