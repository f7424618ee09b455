// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MortonKey_h
#define hashedoctree_MortonKey_h

#include "Dilation.h"

#include <array>
#include <cstdint>

namespace hashedoctree
{
/** The place of a cell in the grid of one depth: Dim integers in [0, 2^depth). */
template <int Dim>
using Cell = std::array<std::uint32_t, Dim>;

/** Place of the highest one of x, counted from bit 0. x must not be 0. */
constexpr int HighestBit(std::uint64_t x)
{
  return 63 - __builtin_clzll(x);
}

/**
 * The Morton key of a node (paper section 2): the root has key 1, and a child appends its octant,
 * Dim bits, to the key of its parent. The leading one tells the depth, so one integer names any
 * node of any depth, and a node's cell can be read back from it.
 *
 * In an octant the first coordinate is the HIGH bit (paper Figs. 2 and 4): in two dimensions the
 * octants 0, 1, 2, 3 are bottom-left, top-left, bottom-right, top-right. VTK's own octrees use the
 * first coordinate as the low bit.
 *
 * Keys of one depth are ordered along the Morton curve. Key 0 names no node. All members are
 * O(1) and free of side effects.
 */
template <int Dim>
class MortonKey
{
  static_assert(Dim >= 1 && Dim <= 4, "MortonKey knows 1 to 4 dimensions");

public:
  /** Depth of the smallest cells: 21 in 3D (63 bits and the leading one), 31 in 2D and 1D, where
   * a cell's coordinates are 32-bit integers, 15 in 4D. */
  static constexpr int MaxDepth = 63 / Dim < 31 ? 63 / Dim : 31;
  static constexpr int NumberOfOctants = 1 << Dim;
  /** Cells of MaxDepth along a side of the root. */
  static constexpr double CellsPerSide = static_cast<double>(std::uint64_t(1) << MaxDepth);

  /** MortonKey() is key 0; a variable without initialiser holds nothing yet, so that large arrays
   * of keys cost nothing before they are filled. */
  MortonKey() = default;
  explicit constexpr MortonKey(std::uint64_t value)
    : Value(value)
  {
  }

  static constexpr MortonKey Root() { return MortonKey(1); }

  /** Key of a cell of the grid at `depth`, in [0, MaxDepth], by dilation. The lowest bit of an axis
   * is its least significant one (paper E1). */
  static constexpr MortonKey FromCell(const Cell<Dim>& cell, int depth)
  {
    std::uint64_t value = std::uint64_t(1) << (Dim * depth);
    for (int axis = 0; axis < Dim; ++axis)
    {
      value |= Dilation<Dim>::Spread(cell[axis]) << (Dim - 1 - axis);
    }
    return MortonKey(value);
  }

  /** The cell that the key names, in the grid of its own depth. */
  constexpr Cell<Dim> GetCell() const
  {
    const std::uint64_t bits = this->Value ^ (std::uint64_t(1) << (Dim * this->GetDepth()));
    Cell<Dim> cell{};
    for (int axis = 0; axis < Dim; ++axis)
    {
      cell[axis] = Dilation<Dim>::Contract(bits >> (Dim - 1 - axis));
    }
    return cell;
  }

  /** Depth of the node, 0 for the root, by a bit scan. The key must not be 0. */
  constexpr int GetDepth() const { return HighestBit(this->Value) / Dim; }

  /** Which child of its parent the node is, in [0, 2^Dim); 1 for the root. */
  constexpr unsigned GetOctant() const
  {
    return static_cast<unsigned>(this->Value & (NumberOfOctants - 1));
  }

  constexpr MortonKey GetParent() const { return MortonKey(this->Value >> Dim); }
  constexpr MortonKey GetChild(unsigned octant) const
  {
    return MortonKey(this->Value << Dim | octant);
  }

  /** Of a key at MaxDepth: the key of its ancestor at `depth`, in [0, MaxDepth]. */
  constexpr MortonKey AtDepth(int depth) const
  {
    return MortonKey(this->Value >> (Dim * (MaxDepth - depth)));
  }

  /** The smallest and the largest of the keys at MaxDepth that lie in this node. */
  constexpr MortonKey GetFirstAtMaxDepth() const
  {
    return MortonKey(this->Value << (Dim * (MaxDepth - this->GetDepth())));
  }
  constexpr MortonKey GetLastAtMaxDepth() const
  {
    const int shift = Dim * (MaxDepth - this->GetDepth());
    return MortonKey(this->Value << shift | ((std::uint64_t(1) << shift) - 1));
  }

  /** Of two keys at MaxDepth: the depth of their deepest common ancestor. */
  static constexpr int GetCommonDepth(MortonKey a, MortonKey b)
  {
    const std::uint64_t difference = a.Value ^ b.Value;
    return difference == 0 ? MaxDepth : MaxDepth - 1 - HighestBit(difference) / Dim;
  }

  constexpr std::uint64_t GetValue() const { return this->Value; }

  friend constexpr bool operator==(MortonKey a, MortonKey b) { return a.Value == b.Value; }
  friend constexpr bool operator!=(MortonKey a, MortonKey b) { return a.Value != b.Value; }
  friend constexpr bool operator<(MortonKey a, MortonKey b) { return a.Value < b.Value; }
  friend constexpr bool operator>(MortonKey a, MortonKey b) { return b < a; }
  friend constexpr bool operator<=(MortonKey a, MortonKey b) { return a.Value <= b.Value; }

private:
  std::uint64_t Value;
};
}

#endif
