// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperFormat_h
#define Testing_Benchmarks_PaperFormat_h

#include "MarkdownRows.h"
#include "PaperTiming.h"

#include <string>

namespace paper_benchmark
{
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
}

#endif
