// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NeighborBuffer_h
#define hashedoctree_NeighborBuffer_h

#include "Neighbor.h"
#include "PlacesOfBits.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace hashedoctree
{
/** Leaves on their way to the end of a list, in the order in which they are added: the list takes
 * them together. Private to the neighbour searches. */
template <int Dim>
class NeighborBuffer
{
public:
  /** The list must outlive it. */
  explicit NeighborBuffer(std::vector<Neighbor<Dim>>& found)
    : Found(found)
  {
  }

  void Add(const Neighbor<Dim>& leaf)
  {
    this->MakeRoom();
    this->Leaves[this->Size++] = leaf;
  }

  /** Adds those children of a node whose bits are set, in the order of octants. `block` is the one
   * that describes them. */
  void AddChildren(
    MortonKey<Dim> node, std::uint32_t octants, std::uint32_t block, NeighborCase kind)
  {
    this->MakeRoom();
    // In two numbers, as which a leaf is written by two stores instead of three.
    const Neighbor<Dim> child = { node.GetChild(0), block, kind };
    std::array<std::uint64_t, 2> leaf;
    static_assert(sizeof(leaf) == sizeof(child), "the key is the first number");
    std::memcpy(leaf.data(), &child, sizeof(leaf));
    const std::uint64_t key = leaf[0];
    for (unsigned first = 0; first < MortonKey<Dim>::NumberOfOctants; first += Width)
    {
      const unsigned mask = octants >> first & ((1U << Width) - 1U);
      // As many are written as there can be: how many there are nobody could foresee.
      Neighbor<Dim>* next = this->Leaves.data() + this->Size;
      for (const std::uint8_t place : BitPlaces.Places[mask])
      {
        leaf[0] = key + first + place;
        std::memcpy(next++, leaf.data(), sizeof(leaf));
      }
      this->Size += BitPlaces.Count[mask];
    }
  }

  /** Puts what was added into the list. */
  void Flush()
  {
    this->Found.insert(this->Found.end(), this->Leaves.begin(), this->Leaves.begin() + this->Size);
    this->Size = 0;
  }

private:
  static constexpr unsigned Width =
    std::min<unsigned>(PlacesOfBits::Width, MortonKey<Dim>::NumberOfOctants);
  static constexpr std::size_t Most = 240; ///< With room behind it for the children of a node.

  void MakeRoom()
  {
    if (this->Size > Most)
    {
      this->Flush();
    }
  }

  std::vector<Neighbor<Dim>>& Found;
  std::array<Neighbor<Dim>, Most + MortonKey<Dim>::NumberOfOctants + PlacesOfBits::Width> Leaves;
  std::size_t Size = 0;
};
}

#endif
