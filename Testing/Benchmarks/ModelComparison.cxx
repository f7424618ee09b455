// SPDX-License-Identifier: BSD-3-Clause
#include "ModelComparison.h"

#include <algorithm>
#include <limits>

namespace paper_benchmark
{
ModelComparison CompareModels(
  const PaperResults& set, WorkloadTimes PaperResults::*times, std::size_t row)
{
  const auto& cells = (set.*times)[row];
  const Spread& own = cells[row];
  double best = std::numeric_limits<double>::infinity();
  double width = GetWidth(own);
  bool wins = true;
  bool loses = false;
  for (std::size_t model = 0; model < NumberOfModels; ++model)
  {
    if (set.Frequencies[model].StartDepth != set.Frequencies[row].StartDepth)
    {
      best = std::min(best, cells[model].Median);
      width = std::max(width, GetWidth(cells[model]));
      wins = wins && IsSlower(cells[model], own);
      loses = loses || IsSlower(own, cells[model]);
    }
  }
  if (best == std::numeric_limits<double>::infinity())
  {
    return { ModelOutcome::Alike, 1.0, 0.0 };
  }
  return { wins ? ModelOutcome::Wins
      : loses   ? ModelOutcome::Loses
                : ModelOutcome::Ties,
    best / own.Median, width };
}
}
