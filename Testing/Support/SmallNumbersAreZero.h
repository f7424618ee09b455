// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_SmallNumbersAreZero_h
#define Testing_Support_SmallNumbersAreZero_h

#if defined(__SSE2__) // Elsewhere the mode is set in other ways.
#include <xmmintrin.h>

namespace hashedoctree
{
/** While it lives, the processor takes numbers below 2.3e-308 for zero, as fast math asks for. */
class SmallNumbersAreZero
{
public:
  SmallNumbersAreZero() { _mm_setcsr(this->Before | FlushToZero | DenormalsAreZero); }
  ~SmallNumbersAreZero() { _mm_setcsr(this->Before); }
  SmallNumbersAreZero(const SmallNumbersAreZero&) = delete;
  SmallNumbersAreZero& operator=(const SmallNumbersAreZero&) = delete;

private:
  static constexpr unsigned FlushToZero = 0x8000;
  static constexpr unsigned DenormalsAreZero = 0x40;
  unsigned Before = _mm_getcsr();
};
}
#endif

#endif
