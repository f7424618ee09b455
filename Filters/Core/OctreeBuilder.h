// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_OctreeBuilder_h
#define hashedoctree_OctreeBuilder_h

#include "FirstTouch.h"
#include "MortonOrder.h"
#include "Octree.h"

#include <stdexcept>
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
 * a running sum then give the place of every node, breadth first, and the threads write all depths
 * at once.
 */
template <int Dim>
class OctreeBuilder
{
public:
  OctreeBuilder(Octree<Dim>& tree, const Buffer<CodedPoint<Dim>>& points)
    : Tree(tree)
    , Points(points)
    , NodesBefore(Execution::GetNumberOfChunks(points.GetSize(), ChunkSize))
    , FirstPoints(NodesBefore.size())
  {
  }

  void Build(const Execution& execution)
  {
    this->CountNodes(execution.Part(0.0, 0.2));
    this->PlaceNodes(execution.Part(0.2, 0.4));
    this->DescribeChildren(execution.Part(0.4, 0.8));
    this->FillTable(execution.Part(0.8, 1.0));
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

  /** Depths [First, Last] of the internal nodes that begin at point i; none if First > Last. */
  struct DepthRange
  {
    int First;
    int Last;
  };
  DepthRange GetInternalNodesAt(std::size_t i) const
  {
    const std::size_t bucket = this->Tree.BuildOptions.MaxPointsPerLeaf;
    DepthRange depths{ 0, -1 };
    if (bucket >= this->Points.GetSize() - i)
    {
      return depths;
    }
    const Key key = this->Points[i].Key;
    const Key after = this->Points[i + bucket].Key;
    const Key before = i == 0 ? Key() : this->Points[i - 1].Key;
    // Says no for most points, at once.
    if ((key.GetValue() ^ after.GetValue()) < (key.GetValue() ^ before.GetValue()))
    {
      depths.Last = std::min(Key::GetCommonDepth(key, after), this->Tree.BuildOptions.MaxDepth - 1);
      depths.First = i == 0 ? 0 : Key::GetCommonDepth(before, key) + 1;
    }
    return depths;
  }

  /** Fills FirstPoints, and NodesBefore: where the nodes of each depth begin in the order of the
   * blocks, chunk by chunk of points. Also copies the ids, since it reads all points anyway. */
  void CountNodes(const Execution& execution)
  {
    const std::size_t numberOfPoints = this->Points.GetSize();
    this->Tree.PointIds = Buffer<PointIndex>(numberOfPoints);
    execution.ForChunks(numberOfPoints, ChunkSize,
      [this](std::size_t chunk, std::size_t first, std::size_t last)
      {
        PerDepth counts{};
        for (std::size_t i = first; i < last; ++i)
        {
          this->Tree.PointIds[i] = this->Points[i].Id;
          const DepthRange depths = this->GetInternalNodesAt(i);
          if (depths.First <= depths.Last)
          {
            this->FirstPoints[chunk].push_back(static_cast<PointIndex>(i));
          }
          for (int depth = depths.First; depth <= depths.Last; ++depth)
          {
            ++counts[static_cast<std::size_t>(depth)];
          }
        }
        this->NodesBefore[chunk] = counts;
      });

    std::size_t sum = 0;
    for (std::size_t depth = 0; depth < NumberOfDepths; ++depth)
    {
      for (PerDepth& chunk : this->NodesBefore)
      {
        const std::size_t here = chunk[depth];
        chunk[depth] = sum;
        sum += here;
      }
    }
    if (sum > 0xffffffffU)
    {
      throw std::length_error("The tree would have more nodes than 32 bits can number; allow more "
                              "points per leaf or less depth.");
    }
    this->Tree.Blocks = Buffer<Block>(sum);
    this->Tree.BlockOctants = Buffer<Octants>(sum);
    this->Tree.BlockKeys = Buffer<Key>(sum);
  }

  /** Gives each internal node its key, its first point and its first child. */
  void PlaceNodes(const Execution& execution)
  {
    // A chunk writes to as many places as there are depths.
    TouchPages(this->Tree.Blocks, execution);
    TouchPages(this->Tree.BlockOctants, execution);
    TouchPages(this->Tree.BlockKeys, execution);
    execution.ForChunks(this->Points.GetSize(), ChunkSize,
      [this](std::size_t chunk, std::size_t, std::size_t)
      {
        PerDepth next = this->NodesBefore[chunk];
        for (const PointIndex i : this->FirstPoints[chunk])
        {
          const DepthRange depths = this->GetInternalNodesAt(i);
          for (int depth = depths.First; depth <= depths.Last; ++depth)
          {
            const auto d = static_cast<std::size_t>(depth);
            const std::size_t node = next[d]++;
            this->Tree.BlockKeys[node] = this->Points[i].Key.AtDepth(depth);
            this->Tree.Blocks[node].FirstPoint[0] = i;
            // Internal children begin here or later, and all earlier ones have other parents.
            this->Tree.BlockOctants[node].FirstChild = static_cast<std::uint32_t>(next[d + 1]);
          }
        }
      });
  }

  /** Finds where the children of each internal node begin, which are internal, and counts leaves.
   */
  void DescribeChildren(const Execution& execution)
  {
    const std::size_t numberOfNodes = this->Tree.GetNumberOfInternalNodes();
    std::vector<DepthTally> tallies(Execution::GetNumberOfChunks(numberOfNodes, NodeChunkSize));
    execution.ForChunks(numberOfNodes, NodeChunkSize,
      [this, &tallies](std::size_t chunk, std::size_t first, std::size_t last)
      {
        DepthTally tally{};
        for (std::size_t node = first; node < last; ++node)
        {
          this->DescribeChildrenOf(node, tally);
        }
        tallies[chunk] = tally;
      });
    this->SumUp(tallies);
  }

  /** Leaves, empty leaves and points at each depth. */
  struct DepthTally
  {
    PerDepth Leaves;
    PerDepth EmptyLeaves;
    PerDepth Points;
  };

  void DescribeChildrenOf(std::size_t node, DepthTally& tally)
  {
    Block& block = this->Tree.Blocks[node];
    const Key key = this->Tree.BlockKeys[node];
    const auto depth = static_cast<std::size_t>(key.GetDepth() + 1);
    const bool canSplit = static_cast<int>(depth) < this->Tree.BuildOptions.MaxDepth;
    this->FindChildRanges(key, block.FirstPoint);
    unsigned internal = 0;
    unsigned occupied = 0;
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      const std::size_t count = block.FirstPoint[octant + 1] - block.FirstPoint[octant];
      occupied |= (count != 0 ? 1U : 0U) << octant;
      if (canSplit && count > this->Tree.BuildOptions.MaxPointsPerLeaf)
      {
        internal |= 1U << octant;
      }
      else
      {
        ++tally.Leaves[depth];
        tally.EmptyLeaves[depth] += count == 0 ? 1 : 0;
        tally.Points[depth] += count;
      }
    }
    this->Tree.BlockOctants[node].Internal = static_cast<OctantMask<Dim>>(internal);
    this->Tree.BlockOctants[node].Occupied = static_cast<OctantMask<Dim>>(occupied);
  }

