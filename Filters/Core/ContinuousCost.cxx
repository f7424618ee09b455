// SPDX-License-Identifier: BSD-3-Clause
#include "ContinuousCost.h"

#include <algorithm>
#include <cmath>

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
}

ContinuousCost::ContinuousCost(const DepthHistogram& histogram)
{
  double total = 0.0;
  for (const std::uint64_t weight : histogram)
  {
    total += static_cast<double>(weight);
  }
  for (std::size_t depth = 0; depth < histogram.size() && total > 0.0; ++depth)
  {
    this->Shares.push_back(static_cast<double>(histogram[depth]) / total);
  }
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

double ContinuousCost::GetMinimiser() const
{
  double below = 0.0;
  for (std::size_t depth = 0; depth < this->Shares.size(); ++depth)
  {
    const double share = this->Shares[depth];
    if (share > 0.0 && below + share >= 0.5)
    {
      // Root of 3 t^2 - 2 t^3 = wanted in [0, 1], in closed form.
      const double wanted = std::clamp((0.5 - below) / share, 0.0, 1.0);
      const double t = 0.5 - std::sin(std::asin(1.0 - 2.0 * wanted) / 3.0);
      return static_cast<double>(depth) + t;
    }
    below += share;
  }
  return 0.0;
}
}
