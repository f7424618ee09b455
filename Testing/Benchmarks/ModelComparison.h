// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_ModelComparison_h
#define Testing_Benchmarks_ModelComparison_h

#include "PaperResults.h"

namespace paper_benchmark
{
/** How the right frequency model of a row of Table 3 does beside the others. */
enum class ModelOutcome
{
  Alike, ///< All models have the same start depth.
  Wins,  ///< Each model with another start depth is slower.
  Ties,
  Loses ///< It is slower than one of them.
};

struct ModelComparison
{
  ModelOutcome Outcome;
  double BestOther; ///< Time of the fastest of the others over that of the right one; 1 of Alike.
  double Width; ///< The largest spread of the times that are compared, as GetWidth(); 0 of Alike.
};

/** The models of one row, 0 to 2, which is also the place of the right one. One time is slower than
 * another as IsSlower() has it. */
ModelComparison CompareModels(
  const PaperResults& set, WorkloadTimes PaperResults::*times, std::size_t row);
}

#endif
