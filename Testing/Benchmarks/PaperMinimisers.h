// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperMinimisers_h
#define Testing_Benchmarks_PaperMinimisers_h

#include <cstddef>

namespace paper_benchmark
{
/** How many random histograms of depths the best start depth was looked for in, and how it was
 * found (paper's Fig. 8 and appendix, E9). */
struct MinimiserComparison
{
  std::size_t Histograms = 0;
  /** Where the discrete minimum is the weighted median and the integer part of the continuous. */
  std::size_t Agreeing = 0;
  std::size_t WronglyRounded = 0; ///< The continuous minimiser, rounded, is not the discrete one.
  /** Of as many others, in each of which half of the weight lies up to some depth: where the
   * integer part costs as little as the median, and where it is another depth then (E23). */
  std::size_t BestInTies = 0;
  std::size_t OtherInTies = 0;
};

/** Of the histograms of MakeOddHistogram(), in which there are no ties, the same ones each time. */
MinimiserComparison CompareMinimisers(std::size_t histograms);
}

#endif
