// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmProblems_h
#define AlgorithmProblems_h

#include "vtkAlgorithm.h"
#include "vtkInformationVector.h"

namespace hashedoctree
{
/** What RunReportingProblems() does about the exception that is being handled. */
void ReportProblem(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);

/**
 * Runs the body of a RequestData(). The body throws Interrupted when the algorithm was aborted, and
 * std::exception with what to tell the user, which becomes one error of the algorithm. In both
 * cases all outputs are emptied, and the request is done: where one fails, VTK leaves what follows
 * as it was, and ParaView's views never draw the filter again. Private to the module.
 */
template <typename Body>
void RunReportingProblems(
  vtkAlgorithm* algorithm, vtkInformationVector* outputVector, const Body& body)
{
  try
  {
    body();
  }
  catch (...)
  {
    ReportProblem(algorithm, outputVector);
  }
}
}

#endif