  /** Where the range of each child begins and ends, given where the first one begins. */
  void FindChildRanges(Key key, std::array<PointIndex, Key::NumberOfOctants + 1>& firstPoint) const
  {
    const std::size_t first = firstPoint[0];
    const Key lastKey = key.GetLastAtMaxDepth();
    if (first + CountingLimit < this->Points.GetSize() &&
      this->Points[first + CountingLimit].Key <= lastKey)
    {
      for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
      {
        firstPoint[octant + 1] = static_cast<PointIndex>(
          this->FindFirstPointAfter(key.GetChild(octant).GetLastAtMaxDepth(), firstPoint[octant]));
      }
      return;
    }
    // In a short range, counting the octant of every point takes fewer branches.
    firstPoint.fill(0);
    const int childDepth = key.GetDepth() + 1;
    const std::size_t end = std::min(this->Points.GetSize(), first + CountingLimit);
    for (std::size_t i = first; i < end && this->Points[i].Key <= lastKey; ++i)
    {
      ++firstPoint[this->Points[i].Key.AtDepth(childDepth).GetOctant() + 1];
    }
    firstPoint[0] = static_cast<PointIndex>(first);
    for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
    {
      firstPoint[octant + 1] += firstPoint[octant];
    }
  }
  static constexpr std::size_t CountingLimit = 64; ///< Points of a short range.

