// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_DynamicOctree_h
#define hashedoctree_DynamicOctree_h

#include "DirectSearch.h"

#include <vector>

namespace hashedoctree
{
/**
 * A hashed octree whose points come, go and move one by one (paper section 4). After any
 * sequence of changes it has the nodes, the counts per depth and so the start depths of an Octree
 * that is built over the same points in the same root with the same options. Use Octree for points
 * that stay: it has them in Morton order, and threads build it.
 *
 * The caller gives each point an id; memory is proportional to the largest one. Positions are not
 * kept, only their cells. Those outside the root count as the nearest inside, as in Grid.
 *
 * Invariants:
 * - a node is internal just when it holds more than MaxPointsPerLeaf points above MaxDepth;
 * - each internal node has one block; blocks lie in a pool in no order, free ones in a list;
 * - every node, the root too, is described in the block of its parent: block 0 stands above the
 *   root, where key 0 would be, and has no other child;
 * - the table holds the key of every internal node, with the masks of its block, and nothing else.
 *
 * Finding a leaf takes O(1 + |l - start depth|) where it lies at depth l. A change takes that for
 * the old and the new leaf; O(MaxPointsPerLeaf + 2^Dim) for each node that is split or collapsed,
 * of which there are at most MaxDepth, and for one that is not; and O(depths) for the start depth.
 * Memory grows at times, amortised O(1), and is kept for later points. How many points there are at
 * one place does not matter. Where memory is out a change throws std::bad_alloc and has not begun.
 *
 * FindLeaf() of DirectSearch.h and DecisionSearch.h find leaves in it. Const members may be called
 * from many threads at once, as long as no other is.
 */
template <int Dim>
class DynamicOctree
{
public:
  using Key = MortonKey<Dim>;
  using Options = typename Octree<Dim>::Options;
  using Entry = typename Octree<Dim>::Entry;
  static constexpr unsigned NumberOfOctants = Key::NumberOfOctants;

  /** Ends the list of a leaf's points; no point's id. */
  static constexpr std::uint32_t NoPoint = 0xffffffffU;

  /** The children of an internal node. */
  struct Block
  {
    /** The block of an internal child; the first point of a leaf, or NoPoint. */
    std::array<std::uint32_t, NumberOfOctants> Children;
    OctantMask<Dim> Internal; ///< Children that are internal nodes.
    OctantMask<Dim> Occupied; ///< Children that hold points.
  };

  /** A tree of no points. */
  explicit DynamicOctree(const Grid<Dim>& grid, const Options& options = Options());

  /** Adds a point. False, and nothing has changed, where there is one of this id. Throws
   * std::invalid_argument for a position that is not finite or the id NoPoint, and
   * std::length_error where 32 bits cannot number the blocks; then nothing has changed, either. */
  bool Insert(std::uint32_t id, const Position<Dim>& x);

  /** Takes out a point. False, and nothing has changed, where there is none of this id. */
  bool Erase(std::uint32_t id);

  /** Erase() and Insert() in one, at less cost where the point stays in its leaf. False, and
   * nothing has changed, where there is none of this id. Throws std::invalid_argument for a
   * position that is not finite, and std::length_error, as Insert() does. */
  bool Move(std::uint32_t id, const Position<Dim>& x);

  bool HasPoint(std::uint32_t id) const
  {
    return id < this->Points.size() && this->Points[id].PointKey != Key(0);
  }
  std::size_t GetNumberOfPoints() const { return this->NumberOfPoints; }

  const Grid<Dim>& GetGrid() const { return this->RootGrid; }
  const Options& GetOptions() const { return this->TreeOptions; }

  /** Leaves, empty leaves and points of each depth from 0 to the deepest. */
  const DepthCounts& GetDepthCounts() const { return this->Counts; }
  int GetDeepestDepth() const { return this->Counts.GetDeepestDepth(); }
  /** The weighted median of the leaves' depths as they are now. O(depths). */
  int GetStartDepth(FrequencyModel frequency) const
  {
    return GetMedianDepth(GetDepthHistogram(this->Counts, frequency, Dim));
  }

  std::size_t GetNumberOfInternalNodes() const { return this->Table.GetNumberOfKeys(); }
  const NodeTable<Entry>& GetTable() const { return this->Table; }
  const Block& GetBlock(std::size_t block) const { return this->Blocks[block]; }
  bool IsRootInternal() const { return this->Blocks[AboveRoot].Internal != 0; }

  /** Bytes of the tree itself: blocks, free ones too, and the table. */
  std::size_t GetTreeBytes() const
  {
    return this->Blocks.capacity() * sizeof(Block) + this->Table.GetBytes();
  }

  /** Calls function(id) for each point of a leaf that FindLeaf() found since the last change, in no
   * order of meaning. O(points of the leaf). */
  template <typename Function>
  void ForEachPoint(const FoundLeaf<Dim>& leaf, const Function& function) const
  {
    std::uint32_t id = this->Blocks[leaf.ParentBlock].Children[leaf.Key.GetOctant()];
    for (; id != NoPoint; id = this->Points[id].Next)
    {
      function(id);
    }
  }

private:
  static constexpr std::uint32_t AboveRoot = 0; ///< Also what FoundLeaf has for the root.

  /** A point in the list of its leaf. Key 0 is that of ids that no point has. */
  struct Point
  {
    Key PointKey; ///< At MortonKey::MaxDepth.
    std::uint32_t Next;
    std::uint32_t Previous;
  };

  Key GetKey(const Position<Dim>& x) const;
  void MakeRoom(std::uint32_t id);
  void Add(std::uint32_t id, Key key, int startDepth);
  void Remove(std::uint32_t id, int startDepth);

  std::uint32_t Split(Key node, std::uint32_t parent);
  std::uint32_t Collapse(Key node, std::uint32_t block);
  void AddDepth(std::size_t depth);
  void RemoveEmptyDepths();

  void Link(std::uint32_t id, std::uint32_t block, unsigned octant);
  void Unlink(std::uint32_t id, std::uint32_t block, unsigned octant);
  bool FitInLeaf(const std::uint32_t* lists, unsigned numberOfLists) const;
  std::uint32_t TakeBlock();
  void TellTable(Key node, std::uint32_t block);

  Grid<Dim> RootGrid;
  Options TreeOptions;
  DepthCounts Counts = DepthCounts::OfEmptyTree();
  std::size_t NumberOfPoints = 0;
  std::vector<Point> Points; ///< By id.
  std::vector<Block> Blocks;
  std::uint32_t FirstFree = AboveRoot; ///< Of the free blocks, linked by their first child.
  NodeTable<Entry> Table;
};
}

#endif
