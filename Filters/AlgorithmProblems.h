// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmProblems_h
#define AlgorithmProblems_h

#include "vtkAlgorithm.h"
#include "vtkInformationVector.h"

#include <string>

namespace hashedoctree
{
/** What to tell the user of the std::exception that is being handled: `ofMemory` where there was
 * not enough of it. Anything else passes through. Private to the module. */
std::string DescribeProblem(const char* ofMemory);

/**
 * What a RequestData() does about the exception that is being handled: Interrupted when the
 * algorithm was aborted, else a std::exception with what to tell the user, which becomes one error
 * of the algorithm. In both cases all outputs are emptied, and the request is done: where one
 * fails, VTK leaves what follows as it was, and ParaView's views never draw the filter again.
 * Private to the module.
 */
void ReportProblem(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);
}

#endif
