// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PlacesOfBits_h
#define hashedoctree_PlacesOfBits_h

#include <cstdint>

namespace hashedoctree
{
/** For each mask of eight bits, the places of those that are set, in order, and how many they are:
 * for what is chosen by a mask without a branch for each bit, which nobody could foresee. */
struct PlacesOfBits
{
  static constexpr unsigned Width = 8;

  alignas(Width) std::uint8_t Places[1U << Width][Width] = {}; ///< 0 behind the last.
  std::uint8_t Count[1U << Width] = {};

  constexpr PlacesOfBits()
  {
    for (unsigned mask = 0; mask < 1U << Width; ++mask)
    {
      for (unsigned place = 0; place < Width; ++place)
      {
        if ((mask >> place & 1U) != 0)
        {
          this->Places[mask][this->Count[mask]++] = static_cast<std::uint8_t>(place);
        }
      }
    }
  }
};

/** The table. */
inline constexpr PlacesOfBits BitPlaces{};
}

#endif
