// SPDX-License-Identifier: BSD-3-Clause
#include "PaperMinimisers.h"

#include "ContinuousCost.h"
#include "OddHistogram.h"

#include <cmath>
#include <random>

namespace paper_benchmark
{
using hashedoctree::DepthHistogram;

namespace
{
/** The same histogram twice, one below the other: half of the weight lies up to the first's last
 * depth. */
DepthHistogram MakeTie(DepthHistogram histogram)
{
  const DepthHistogram upper = histogram;
  histogram.insert(histogram.end(), upper.begin(), upper.end());
  return histogram;
}

int GetIntegerPart(const DepthHistogram& histogram)
{
  return static_cast<int>(std::floor(hashedoctree::ContinuousCost(histogram).GetMinimiser()));
}
}

MinimiserComparison CompareMinimisers(std::size_t histograms)
{
  std::mt19937 random(2008);
  MinimiserComparison comparison;
  for (; comparison.Histograms < histograms; ++comparison.Histograms)
  {
    const DepthHistogram histogram = MakeOddHistogram(random);
    const int discrete = hashedoctree::GetBestStartDepth(histogram);
    const int median = hashedoctree::GetMedianDepth(histogram);
    const double continuous = hashedoctree::ContinuousCost(histogram).GetMinimiser();
    const bool agree = median == discrete && GetIntegerPart(histogram) == discrete;
    comparison.Agreeing += agree ? 1 : 0;
    comparison.WronglyRounded += std::lround(continuous) == discrete ? 0 : 1;
    const DepthHistogram tie = MakeTie(histogram);
    const int ofTie = hashedoctree::GetMedianDepth(tie);
    const bool isBest = std::abs(hashedoctree::GetMeanCost(tie, GetIntegerPart(tie)) -
                          hashedoctree::GetMeanCost(tie, ofTie)) < 1e-9;
    comparison.BestInTies += isBest ? 1 : 0;
    comparison.OtherInTies += isBest && GetIntegerPart(tie) != ofTie ? 1 : 0;
  }
  return comparison;
}
}
