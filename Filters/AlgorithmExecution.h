// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmExecution_h
#define AlgorithmExecution_h

#include "Execution.h"

#include "vtkAlgorithm.h"
#include "vtkObject.h"

namespace hashedoctree
{
/** What a vtkAlgorithm lends to the core while it runs: vtkSMPTools as threads, UpdateProgress(),
 * and the abort flag. Private to the module. */
Execution MakeExecution(vtkAlgorithm* algorithm);

/** The same of an object that is no algorithm: ProgressEvent with the fraction done, and a sign to
 * stop. */
Execution MakeExecution(vtkObject* object, StopSign stop);

/** vtkSMPTools as threads, and no reports, for what no algorithm runs. */
Execution MakeExecution();
}

#endif
