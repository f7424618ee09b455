// SPDX-License-Identifier: BSD-3-Clause
#include "PaperMinimisers.h"

#include "ContinuousCost.h"
#include "OddHistogram.h"

#include <cmath>
#include <random>

namespace paper_benchmark
{
using hashedoctree::DepthHistogram;

MinimiserComparison CompareMinimisers(std::size_t histograms)
{
  std::mt19937 random(2008);
  MinimiserComparison comparison;
  for (; comparison.Histograms < histograms; ++comparison.Histograms)
  {
    const DepthHistogram histogram = MakeOddHistogram(random);
    const int discrete = hashedoctree::GetCheapestStartDepth(histogram);
    const int median = hashedoctree::GetMedianDepth(histogram);
    const double continuous = hashedoctree::ContinuousCost(histogram).GetMinimiser();
    const bool agree = median == discrete && static_cast<int>(std::floor(continuous)) == discrete;
    comparison.Agreeing += agree ? 1 : 0;
    comparison.WronglyRounded += std::lround(continuous) == discrete ? 0 : 1;
  }
  return comparison;
}
}
