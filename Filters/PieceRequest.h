// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceRequest_h
#define PieceRequest_h

#include "AlgorithmProblems.h"
#include "ProcessGroup.h"

#include "vtkHashedOctreeAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace hashedoctree
{
// What a REQUEST_DATA says of the pieces of a distributed data set, and how it is done together
// with those who have the others. Private to the module.

/** The processes of the algorithm's controller, where the output that the request came from is
 * asked for as many pieces as there are of them, and here for this one's. Else this process alone,
 * which has but a part of the data where several pieces are asked for. */
ProcessGroup FindProcesses(
  vtkHashedOctreeAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputVector);

/** Makes the next update execute again. */
void ForgetOutputs(vtkInformationVector* outputVector);

/** Calls body(processes), which they run together, and reports its problem. After a problem of one
 * all of them execute again at their next update, unless a filter behind them thinks it needs none,
 * since one that was aborted does. Returns what the RequestData() must return. */
template <typename Body>
int RunTogether(vtkHashedOctreeAlgorithm* algorithm, vtkInformation* request,
  vtkInformationVector* outputVector, const Body& body)
{
  const ProcessGroup processes = FindProcesses(algorithm, request, outputVector);
  try
  {
    processes.Together([&] { body(processes); });
  }
  catch (...)
  {
    ReportProblem(algorithm, outputVector);
    if (processes.AreSeveral())
    {
      ForgetOutputs(outputVector);
    }
  }
  return 1;
}
}

#endif
