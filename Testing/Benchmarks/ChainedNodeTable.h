// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_ChainedNodeTable_h
#define Testing_Benchmarks_ChainedNodeTable_h

#include "LargePagesResource.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * A hash table with chains: a node stands in the slot of its hash, and where that is taken in one
 * behind all slots, chained to it. So it holds any number of nodes, however many slots the hash
 * has. `Node` has the members Key, 0 in a free slot, and Next, 32 bits for the chain.
 */
template <typename Node, typename Hash>
class ChainedNodeTable
{
public:
  using NodeVector = std::pmr::vector<Node>;

  explicit ChainedNodeTable(const Hash& hash)
    : Slots(hash)
    , Nodes(hash.GetNumberOfSlots(), GetLargePages())
  {
  }

  /** Adds a node whose key is not in the table yet. O(1). */
  void Insert(Node node)
  {
    Node& home = this->Nodes[this->Slots.GetSlot(node.Key)];
    if (home.Key == 0)
    {
      home = node;
      return;
    }
    node.Next = home.Next;
    home.Next = static_cast<std::uint32_t>(this->Nodes.size());
    this->Nodes.push_back(node);
  }

  /** The node of a key, not 0, or null. O(length of the chain). */
  const Node* Find(std::uint64_t key) const
  {
    const Node* node = &this->Nodes[this->Slots.GetSlot(key)];
    while (node->Key != key)
    {
      if (node->Next == 0)
      {
        return nullptr;
      }
      node = &this->Nodes[node->Next];
    }
    return node;
  }

  /** How many keys are found by looking at i + 1 nodes, at index i. O(slots + nodes). */
  std::vector<std::size_t> GetProbeLengths() const
  {
    std::vector<std::size_t> lengths;
    for (std::size_t slot = 0; slot < this->Slots.GetNumberOfSlots(); ++slot)
    {
      const Node* node = &this->Nodes[slot];
      for (std::size_t place = 0; node->Key != 0; ++place)
      {
        if (place == lengths.size())
        {
          lengths.push_back(0);
        }
        ++lengths[place];
        if (node->Next == 0)
        {
          break;
        }
        node = &this->Nodes[node->Next];
      }
    }
    return lengths;
  }

  /** All slots, free ones too, and the nodes behind them. */
  const NodeVector& GetNodes() const { return this->Nodes; }

private:
  Hash Slots;
  NodeVector Nodes;
};

#endif
