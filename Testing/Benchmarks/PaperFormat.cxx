// SPDX-License-Identifier: BSD-3-Clause
#include "PaperFormat.h"

#include <cmath>
#include <cstdio>

namespace paper_benchmark
{
std::string FormatSmall(double number)
{
  return std::abs(number) < 0.9995 ? Format(number, 3) : Format(number);
}

std::string FormatPercent(double share)
{
  return Format(100.0 * share, 0) + "%";
}

std::string FormatTime(const Spread& time, double unit)
{
  return FormatSmall(unit * time.Median) + " ~" + FormatPercent(GetWidth(time));
}

std::string FormatPrinted(double number)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.6g", number);
  return text;
}

std::string FormatBeside(const std::string& ours, const std::string& paper)
{
  return ours + " (" + paper + ")";
}
}
