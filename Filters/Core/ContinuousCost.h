// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_ContinuousCost_h
#define hashedoctree_ContinuousCost_h

#include "DepthStatistics.h"

namespace hashedoctree
{
/**
 * The differentiable cost of the paper's appendix. The weight of each depth l is spread over
 * [l, l + 1] as a parabola that vanishes at both ends; the parabola stands for the PRODUCT p_l *
 * f_l (two parabolas multiplied would have another area, paper E8). Its derivative is F - (1 - F)
 * for the distribution F of the weight, so the minimiser is the continuous median, and the integer
 * part of that is a cheapest start depth (E9): the only one, unless exactly half of the weight lies
 * up to some depth. Then that depth, which GetMedianDepth() gives (E23), and the next, which this
 * gives, are equally cheap.
 *
 * A depth's weight is centered at l + 1/2. So the cost at h + 1/2 belongs to the start depth h, and
 * exceeds the discrete cost there by 3/16 of the share of depth h, exactly: it does not interpolate
 * (E8). All this holds for sums of weights below 2^53, which are exact.
 */
class ContinuousCost
{
public:
  /** Of a histogram with or without weight; O(depths). */
  explicit ContinuousCost(const DepthHistogram& histogram);

  /** Mean cost of starting at a continuous depth, 1 included for the node that is always examined.
   * Any x, also beyond the histogram. 0 for a histogram of no weight. O(depths). */
  double GetCost(double x) const;

  /** Share of the weight below x, F(x): from 0 to 1, up to rounding. O(depths). */
  double GetDistribution(double x) const;

  /** Where the cost is least; the smallest such place when half of the weight lies on either side
   * of a gap. 0 for a histogram of no weight. */
  double GetMinimiser() const { return this->Minimiser; }

private:
  std::vector<double> Shares; ///< Of the weight, at each depth.
  double Minimiser = 0.0;
};
}

#endif
