// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Octree_h
#define hashedoctree_Octree_h

#include "Buffer.h"
#include "DepthStatistics.h"
#include "NodeTable.h"
#include "PlacesOfBits.h"
#include "PointIndex.h"
#include "PointSelection.h"
#include "SpareMemory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace hashedoctree
{
/** How the octants of an internal node that hold no point are read. */
enum class EmptyOctants
{
  /** Complete tree: every internal node has 2^Dim children, empty leaves among them. In the paper's
   * complete trees these are most of the leaves (E21); none takes memory here. */
  Leaves,
  /** Sparse tree: there is no node, and a search ends in an empty cell (paper E4). */
  Missing
};

/** One bit for each octant. */
template <int Dim>
using OctantMask = std::conditional_t<Dim == 4, std::uint16_t, std::uint8_t>;

/** Number of bits set in an octant mask. (The machine's own instruction is not in every x86-64.) */
constexpr unsigned CountOctants(std::uint32_t mask)
{
  static_assert(PlacesOfBits::Width == 8, "a mask has two bytes at most");
  return unsigned(BitPlaces.Count[mask & 0xffU]) + BitPlaces.Count[mask >> 8];
}

template <int Dim>
class KeyedPoint;
template <int Dim>
class OctreeBuilder;

/**
 * A hashed octree over points (paper section 2), or the 2^Dim-tree of other dimensions.
 *
 * A node is split while it holds more than MaxPointsPerLeaf points, with 1 the paper's rule (E6),
 * and is not at MaxDepth. Only internal nodes are stored, each as one block and its octants, which
 * describe its 2^Dim children: which of them are internal, where these stand, and where the points
 * of each child begin in the Morton order of the points. A leaf, empty or not, needs no memory of
 * its own. Going down reads blocks; reaching a node directly by its key reads one slot of the
 * table, under the key of the parent.
 *
 * Invariants (Invariants.h checks them):
 * - blocks are ordered by depth, then by key, so parents come before children and the internal
 *   children of a node stand side by side; block 0, if there is one, is the root's;
 * - the point ranges of the children of a node partition its own range, in octant order;
 * - the table holds the key of every block and nothing else.
 *
 * Immutable once built; const members may be called from many threads at once. One that was moved
 * from may only be assigned to, or end.
 */
template <int Dim>
class Octree
{
public:
  using Key = MortonKey<Dim>;
  static constexpr unsigned NumberOfOctants = Key::NumberOfOctants;

  struct Options
  {
    std::size_t MaxPointsPerLeaf = 1; ///< At least 1. More only in leaves at MaxDepth.
    int MaxDepth = Key::MaxDepth;     ///< In [0, MortonKey::MaxDepth].

    bool AreInRange() const
    {
      return this->MaxPointsPerLeaf > 0 && this->MaxDepth >= 0 && this->MaxDepth <= Key::MaxDepth;
    }
  };

  /** Which children an internal node has, and where the internal ones stand. Without padding, as
   * there is one of it for each internal node. */
  struct [[gnu::packed, gnu::aligned(2)]] Octants
  {
    std::uint32_t FirstChild; ///< Block of the first internal child; no meaning when there is none.
    OctantMask<Dim> Internal; ///< Those that are internal nodes.
    OctantMask<Dim> Occupied; ///< Those that hold points.
  };

  /** Where the points of the children of an internal node are. */
  struct Block
  {
    std::array<PointIndex, NumberOfOctants + 1> FirstPoint; ///< Where each range begins and ends.
  };

  /** What the table tells of an internal node. */
  struct Entry
  {
    std::uint32_t Block;
    OctantMask<Dim> Internal; ///< As of the octants.
    OctantMask<Dim> Occupied; ///< As of the octants.
  };

  /** Any node: its key and the range of its points in Morton order. */
  struct Node
  {
    Key NodeKey;
    PointIndex FirstPoint;
    PointIndex LastPoint; ///< One past the last.
    bool Internal;

    PointIndex GetNumberOfPoints() const { return this->LastPoint - this->FirstPoint; }
    bool IsEmpty() const { return this->FirstPoint == this->LastPoint; }
  };

  /** The tree of no points: one empty leaf. */
  Octree() = default;

  /**
   * Builds the tree of the selected points: O(n) for n points, plus O(1) for each node. The box of
   * the selection becomes the root (see Grid); without points the tree is the one of the default
   * constructor, but for the options. Points are told apart by their cells at
   * MortonKey::MaxDepth only. Instantiated for PointSpans of float and double, in two dimensions
   * for PlaneSpans, too. Throws std::length_error when the tree would have more internal nodes than
   * 32 bits can number, and Interrupted. Spare memory of sizeof(KeyedPoint) for each point takes
   * the place of as much that would be used meanwhile.
   */
  template <typename Points>
  Octree(Points points, const PointSelection<Dim>& selection, const Options& options,
    const Execution& execution, SpareMemory spare = {});

  /** The same of points whose keys at MortonKey::MaxDepth are given, in the grid that they are
   * from, which is the tree's also without points; the id of a point is its place among the keys.
   */
  Octree(const Grid<Dim>& grid, const std::vector<Key>& keys, const Options& options,
    const Execution& execution);

  const Grid<Dim>& GetGrid() const { return this->RootGrid; }
  /** The options that the tree was built with. */
  const Options& GetOptions() const { return this->BuildOptions; }
  /** Leaves, empty leaves and points of each depth from 0 to the deepest. */
  const DepthCounts& GetDepthCounts() const { return this->Counts; }
  int GetDeepestDepth() const { return this->Counts.GetDeepestDepth(); }

  std::size_t GetNumberOfPoints() const { return this->PointIds.GetSize(); }
  std::size_t GetNumberOfInternalNodes() const { return this->Blocks.GetSize(); }
  /** Internal nodes and leaves, empty ones too. */
  std::size_t GetNumberOfNodes() const
  {
    return this->GetNumberOfInternalNodes() + this->GetNumberOfLeaves();
  }
  std::size_t GetNumberOfLeaves() const; ///< Empty ones too.
  std::size_t GetNumberOfEmptyLeaves() const;

  /** Ids of the points in Morton order: leaf after leaf, in a leaf equal keys by id. See
   * SortAlongMortonCurve(). `GetNumberOfPoints()` values. */
  const PointIndex* GetPointIds() const { return this->PointIds.GetData(); }
  /** The blocks, their octants, and the keys of their nodes, in the same order. */
  const Block& GetBlock(std::size_t block) const { return this->Blocks[block]; }
  const Octants& GetOctants(std::size_t block) const { return this->BlockOctants[block]; }
  const Key& GetBlockKey(std::size_t block) const { return this->BlockKeys[block]; }
  const NodeTable<Entry>& GetTable() const { return this->Table; }

  bool IsRootInternal() const { return this->Blocks.GetSize() != 0; }
  Node GetRoot() const;
  /** A child of an internal node, which is always given in the complete reading. O(1). */
  Node GetChild(std::size_t block, unsigned octant) const
  {
    const Block& parent = this->Blocks[block];
    return Node{ this->BlockKeys[block].GetChild(octant), parent.FirstPoint[octant],
      parent.FirstPoint[octant + 1], (this->BlockOctants[block].Internal >> octant & 1U) != 0 };
  }
  /** Calls function(child) for each child of the internal nodes `firstBlock` to `lastBlock - 1`, in
   * the order of the blocks, then of the octants: from all blocks every node but the root. */
  template <typename Function>
  void ForEachChild(std::size_t firstBlock, std::size_t lastBlock, const Function& function) const
  {
    for (std::size_t block = firstBlock; block < lastBlock; ++block)
    {
      for (unsigned octant = 0; octant < NumberOfOctants; ++octant)
      {
        function(this->GetChild(block, octant));
      }
    }
  }
  /** Block of an internal child. O(1), no table access. */
  std::uint32_t GetChildBlock(std::size_t block, unsigned octant) const
  {
    const Octants& octants = this->BlockOctants[block];
    return octants.FirstChild + CountOctants(octants.Internal & ((1U << octant) - 1U));
  }

  /** The node of a key, or nothing where the tree has none: direct access by key, or by position
   * and depth through Grid::GetKey() and MortonKey::AtDepth() (paper section 2). O(1). */
  std::optional<Node> FindNode(Key key, EmptyOctants reading = EmptyOctants::Leaves) const;

  /** Asks the machine to load what the table tells of some children of a node, all of them
   * internal, before a search goes down into the first. Inline for the reason of Prefetch(). */
  [[gnu::always_inline]] void PrefetchChildren(Key key, std::uint32_t children) const
  {
    for (; children != 0; children &= children - 1)
    {
      const auto octant = static_cast<unsigned>(__builtin_ctz(children));
      this->Table.Prefetch(key.GetChild(octant).GetValue());
    }
  }

  /** Asks for the octants of a block, before a search goes down into it; and, as siblings stand
   * side by side, for those of the next ones. Inline for the same reason. */
  [[gnu::always_inline]] void PrefetchOctants(std::size_t block) const
  {
    __builtin_prefetch(&this->BlockOctants[block]);
  }

  /** Bytes of the tree itself: blocks, their octants and keys, and the table. */
  std::size_t GetTreeBytes() const
  {
    return this->Blocks.GetBytes() + this->BlockOctants.GetBytes() + this->BlockKeys.GetBytes() +
      (this->IsRootInternal() ? this->Table.GetBytes() : 0);
  }
  /** Bytes of the ids in Morton order. */
  std::size_t GetOrderBytes() const { return this->PointIds.GetBytes(); }

private:
  friend class OctreeBuilder<Dim>;
  void Build(Buffer<KeyedPoint<Dim>>& points, const Execution& execution, SpareMemory spare);

  Grid<Dim> RootGrid;
  Options BuildOptions;
  DepthCounts Counts = DepthCounts::OfEmptyTree();
  Buffer<PointIndex> PointIds;
  Buffer<Block> Blocks;
  Buffer<Octants> BlockOctants;
  Buffer<Key> BlockKeys;
  NodeTable<Entry> Table;
};
}

#endif
