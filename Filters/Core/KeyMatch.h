// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_KeyMatch_h
#define hashedoctree_KeyMatch_h

#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace hashedoctree
{
constexpr unsigned MatchedKeys = 4;

/** Which of MatchedKeys keys are the wanted one: bit i for key i. */
inline unsigned MatchKeysPlainly(const std::uint64_t* keys, std::uint64_t wanted)
{
  unsigned match = 0;
  for (unsigned i = 0; i < MatchedKeys; ++i)
  {
    match |= (keys[i] == wanted ? 1U : 0U) << i;
  }
  return match;
}

/** The same by SSE2 where it is compiled for that. The keys must be aligned to 16 bytes. */
inline unsigned MatchKeys(const std::uint64_t* keys, std::uint64_t wanted)
{
#ifdef __SSE2__
  // Halves of keys are what SSE2 compares; both must be the same.
  const __m128i both = _mm_set1_epi64x(static_cast<long long>(wanted));
  const auto compare = [both](const std::uint64_t* pair)
  {
    const __m128i same =
      _mm_cmpeq_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(pair)), both);
    return _mm_castsi128_ps(_mm_and_si128(same, _mm_shuffle_epi32(same, 0xb1)));
  };
  return static_cast<unsigned>(
    _mm_movemask_ps(_mm_shuffle_ps(compare(keys), compare(keys + 2), 0x88)));
#else
  return MatchKeysPlainly(keys, wanted);
#endif
}
}

#endif
