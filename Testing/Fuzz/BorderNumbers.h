// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_BorderNumbers_h
#define Testing_Fuzz_BorderNumbers_h

#include <iterator>
#include <limits>

// Numbers at which searches may go wrong, one for any argument.

/** The unit that points are made in. */
inline double GetScale(unsigned i)
{
  constexpr double scales[] = { 1.0, 0.1, 0x1p-21, 0x1p-22, 0x1p-30, 1e-9, 1e-15, 1e-30, 1e-160,
    1e-310, 1e3, 1e6, 1e15, 1e30, 1e150, 1e300 };
  return scales[i % std::size(scales)];
}

/** A coordinate of the place that they are made around. */
inline double GetOffset(unsigned i)
{
  constexpr double offsets[] = { 0.0, 1.0, -1.0, 0.1, 1e6, -1e6, 1e15, 1e150 };
  return offsets[i % std::size(offsets)];
}

/** A border case of coordinates and radii. */
inline double GetSpecial(unsigned i)
{
  using Limits = std::numeric_limits<double>;
  constexpr double specials[] = { Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
    Limits::max(), -Limits::max(), Limits::max() / 2, Limits::max() / 4, -Limits::max() / 4, 1e154,
    1e-154, Limits::min(), Limits::denorm_min(), -Limits::denorm_min(), 0.0, -0.0, -1.0 };
  return specials[i % std::size(specials)];
}

#endif
