// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_MarkdownRows_h
#define Testing_Benchmarks_MarkdownRows_h

#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

///@{
/** Rows of a table in Markdown. */
inline void WriteRow(std::ostream& out, const std::vector<std::string>& cells)
{
  out << "|";
  for (const std::string& cell : cells)
  {
    out << " " << cell << " |";
  }
  out << "\n";
}
inline void WriteHead(std::ostream& out, const std::vector<std::string>& cells)
{
  WriteRow(out, cells);
  WriteRow(out, std::vector<std::string>(cells.size(), "---"));
}
///@}

///@{
/** Numbers in them: with so many decimals, or with three digits, from a thousand on all of them. */
inline std::string Format(double number, int decimals)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, number);
  return text;
}
inline std::string Format(double number)
{
  const double size = std::abs(number);
  return Format(number, size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}
///@}

#endif
