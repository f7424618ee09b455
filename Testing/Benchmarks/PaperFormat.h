// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperFormat_h
#define Testing_Benchmarks_PaperFormat_h

#include "PaperTiming.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace paper_benchmark
{
std::string Format(double number, int decimals);
/** Three digits or more. */
std::string Format(double number);
/** Three digits or more, and three decimals below 1: for numbers that can be small. */
std::string FormatSmall(double number);
/** "12%", of a share. */
std::string FormatPercent(double share);
/** "0.123 ~12%": a median, times `unit`, and its spread. */
std::string FormatTime(const Spread& time, double unit);
/** A number of the paper, as it stands there but for zeros at its end. */
std::string FormatPrinted(double number);
/** "ours (the paper's)". */
std::string FormatBeside(const std::string& ours, const std::string& paper);

/** Rows of a table in Markdown. */
void WriteRow(std::ostream& out, const std::vector<std::string>& cells);
void WriteHead(std::ostream& out, const std::vector<std::string>& cells);
}

#endif
