// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_NodePool_h
#define Testing_Benchmarks_NodePool_h

#include "Buffer.h"

#include <algorithm>
#include <cstddef>
#include <vector>

/** Memory for the nodes of a tree with pointers, from where our own trees have it: in pieces as
 * large as all before, so that nodes never move, siblings stand side by side, and none costs an
 * allocation of its own. */
template <typename Node, std::size_t NodesOfFamily>
class NodePool
{
public:
  /** Side by side, without pointers. O(1) on average. */
  Node* AddSiblings()
  {
    if (this->Free == 0)
    {
      this->Free = std::max(this->Families, FamiliesOfFirstPiece);
      this->Pieces.emplace_back(this->Free * NodesOfFamily);
    }
    Piece& piece = this->Pieces.back();
    ++this->Families;
    Node* siblings = &piece[piece.GetSize() - this->Free-- * NodesOfFamily];
    std::fill_n(siblings, NodesOfFamily, Node{});
    return siblings;
  }

  /** Bytes of the nodes that were added. */
  std::size_t GetBytes() const { return this->Families * NodesOfFamily * sizeof(Node); }

private:
  using Piece = hashedoctree::Buffer<Node>;
  static constexpr std::size_t FamiliesOfFirstPiece = 256;

  std::vector<Piece> Pieces;
  std::size_t Families = 0;
  std::size_t Free = 0; ///< Families that the last piece has room for.
};

#endif
