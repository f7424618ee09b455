// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmExecution_h
#define AlgorithmExecution_h

#include "Execution.h"

#include <atomic>

class vtkAlgorithm;
class vtkObject;

namespace hashedoctree
{
/** What a vtkAlgorithm lends to the core while it runs: vtkSMPTools as threads, UpdateProgress(),
 * and the abort flag. Private to the module. */
Execution MakeExecution(vtkAlgorithm* algorithm);

/** The same of an object that is no algorithm: ProgressEvent with the fraction done, after which
 * the flag is looked at. */
Execution MakeExecution(vtkObject* object, const std::atomic<bool>& isAborted);

/** vtkSMPTools as threads, and no reports, for what no algorithm runs. */
Execution MakeExecution();
}

#endif
