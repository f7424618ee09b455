// SPDX-License-Identifier: BSD-3-Clause
#include "NodeCorners.h"

#include "NodeTable.h"

#include <algorithm>
#include <vector>

namespace hashedoctree
{
namespace
{
/** Corners on one axis. A corner's coordinates are the digits of its code in this base. */
template <int Dim>
constexpr std::uint64_t CodeBase = (std::uint64_t(1) << MortonKey<Dim>::MaxDepth) + 1;

/** Lower corner and side of a node, in cells of MaxDepth. */
template <int Dim>
struct Extent
{
  Cell<Dim> Lower;
  std::uint32_t Side;

  explicit Extent(MortonKey<Dim> key)
    : Lower(key.GetCell())
    , Side(1U << (MortonKey<Dim>::MaxDepth - key.GetDepth()))
  {
    for (std::uint32_t& coordinate : this->Lower)
    {
      coordinate *= this->Side;
    }
  }

  Cell<Dim> GetCorner(unsigned corner) const
  {
    Cell<Dim> coordinates = this->Lower;
    for (int axis = 0; axis < Dim; ++axis)
    {
      coordinates[axis] += (corner >> axis & 1U) * this->Side;
    }
    return coordinates;
  }
};

constexpr std::size_t BatchSize = 4096;     // Nodes between two reports of progress.
constexpr std::size_t PrefetchDistance = 6; // Nodes ahead whose corners are on the way.

/**
 * Codes to numbers, in shards that grow one by one: neither growing nor freeing one takes long
 * enough to keep an abort waiting, as it would with a single table for a hundred million corners.
 */
class CornerNumbers
{
public:
  void Prefetch(std::uint64_t code) const { this->Shards[GetShardOf(code)].Prefetch(code); }

  /** The number of a code, which is `next` when it is new. Where a shard grows, it reports that so
   * much is done. */
  std::uint64_t FindOrInsert(
    std::uint64_t code, std::uint64_t next, const Execution& execution, double done)
  {
    NodeTable<std::uint64_t>& shard = this->Shards[GetShardOf(code)];
    if (const std::uint64_t* number = shard.Find(code))
    {
      return *number;
    }
    const std::size_t numberOfKeys = shard.GetNumberOfKeys() + 1;
    if (!shard.HasRoom(numberOfKeys))
    {
      shard.Reserve(numberOfKeys, execution.Part(done, done));
    }
    return shard.Insert(code, next);
  }

  /** Frees everything, with reports of progress in between. */
  void Clear(const Execution& execution)
  {
    while (!this->Shards.empty())
    {
      this->Shards.pop_back();
      execution.Tell(1.0);
    }
  }

private:
  static constexpr int ShardBits = 8;
  static constexpr std::size_t NumberOfShards = std::size_t(1) << ShardBits;

  static std::size_t GetShardOf(std::uint64_t code)
  {
    // Another constant than that of the tables: a shard must not be one part of its table's slots.
    return static_cast<std::size_t>(code * 0xd6e8feb86659fd93U >> (64 - ShardBits));
  }

  // They start small, so that the memory of all is not touched at once.
  std::vector<NodeTable<std::uint64_t>> Shards =
    std::vector<NodeTable<std::uint64_t>>(NumberOfShards);
};
}

template <int Dim>
std::uint64_t NodeCorners<Dim>::Code(const Cell<Dim>& corner)
{
  std::uint64_t code = 0;
  for (const std::uint32_t coordinate : corner)
  {
    code = code * CodeBase<Dim> + coordinate;
  }
  return code + 1; // A table knows no key 0.
}

template <int Dim>
Cell<Dim> NodeCorners<Dim>::GetCorner(std::size_t corner) const
{
  Cell<Dim> coordinates;
  std::uint64_t code = this->Codes[corner] - 1;
  for (int axis = Dim - 1; axis >= 0; --axis)
  {
    coordinates[axis] = static_cast<std::uint32_t>(code % CodeBase<Dim>);
    code /= CodeBase<Dim>;
  }
  return coordinates;
}

template <int Dim>
template <typename Integer>
NodeCorners<Dim>::NodeCorners(const Buffer<typename Octree<Dim>::Node>& nodes,
  Integer* connectivity, const Execution& execution)
  : Codes(nodes.GetSize() * CornersOfNode)
{
  const std::size_t numberOfNodes = nodes.GetSize();
  CornerNumbers numbers;
  for (std::size_t node = 0; node < numberOfNodes; ++node)
  {
    const double done = static_cast<double>(node) / static_cast<double>(numberOfNodes);
    if (node % BatchSize == 0)
    {
      execution.Tell(done);
    }
    const Extent<Dim> ahead(nodes[std::min(node + PrefetchDistance, numberOfNodes - 1)].NodeKey);
    const Extent<Dim> extent(nodes[node].NodeKey);
    for (unsigned corner = 0; corner < CornersOfNode; ++corner)
    {
      numbers.Prefetch(Code(ahead.GetCorner(corner)));
      const std::uint64_t code = Code(extent.GetCorner(corner));
      const std::uint64_t number = numbers.FindOrInsert(code, this->Count, execution, done);
      if (number == this->Count)
      {
        this->Codes[this->Count++] = code;
      }
      connectivity[node * CornersOfNode + corner] = static_cast<Integer>(number);
    }
  }
  numbers.Clear(execution);
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class NodeCorners<Dim>;                                                                 \
  template NodeCorners<Dim>::NodeCorners(                                                          \
    const Buffer<Octree<Dim>::Node>&, int*, const Execution&);                                     \
  template NodeCorners<Dim>::NodeCorners(                                                          \
    const Buffer<Octree<Dim>::Node>&, long long*, const Execution&);
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
