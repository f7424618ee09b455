// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_NodePool_h
#define Testing_Benchmarks_NodePool_h

#include <cstddef>
#include <memory>
#include <vector>

/** Memory for the nodes of a tree with pointers: in large pieces, so that nodes never move,
 * siblings stand side by side, and none costs an allocation of its own. */
template <typename Node, std::size_t NodesOfFamily>
class NodePool
{
public:
  /** Side by side, without pointers. O(1). */
  Node* AddSiblings()
  {
    if (this->Families % FamiliesOfPiece == 0)
    {
      this->Pieces.push_back(std::make_unique<Node[]>(FamiliesOfPiece * NodesOfFamily));
    }
    return &this->Pieces.back()[this->Families++ % FamiliesOfPiece * NodesOfFamily];
  }

  /** Bytes of the nodes that were added. */
  std::size_t GetBytes() const { return this->Families * NodesOfFamily * sizeof(Node); }

private:
  static constexpr std::size_t FamiliesOfPiece = 4096;

  std::vector<std::unique_ptr<Node[]>> Pieces;
  std::size_t Families = 0;
};

#endif
