// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmProblems_h
#define AlgorithmProblems_h

#include "vtkAlgorithm.h"
#include "vtkInformationVector.h"

namespace hashedoctree
{
/** What RunReportingProblems() does about the exception that is being handled. */
int ReportProblem(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);

/**
 * Runs the body of a RequestData() and returns what that must return. The body throws Interrupted
 * when the algorithm was aborted, and std::exception with what to tell the user, which becomes one
 * error of the algorithm. In both cases all outputs are emptied. Private to the module.
 */
template <typename Body>
int RunReportingProblems(
  vtkAlgorithm* algorithm, vtkInformationVector* outputVector, const Body& body)
{
  try
  {
    body();
    return 1;
  }
  catch (...)
  {
    return ReportProblem(algorithm, outputVector);
  }
}
}

#endif
