// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_RunError_h
#define Testing_Benchmarks_RunError_h

#include <string>

///@{
/** What went wrong in a run of Google Benchmark; empty when nothing did. Since its version 1.8 the
 * member has another name. */
template <typename Run>
auto GetRunError(const Run& run) -> decltype(std::string(run.error_message))
{
  return run.error_message;
}
template <typename Run>
auto GetRunError(const Run& run) -> decltype(std::string(run.skip_message))
{
  return run.skip_message;
}
///@}

#endif
