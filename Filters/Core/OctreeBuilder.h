// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_OctreeBuilder_h
#define hashedoctree_OctreeBuilder_h

#include "DepthTally.h"
#include "FirstTouch.h"
#include "KeyedPoints.h"
#include "NodeIndex.h"
#include "Octree.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hashedoctree
{
/**
 * Writes the blocks and the table of an octree from the points in Morton order. Private to
 * Octree.cxx.
 *
 * The node at depth l that begins at point i is internal just when point i - 1 is outside it and
 * point i + MaxPointsPerLeaf inside, and that follows from the common depths of the keys. So each
 * point tells by itself which internal nodes begin at it, at which depths; a count per depth and
 * a running sum then give the place of every node, breadth first. A walk along the points, on which
 * a thread begins anywhere, writes all depths at once: where a leaf begins, the children end that
 * the point before was in and this one is not.
 */
template <int Dim>
class OctreeBuilder
{
public:
  OctreeBuilder(Octree<Dim>& tree, const Buffer<KeyedPoint<Dim>>& points)
    : Tree(tree)
    , Points(points)
    , Chunks(Execution::GetNumberOfChunks(points.GetSize(), ChunkSize))
  {
  }

  void Build(const Execution& execution)
  {
    this->CountNodes(execution.Part(0.0, 0.3));
    if (this->Tree.IsRootInternal())
    {
      this->PlaceNodes(execution.Part(0.3, 0.6));
      this->DescribeChildren(execution.Part(0.6, 0.8));
      this->FillTable(execution.Part(0.8, 1.0));
    }
    else
    {
      this->Tree.Counts = DepthCounts{ { 1 }, { 0 }, { this->Points.GetSize() } };
    }
  }

private:
  using Key = MortonKey<Dim>;
  using Block = typename Octree<Dim>::Block;
  using Octants = typename Octree<Dim>::Octants;
  using Entry = typename Octree<Dim>::Entry;
  static constexpr std::size_t ChunkSize = 8192;    ///< Points that a thread does at a time.
  static constexpr std::size_t NodeChunkSize = 512; ///< And nodes.
  static constexpr int NumberOfDepths = Key::MaxDepth + 1;

  /** One number for each depth. */
  using PerDepth = std::array<std::size_t, NumberOfDepths>;

  /** Of a chunk of points: how many internal nodes of each depth begin there, and one past the
   * point where the last does, or 0; then where the first of them stands among the blocks, and the
   * same point of the chunks before it. */
  struct ChunkNodes
  {
    PerDepth Nodes{};
    PerDepth LastBegin{};
  };

  /** The key of the point before one, or one that has no depth in common with any. */
  Key GetKeyBefore(std::size_t i) const { return i == 0 ? Key() : this->Points[i - 1].GetKey(); }

  /** The depth of the deepest internal node that may begin at point i, given the key before: those
   * below what both have in common do, down to it. -1 for none. */
  int GetDeepestAt(std::size_t i, Key before) const
  {
    const std::size_t most = this->Tree.BuildOptions.MaxPointsPerLeaf;
    if (most >= this->Points.GetSize() - i)
    {
      return -1;
    }
    const Key key = this->Points[i].GetKey();
    const Key after = this->Points[i + most].GetKey();
    // Says no for most points, at once.
    return (key.GetValue() ^ after.GetValue()) < (key.GetValue() ^ before.GetValue())
      ? std::min(Key::GetCommonDepth(key, after), this->Tree.BuildOptions.MaxDepth - 1)
      : -1;
  }

  /** Fills Chunks, and copies the ids, since it reads all points anyway. */
  void CountNodes(const Execution& execution)
  {
    const std::size_t numberOfPoints = this->Points.GetSize();
    this->Tree.PointIds = Buffer<PointIndex>(numberOfPoints);
    TouchPages(this->Tree.PointIds, execution);
    execution.ForChunks(numberOfPoints, ChunkSize,
      [this](std::size_t chunk, std::size_t first, std::size_t last)
      {
        ChunkNodes here;
        for (std::size_t i = first; i < last; ++i)
        {
          this->Tree.PointIds[i] = this->Points[i].GetId();
          const Key before = this->GetKeyBefore(i);
          const int deepest = this->GetDeepestAt(i, before);
          if (deepest < 0)
          {
            continue;
          }
          const int common = Key::GetCommonDepth(before, this->Points[i].GetKey());
          for (int depth = common + 1; depth <= deepest; ++depth)
          {
            ++here.Nodes[static_cast<std::size_t>(depth)];
            here.LastBegin[static_cast<std::size_t>(depth)] = i + 1;
          }
        }
        this->Chunks[chunk] = here;
      });

    std::size_t nodes = 0;
    for (std::size_t depth = 0; depth < NumberOfDepths; ++depth)
    {
      std::size_t lastBegin = 0;
      for (ChunkNodes& chunk : this->Chunks)
      {
        nodes += std::exchange(chunk.Nodes[depth], nodes);
        lastBegin = std::max(lastBegin, std::exchange(chunk.LastBegin[depth], lastBegin));
      }
    }
    RequireNodeIndices(nodes);
    this->Tree.Blocks = Buffer<Block>(nodes, Memory::Zeroed);
    this->Tree.BlockOctants = Buffer<Octants>(nodes);
    this->Tree.BlockKeys = Buffer<Key>(nodes);
  }

  /** Gives each internal node its key, its first point and its first child, and tells for those of
   * its children that hold points where they end. */
  void PlaceNodes(const Execution& execution)
  {
    // A chunk writes to as many places as there are depths.
    TouchPages(this->Tree.Blocks, execution);
    TouchPages(this->Tree.BlockOctants, execution);
    TouchPages(this->Tree.BlockKeys, execution);
    execution.ForChunks(this->Points.GetSize(), ChunkSize,
      [this](std::size_t chunk, std::size_t first, std::size_t last)
      { this->PlaceNodesOf(this->Chunks[chunk], first, last); });
  }

  void PlaceNodesOf(const ChunkNodes& chunk, std::size_t first, std::size_t last)
  {
    PerDepth next = chunk.Nodes;
    int deepest = this->GetDeepestBefore(chunk, first);
    std::uint64_t keysOfLeaf = CountKeysBelow(deepest);
    for (std::size_t i = first; i < last; ++i)
    {
      const Key key = this->Points[i].GetKey();
      const Key before = this->GetKeyBefore(i);
      if ((before.GetValue() ^ key.GetValue()) < keysOfLeaf)
      {
        continue; // In the same leaf.
      }
      const int common = Key::GetCommonDepth(before, key);
      if (i > 0)
      {
        this->EndChildren(next, i, common, deepest);
      }
      deepest = std::max(common, this->GetDeepestAt(i, before));
      keysOfLeaf = CountKeysBelow(deepest);
      for (int depth = common + 1; depth <= deepest; ++depth)
      {
        const auto d = static_cast<std::size_t>(depth);
        const std::size_t block = next[d]++;
        this->Tree.BlockKeys[block] = key.AtDepth(depth);
        this->Tree.Blocks[block].FirstPoint[0] = static_cast<PointIndex>(i);
        // Internal children begin here or later, and all earlier ones have other parents.
        this->Tree.BlockOctants[block].FirstChild = static_cast<std::uint32_t>(next[d + 1]);
      }
    }
    if (last == this->Points.GetSize())
    {
      this->EndChildren(next, last, 0, deepest);
    }
  }

  /** How many keys at MaxDepth a child of a node at `depth` has; -1 for the parent of the root. */
  static std::uint64_t CountKeysBelow(int depth)
  {
    return std::uint64_t(1) << (Dim * (Key::MaxDepth - depth - 1));
  }

  /** The depth of the deepest internal node that the point before a chunk is in, -1 for none. */
  int GetDeepestBefore(const ChunkNodes& chunk, std::size_t first) const
  {
    int depth = first == 0 ? -1 : this->Tree.BuildOptions.MaxDepth - 1;
    for (; depth >= 0; --depth)
    {
      const std::size_t lastBegin = chunk.LastBegin[static_cast<std::size_t>(depth)];
      if (lastBegin > 0 &&
        Key::GetCommonDepth(
          this->Points[lastBegin - 1].GetKey(), this->Points[first - 1].GetKey()) >= depth)
      {
        break;
      }
    }
    return depth;
  }

  /** Tells the internal nodes of some depths that the point before i is in that the child which
   * holds it ends at i. */
  void EndChildren(const PerDepth& next, std::size_t i, int shallowest, int deepest)
  {
    const Key key = this->Points[i - 1].GetKey();
    for (int depth = shallowest; depth <= deepest; ++depth)
    {
      Block& ranges = this->Tree.Blocks[next[static_cast<std::size_t>(depth)] - 1];
      ranges.FirstPoint[key.AtDepth(depth + 1).GetOctant() + 1] = static_cast<PointIndex>(i);
    }
  }

  /** Finds where the empty children of each internal node are, which are internal, and counts
   * leaves. */
  void DescribeChildren(const Execution& execution)
  {
    const std::size_t numberOfNodes = this->Tree.GetNumberOfInternalNodes();
    const auto tallies = execution.MapChunks(numberOfNodes, NodeChunkSize,
      [this](std::size_t first, std::size_t last)
      {
        DepthTally<Dim> tally;
        for (std::size_t block = first; block < last; ++block)
        {
          this->DescribeChildrenOf(block, tally);
        }
        return tally;
      });
    DepthTally<Dim> all;
    for (const DepthTally<Dim>& tally : tallies)
    {
      all.Add(tally);
    }
    this->Tree.Counts = all.GetCounts();
  }

  void DescribeChildrenOf(std::size_t block, DepthTally<Dim>& tally)
  {
    auto& firstPoint = this->Tree.Blocks[block].FirstPoint;
    const int depth = this->Tree.BlockKeys[block].GetDepth() + 1;
    const std::size_t mostInLeaf = depth < this->Tree.BuildOptions.MaxDepth
      ? this->Tree.BuildOptions.MaxPointsPerLeaf
      : this->Points.GetSize();
    const auto most = static_cast<PointIndex>(mostInLeaf); // Not more than there are points.
    PointIndex begin = firstPoint[0];
    PointIndex inInternal = 0;
    unsigned internal = 0;
    unsigned occupied = 0;
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      // An empty child, which nobody told where it ends, ends where the one before it does.
      const PointIndex end = std::max(firstPoint[octant + 1], begin);
      const PointIndex count = end - begin;
      firstPoint[octant + 1] = end;
      begin = end;
      occupied |= static_cast<unsigned>(count != 0) << octant;
      internal |= static_cast<unsigned>(count > most) << octant;
      inInternal += count > most ? count : 0;
    }
    Octants& octants = this->Tree.BlockOctants[block];
    octants.Internal = static_cast<OctantMask<Dim>>(internal);
    octants.Occupied = static_cast<OctantMask<Dim>>(occupied);
    tally.AddChildren(depth, octants, begin - firstPoint[0] - inInternal);
  }

  void FillTable(const Execution& execution)
  {
    const std::size_t numberOfNodes = this->Tree.GetNumberOfInternalNodes();
    this->Tree.Table = NodeTable<Entry>(numberOfNodes);
    this->Tree.Table.TouchPages(execution);
    for (std::size_t first = 0; first < numberOfNodes; first += TableBatch)
    {
      const std::size_t last = std::min(numberOfNodes, first + TableBatch);
      for (std::size_t block = first; block < last; ++block)
      {
        this->Tree.Table.Prefetch(
          this->Tree.BlockKeys[std::min(block + PrefetchDistance, numberOfNodes - 1)].GetValue());
        const Octants& octants = this->Tree.BlockOctants[block];
        this->Tree.Table.Insert(this->Tree.BlockKeys[block].GetValue(),
          Entry{ static_cast<std::uint32_t>(block), octants.Internal, octants.Occupied });
      }
      execution.Tell(static_cast<double>(last) / static_cast<double>(numberOfNodes));
    }
  }
  static constexpr std::size_t TableBatch = 262144;   ///< Nodes between two reports of progress.
  static constexpr std::size_t PrefetchDistance = 16; ///< Nodes ahead whose slots are on the way.

  Octree<Dim>& Tree;
  const Buffer<KeyedPoint<Dim>>& Points;
  std::vector<ChunkNodes> Chunks;
};
}

#endif
