// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Dilation_h
#define hashedoctree_Dilation_h

#include <cstdint>

namespace hashedoctree
{
/**
 * Integer dilation (paper section 2, after its reference [11]): spreading the bits of an integer
 * so that bit i comes to stand at bit Dim * i, and contracting them back. Interleaving Dim dilated
 * integers gives a Morton key but for its leading 1. The magic masks are derived here instead of
 * being written out, so that every dimension uses one body.
 */
template <int Dim>
struct Dilation
{
  /** Groups of `group` ones, one group in every Dim * group bits, over 64 bits. */
  static constexpr std::uint64_t Mask(int group)
  {
    std::uint64_t mask = 0;
    for (int bit = 0; bit < 64; ++bit)
    {
      if (bit % (Dim * group) < group)
      {
        mask |= std::uint64_t(1) << bit;
      }
    }
    return mask;
  }

  /** Bit i of x goes to bit Dim * i. Bits that would leave the 64 are lost. */
  static constexpr std::uint64_t Spread(std::uint32_t x) { return SpreadGroups<32>(x); }

  /** The reverse of Spread(): bit Dim * i goes to bit i; the other bits of x are ignored. */
  static constexpr std::uint32_t Contract(std::uint64_t x)
  {
    return static_cast<std::uint32_t>(ContractGroups<1>(x & Mask(1)));
  }

private:
  template <int Group>
  static constexpr std::uint64_t SpreadGroups(std::uint64_t x)
  {
    if constexpr (Group == 0)
    {
      return x;
    }
    else
    {
      if constexpr (Group * (Dim - 1) < 64)
      {
        x = (x | x << (Group * (Dim - 1))) & Mask(Group);
      }
      return SpreadGroups<Group / 2>(x);
    }
  }

  template <int Group>
  static constexpr std::uint64_t ContractGroups(std::uint64_t x)
  {
    if constexpr (Group == 32 || Group * (Dim - 1) >= 64)
    {
      return x;
    }
    else
    {
      return ContractGroups<Group * 2>((x | x >> (Group * (Dim - 1))) & Mask(Group * 2));
    }
  }
};
}

#endif
