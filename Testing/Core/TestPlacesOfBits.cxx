// SPDX-License-Identifier: BSD-3-Clause
#include "PlacesOfBits.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

TEST(TestPlacesOfBits, AreInOrder)
{
  constexpr PlacesOfBits bits;
  for (unsigned mask = 0; mask < 1U << PlacesOfBits::Width; ++mask)
  {
    unsigned count = 0;
    for (unsigned place = 0; place < PlacesOfBits::Width; ++place)
    {
      if ((mask & 1U << place) != 0)
      {
        EXPECT_EQ(bits.Places[mask][count], place) << mask;
        ++count;
      }
    }
    EXPECT_EQ(bits.Count[mask], count) << mask;
    for (; count < PlacesOfBits::Width; ++count)
    {
      EXPECT_EQ(bits.Places[mask][count], 0) << mask;
    }
  }
}
