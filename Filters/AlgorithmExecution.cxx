// SPDX-License-Identifier: BSD-3-Clause
#include "AlgorithmExecution.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>

namespace hashedoctree
{
namespace
{
bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/** Parts of a range for each thread: enough to share it out evenly. To some backends each part is a
 * job that wakes a thread. */
constexpr vtkIdType PartsPerThread = 8;

void RunOnThreads(
  std::size_t first, std::size_t last, std::size_t grain, const Execution::Body& body)
{
  const auto count = static_cast<vtkIdType>(last - first);
  const vtkIdType parts = PartsPerThread * vtkSMPTools::GetEstimatedNumberOfThreads();
  vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last),
    std::max(static_cast<vtkIdType>(grain), count / parts),
    [&body](vtkIdType from, vtkIdType to)
    { body(static_cast<std::size_t>(from), static_cast<std::size_t>(to)); });
}
}

Execution MakeExecution(vtkAlgorithm* algorithm)
{
  return Execution(RunOnThreads,
    [algorithm](double fraction)
    {
      algorithm->UpdateProgress(fraction);
      return !IsAborted(algorithm);
    });
}

Execution MakeExecution(vtkObject* object, const bool& isAborted)
{
  return Execution(RunOnThreads,
    [object, &isAborted](double fraction)
    {
      object->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
      return !isAborted;
    });
}

Execution MakeExecution()
{
  return Execution(RunOnThreads);
}
}
