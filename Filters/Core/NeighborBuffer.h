// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NeighborBuffer_h
#define hashedoctree_NeighborBuffer_h

#include "Lanes.h"
#include "Neighbor.h"
#include "PlacesOfBits.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

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
  void AddChildren(PlainMachine, MortonKey<Dim> node, std::uint32_t octants, std::uint32_t block)
  {
    this->MakeRoom();
    Words leaf = GetWords({ node.GetChild(0), block });
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

#if defined(__x86_64__)
  /** The same by AVX2. */
  HASHEDOCTREE_WITH_AVX2 void AddChildren(
    Avx2Machine, MortonKey<Dim> node, std::uint32_t octants, std::uint32_t block)
  {
    this->MakeRoom();
    const Words leaf = GetWords({ node.GetChild(0), block });
    const __m256i other = _mm256_set1_epi64x(static_cast<long long>(leaf[1]));
    for (unsigned first = 0; first < MortonKey<Dim>::NumberOfOctants; first += Width)
    {
      const unsigned mask = octants >> first & ((1U << Width) - 1U);
      const __m256i keys = _mm256_set1_epi64x(static_cast<long long>(leaf[0] + first));
      Neighbor<Dim>* next = this->Leaves.data() + this->Size;
      for (unsigned done = 0; done < Width; done += 4, next += 4)
      {
        std::int32_t places;
        std::memcpy(&places, BitPlaces.Places[mask] + done, sizeof(places));
        const __m256i four = _mm256_cvtepu8_epi64(_mm_cvtsi32_si128(places)) + keys;
        const __m256i inTurn = _mm256_permute4x64_epi64(four, 0b11011000); // 0, 2, 1, 3
        auto* place = reinterpret_cast<__m256i*>(next);
        _mm256_storeu_si256(place, _mm256_unpacklo_epi64(inTurn, other));
        _mm256_storeu_si256(place + 1, _mm256_unpackhi_epi64(inTurn, other));
      }
      this->Size += BitPlaces.Count[mask];
    }
  }
#endif

  /** Puts what was added into the list. (Not inline: it is seldom needed, and takes registers from
   * what often is.) */
  [[gnu::noinline]] void Flush()
  {
    this->Found.insert(this->Found.end(), this->Leaves.begin(), this->Leaves.begin() + this->Size);
    this->Size = 0;
  }

private:
  /** A leaf as two numbers, as which it is written by fewer stores than by its parts; the first one
   * is the key. */
  using Words = std::array<std::uint64_t, 2>;

  static Words GetWords(const Neighbor<Dim>& leaf)
  {
    static_assert(sizeof(Words) == sizeof(leaf) && offsetof(Neighbor<Dim>, ParentBlock) == 8,
      "the second number holds the block, and nothing else");
    Words words{};
    std::memcpy(&words[0], &leaf.Key, sizeof(leaf.Key));
    std::memcpy(&words[1], &leaf.ParentBlock, sizeof(leaf.ParentBlock));
    return words;
  }

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
