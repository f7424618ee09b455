// SPDX-License-Identifier: BSD-3-Clause
#include "AlgorithmExecution.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>

namespace hashedoctree
{
namespace
{
bool IsAborted(vtkAlgorithm* algorithm)
{
// Between VTK 9.2 and 9.3; ParaView 5.11 has a VTK from there, which counts as 9.2 of its date.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230101)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

std::size_t GetNumberOfThreads()
{
  return static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
}

void RunOnThreads(
  std::size_t first, std::size_t last, std::size_t grain, const Execution::Body& body)
{
  const auto count = static_cast<vtkIdType>(last - first);
  const auto parts = static_cast<vtkIdType>(Execution::GrainsPerThread * GetNumberOfThreads());
  // What leaves a thread of vtkSMPTools ends the program, or is lost, depending on the version.
  std::atomic<bool> failed{ false };
  std::exception_ptr error;
  const auto runPart = [&](vtkIdType from, vtkIdType to)
  {
    if (failed)
    {
      return;
    }
    try
    {
      body(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    }
    catch (...)
    {
      if (!failed.exchange(true))
      {
        error = std::current_exception();
      }
    }
  };
  try
  {
    vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last),
      std::max(static_cast<vtkIdType>(grain), count / parts), runPart);
  }
  catch (const std::system_error& noThread) // The first: VTK ends the program for another.
  {
    throw std::runtime_error(std::string("vtkSMPTools cannot start a thread (") + noThread.what() +
      "); free memory, or choose its backend Sequential.");
  }
  if (error)
  {
    std::rethrow_exception(error);
  }
}
}

Execution MakeExecution(vtkAlgorithm* algorithm)
{
  return Execution(
    RunOnThreads,
    [algorithm](double fraction)
    {
      algorithm->UpdateProgress(fraction);
      return !IsAborted(algorithm);
    },
    {}, GetNumberOfThreads());
}

Execution MakeExecution(vtkObject* object, StopSign stop)
{
  return Execution(
    RunOnThreads,
    [object, stop](double fraction)
    {
      object->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
      return !stop.IsUp();
    },
    stop, GetNumberOfThreads());
}

Execution MakeExecution()
{
  return Execution(RunOnThreads);
}
}
