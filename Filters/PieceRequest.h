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

/** Those that have the other pieces: of the algorithm's controller when as many pieces are asked
 * for as it has processes, and of each its own, else this one alone, with its part
 * where several are asked for. By what the output says that the request came from. */
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
