// SPDX-License-Identifier: BSD-3-Clause
#include "ContinuousCost.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hashedoctree
{
namespace
{
/** Integral of the parabola 6 t (1 - t) over [0, t]. */
double ParabolaArea(double t)
{
  return t * t * (3.0 - 2.0 * t);
}

/** Integral of 6 s (1 - s) |t - s| over s in [0, 1], for any t. */
double ParabolaDistance(double t)
{
  if (t <= 0.0 || t >= 1.0)
  {
    return std::abs(t - 0.5);
  }
  return t * t * t * (2.0 - t) - t + 0.5;
}

/** Where the distribution of some weight is a half: decided by whole weights, since rounded shares
 * miss where exactly half lies up to a depth. */
double FindMinimiser(const DepthHistogram& histogram)
{
  const auto median = static_cast<std::size_t>(GetMedianDepth(histogram));
  const std::uint64_t below = std::accumulate(
    histogram.begin(), histogram.begin() + static_cast<std::ptrdiff_t>(median), std::uint64_t(0));
  const std::uint64_t weight = histogram[median];
  const std::uint64_t above = GetTotal(histogram) - below - weight;
  // Not more than the weight either way, and less than half of what 64 bits hold.
  const auto excess = static_cast<double>(static_cast<std::int64_t>(above - below));
  // Root of 3 t^2 - 2 t^3 = wanted in [0, 1], in closed form; 1, also as it is rounded, where
  // exactly half lies up to the median.
  const double wanted = 0.5 + excess / 2.0 / static_cast<double>(weight);
  return static_cast<double>(median) + 0.5 - std::sin(std::asin(1.0 - 2.0 * wanted) / 3.0);
}
}

ContinuousCost::ContinuousCost(const DepthHistogram& histogram)
{
  const auto total = static_cast<double>(GetTotal(histogram));
  if (total == 0.0)
  {
    return;
  }
  for (const std::uint64_t weight : histogram)
  {
    this->Shares.push_back(static_cast<double>(weight) / total);
  }
  this->Minimiser = FindMinimiser(histogram);
}

double ContinuousCost::GetCost(double x) const
{
  if (this->Shares.empty())
  {
    return 0.0;
  }
  double cost = 1.0;
  for (std::size_t depth = 0; depth < this->Shares.size(); ++depth)
  {
    cost += this->Shares[depth] * ParabolaDistance(x - static_cast<double>(depth));
  }
  return cost;
}

double ContinuousCost::GetDistribution(double x) const
{
  double share = 0.0;
  for (std::size_t depth = 0; depth < this->Shares.size(); ++depth)
  {
    share +=
      this->Shares[depth] * ParabolaArea(std::clamp(x - static_cast<double>(depth), 0.0, 1.0));
  }
  return share;
}
}
