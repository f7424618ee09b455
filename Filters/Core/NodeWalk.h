// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeWalk_h
#define hashedoctree_NodeWalk_h

#include "Execution.h"
#include "Octree.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hashedoctree
{
/**
 * The nodes of a list, from one on, along the Morton curve, whatever their depths: by the first
 * cell of MaxDepth that they hold, and of those with the same one the first of the list first.
 *
 * Pieces of the list that are in this order already are merged. A list by depth, then by key, as
 * ListNodes() makes it, has no more of them than depths. O(1 + log(pieces)) for each node; nothing
 * is copied, and the list must outlive the walk.
 */
template <int Dim>
class NodeWalk
{
public:
  using Nodes = Buffer<typename Octree<Dim>::Node>;

  /** Finds the pieces from the place `begin` on, O(nodes). Throws Interrupted. */
  NodeWalk(const Nodes& nodes, std::size_t begin, const Execution& execution)
    : Listed(nodes)
  {
    const std::size_t size = nodes.GetSize();
    for (std::size_t place = begin; place < size; ++place)
    {
      if (place % BatchSize == 0)
      {
        execution.Tell(static_cast<double>(place) / static_cast<double>(size));
      }
      if (place == begin || this->GetFirstKey(place) < this->GetFirstKey(place - 1))
      {
        this->Pieces.push_back({ this->GetFirstKey(place), place, place });
      }
      ++this->Pieces.back().Last;
    }
    std::make_heap(this->Pieces.begin(), this->Pieces.end());
  }

  /** Place in the list of the next node. Not more often than there are nodes from `begin` on. */
  std::size_t Next()
  {
    std::pop_heap(this->Pieces.begin(), this->Pieces.end());
    Piece& piece = this->Pieces.back();
    const std::size_t place = piece.Next++;
    if (piece.Next == piece.Last)
    {
      this->Pieces.pop_back();
    }
    else
    {
      piece.FirstKey = this->GetFirstKey(piece.Next);
      std::push_heap(this->Pieces.begin(), this->Pieces.end());
    }
    return place;
  }

private:
  using Key = MortonKey<Dim>;
  static constexpr std::size_t BatchSize = std::size_t(1) << 16; ///< Nodes between two reports.

  /** Places in the list, of which the walk has yet to come to these. */
  struct Piece
  {
    Key FirstKey; ///< Of the next one.
    std::size_t Next;
    std::size_t Last; ///< One past the last.

    /** The heap keeps the largest on top. */
    friend bool operator<(const Piece& a, const Piece& b)
    {
      return b.FirstKey < a.FirstKey || (b.FirstKey == a.FirstKey && b.Next < a.Next);
    }
  };

  Key GetFirstKey(std::size_t place) const
  {
    return this->Listed[place].NodeKey.GetFirstAtMaxDepth();
  }

  const Nodes& Listed;
  std::vector<Piece> Pieces;
};
}

#endif
