// SPDX-License-Identifier: BSD-3-Clause
#include "KeyMatch.h"

#include <gtest/gtest.h>

#include <array>

using namespace hashedoctree;

namespace
{
constexpr std::uint64_t Wanted = 0x0123456789abcdef;
constexpr std::uint64_t OtherLowerHalf = Wanted ^ 1U;
constexpr std::uint64_t OtherUpperHalf = Wanted ^ (std::uint64_t(1) << 63);
constexpr std::uint64_t HalvesSwapped = Wanted << 32 | Wanted >> 32;
}

TEST(TestKeyMatch, OnlyWholeKeysMatch)
{
  const std::array<std::uint64_t, 6> choices{ Wanted, OtherLowerHalf, OtherUpperHalf, HalvesSwapped,
    ~Wanted, 0 };
  std::array<std::size_t, MatchedKeys> chosen{};
  alignas(16) std::array<std::uint64_t, MatchedKeys> keys{};
  do
  {
    unsigned expected = 0;
    for (unsigned i = 0; i < MatchedKeys; ++i)
    {
      keys[i] = choices[chosen[i]];
      expected |= (chosen[i] == 0 ? 1U : 0U) << i;
    }
    ASSERT_EQ(MatchKeys(keys.data(), Wanted), expected);
    ASSERT_EQ(MatchKeysPlainly(keys.data(), Wanted), expected);

    // The next choice, as one counts.
    for (std::size_t& choice : chosen)
    {
      choice = (choice + 1) % choices.size();
      if (choice != 0)
      {
        break;
      }
    }
  } while (chosen != std::array<std::size_t, MatchedKeys>{});
}

TEST(TestKeyMatch, FindsZero)
{
  alignas(16) const std::array<std::uint64_t, MatchedKeys> keys{ 0, 1, std::uint64_t(1) << 32, 0 };
  EXPECT_EQ(MatchKeys(keys.data(), 0), 0b1001U);
  EXPECT_EQ(MatchKeysPlainly(keys.data(), 0), 0b1001U);
}
