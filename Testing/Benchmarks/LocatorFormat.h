// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorFormat_h
#define Testing_Benchmarks_LocatorFormat_h

#include "LocatorResults.h"
#include "MarkdownRows.h"

#include <cmath>
#include <cstdio>

namespace locator_benchmark
{
/** As Format(), but two digits of small numbers, and a dash for what was not measured. */
inline std::string FormatNumber(double number)
{
  if (std::isnan(number))
  {
    return "-";
  }
  if (number == 0.0 || std::abs(number) >= 0.0995)
  {
    return Format(number);
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", number);
  return text;
}

inline std::string FormatTime(double seconds)
{
  return std::isnan(seconds) ? "-"
    : seconds < 1e-6         ? FormatNumber(1e9 * seconds) + " ns"
    : seconds < 1e-3         ? FormatNumber(1e6 * seconds) + " us"
    : seconds < 1.0          ? FormatNumber(1e3 * seconds) + " ms"
                             : FormatNumber(seconds) + " s";
}

/** How many times as long as `base` something takes; not a number when one was not measured. */
inline double GetRatio(
  const LocatorResults& results, const LocatorCase& which, const LocatorCase& base)
{
  return results.GetSeconds(which) / results.GetSeconds(base);
}
}

#endif
