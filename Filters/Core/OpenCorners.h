// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_OpenCorners_h
#define hashedoctree_OpenCorners_h

#include "CornerCode.h"
#include "Interleaving.h"
#include "NodeTable.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace hashedoctree
{
/**
 * Codes to numbers, of the corners that nodes further along the curve can still have. Keys along it
 * grow with each coordinate, and no corner of a node has a smaller one than the cell of MaxDepth
 * that the node begins with. So a corner is closed when the walk has passed the cell that begins
 * there, and is forgotten when its shard is full. The open ones are few beside all, and stay in
 * the caches.
 *
 * Shards grow one by one: should most of many millions of corners stay open after all, then neither
 * growing nor freeing one takes long enough to keep an abort waiting.
 */
template <int Dim>
class OpenCorners
{
public:
  void Prefetch(std::uint64_t code) const { this->Shards[GetShardOf(code)].Prefetch(code); }

  /** The number of a code, which is `next` when it is new. All nodes from this one on begin at
   * `first` or further along the curve. Where a shard is full, it reports `done` as progress
   * and may throw Interrupted. */
  std::uint64_t FindOrInsert(std::uint64_t code, std::uint64_t next, MortonKey<Dim> first,
    const Execution& execution, double done)
  {
    Shard& shard = this->Shards[GetShardOf(code)];
    if (const std::uint64_t* number = shard.Find(code))
    {
      return *number;
    }
    if (!shard.HasRoom(shard.GetNumberOfKeys() + 1))
    {
      this->MakeRoom(shard, first);
      execution.Tell(done);
    }
    return shard.Insert(code, next);
  }

  /** Of all shards. */
  std::size_t GetBytes() const
  {
    std::size_t bytes = 0;
    for (const Shard& shard : this->Shards)
    {
      bytes += shard.GetBytes();
    }
    return bytes;
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
  using Shard = NodeTable<std::uint64_t>;
  static constexpr int ShardBits = 8;
  static constexpr std::size_t NumberOfShards = std::size_t(1) << ShardBits;
  static constexpr std::size_t RoomForEach = 4; ///< Open corner, so that room is rarely made.
  static constexpr std::size_t LeastRoom = 16;

  static std::size_t GetShardOf(std::uint64_t code)
  {
    // Another constant than that of the tables: a shard must not be one part of its table's slots.
    return static_cast<std::size_t>(code * 0xd6e8feb86659fd93U >> (64 - ShardBits));
  }

  /** Whether a node that begins at `first` or later can have the corner. */
  static bool IsOpen(std::uint64_t code, MortonKey<Dim> first)
  {
    constexpr std::uint32_t lastCell = (1U << MortonKey<Dim>::MaxDepth) - 1U;
    Cell<Dim> cell = DecodeCorner<Dim>(code);
    for (std::uint32_t& coordinate : cell)
    {
      coordinate = std::min(coordinate, lastCell);
    }
    return first <= InterleaveCell<Dim>(cell, MortonKey<Dim>::MaxDepth);
  }

  void MakeRoom(Shard& shard, MortonKey<Dim> first)
  {
    this->Kept.clear();
    shard.ForEach(
      [this, first](std::uint64_t code, std::uint64_t number)
      {
        if (IsOpen(code, first))
        {
          this->Kept.emplace_back(code, number);
        }
      });
    shard = Shard(std::max(RoomForEach * this->Kept.size(), LeastRoom));
    for (const auto& [code, number] : this->Kept)
    {
      shard.Insert(code, number);
    }
  }

  std::vector<Shard> Shards = std::vector<Shard>(NumberOfShards);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> Kept; ///< For MakeRoom() only.
};
}

#endif
