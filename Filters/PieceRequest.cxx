// SPDX-License-Identifier: BSD-3-Clause
#include "PieceRequest.h"

#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace hashedoctree
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

/** The information of the output that the request came from. */
vtkInformation* GetRequested(vtkInformation* request, vtkInformationVector* outputVector)
{
  const int port = request->Get(Pipeline::FROM_OUTPUT_PORT());
  return outputVector->GetInformationObject(std::max(port, 0)); // 0 also if unknown.
}
}

ProcessGroup FindProcesses(
  vtkHashedOctreeAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputVector)
{
  vtkInformation* requested = GetRequested(request, outputVector);
  const int pieces = requested->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()); // 0 also if unknown.
  if (pieces <= 1)
  {
    return {};
  }
  vtkMultiProcessController* controller = algorithm->GetController();
  if (controller == nullptr)
  {
    return ProcessGroup::OfPart();
  }
  const bool isOwn = pieces == controller->GetNumberOfProcesses() &&
    requested->Get(Pipeline::UPDATE_PIECE_NUMBER()) == controller->GetLocalProcessId();
  return isOwn ? ProcessGroup(controller) : ProcessGroup::OfPart();
}

void ForgetOutputs(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(Pipeline::DATA_NOT_GENERATED(), 1);
  }
}
}