  /** The first point from `from` on whose key lies beyond `key`, by steps that double and then
   * halve: most ranges are a few points long, and the long ones are few. */
  std::size_t FindFirstPointAfter(Key key, std::size_t from) const
  {
    const std::size_t end = this->Points.GetSize();
    std::size_t step = 1;
    while (from < end && this->Points[from].Key <= key)
    {
      // All points before `from + 1` are known to lie within; look `step` further.
      ++from;
      if (from + step >= end || !(this->Points[from + step].Key <= key))
      {
        step = step > 1 ? step / 2 : 1;
      }
      else
      {
        from += step;
        step *= 2;
      }
    }
    return from;
  }

  void SumUp(const std::vector<DepthTally>& tallies)
  {
    DepthCounts& counts = this->Tree.Counts;
    counts = DepthCounts{};
    if (!this->Tree.IsRootInternal())
    {
      counts = DepthCounts{ { 1 }, { 0 }, { this->Points.GetSize() } };
      return;
    }
    for (std::size_t depth = 0; depth < NumberOfDepths; ++depth)
    {
      std::size_t leaves = 0;
      std::size_t emptyLeaves = 0;
      std::size_t points = 0;
      for (const DepthTally& tally : tallies)
      {
        leaves += tally.Leaves[depth];
        emptyLeaves += tally.EmptyLeaves[depth];
        points += tally.Points[depth];
      }
      counts.Leaves.push_back(leaves);
      counts.EmptyLeaves.push_back(emptyLeaves);
      counts.Points.push_back(points);
    }
    while (counts.Leaves.back() == 0)
    {
      counts.Leaves.pop_back();
      counts.EmptyLeaves.pop_back();
      counts.Points.pop_back();
    }
  }

  void FillTable(const Execution& execution)
  {
    const std::size_t numberOfNodes = this->Tree.GetNumberOfInternalNodes();
    this->Tree.Table = NodeTable<Entry>(numberOfNodes);
    this->Tree.Table.TouchPages(execution);
    for (std::size_t first = 0; first < numberOfNodes; first += TableBatch)
    {
      const std::size_t last = std::min(numberOfNodes, first + TableBatch);
      for (std::size_t node = first; node < last; ++node)
      {
        this->Tree.Table.Prefetch(
          this->Tree.BlockKeys[std::min(node + PrefetchDistance, numberOfNodes - 1)].GetValue());
        const Octants& octants = this->Tree.BlockOctants[node];
        this->Tree.Table.Insert(this->Tree.BlockKeys[node].GetValue(),
          Entry{ static_cast<std::uint32_t>(node), octants.Internal, octants.Occupied });
      }
      execution.Tell(static_cast<double>(last) / static_cast<double>(numberOfNodes));
    }
  }
  static constexpr std::size_t TableBatch = 262144;   ///< Nodes between two reports of progress.
  static constexpr std::size_t PrefetchDistance = 16; ///< Nodes ahead whose slots are on the way.

  Octree<Dim>& Tree;
  const Buffer<CodedPoint<Dim>>& Points;
  std::vector<PerDepth> NodesBefore;
  std::vector<std::vector<PointIndex>> FirstPoints; ///< Where internal nodes begin, by chunk.
};
}

#endif
