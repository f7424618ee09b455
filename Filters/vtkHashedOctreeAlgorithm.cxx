// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeAlgorithm.h"

#include "BlockStructure.h"
#include "KeptOctrees.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkHashedOctreeAlgorithm::vtkHashedOctreeAlgorithm()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Kept(std::make_unique<hashedoctree::KeptOctrees>())
{
}

vtkHashedOctreeAlgorithm::~vtkHashedOctreeAlgorithm() = default;

void vtkHashedOctreeAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkHashedOctreeAlgorithm::GetController() const
{
  return this->Controller;
}

void vtkHashedOctreeAlgorithm::Modified()
{
  this->Kept->Forget();
  this->Superclass::Modified();
}

void vtkHashedOctreeAlgorithm::SetFrequencyModel(int model)
{
  this->SetOfSearches<int>(this->FrequencyModel, std::clamp<int>(model, Leaves, Grid));
}

void vtkHashedOctreeAlgorithm::SetStartDepthModel(int model)
{
  this->SetOfSearches<int>(this->StartDepthModel, std::clamp<int>(model, Median, Fixed));
}

void vtkHashedOctreeAlgorithm::SetFixedStartDepth(int depth)
{
  this->SetOfSearches(this->FixedStartDepth, std::clamp(depth, 0, 31));
}

void vtkHashedOctreeAlgorithm::SetIncludeEmptyLeaves(bool include)
{
  this->SetOfSearches(this->IncludeEmptyLeaves, include);
}

void vtkHashedOctreeAlgorithm::SetDimension(int dimension)
{
  const int known = dimension < Two ? Auto : dimension > Three ? Three : dimension;
  if (this->Dimension != known)
  {
    this->Dimension = known;
    this->Modified();
  }
}

int vtkHashedOctreeAlgorithm::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  // AMR, too, which is then refused once and not block by block.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkHashedOctreeAlgorithm::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkDataObject::GetData(inputVector[0]) == nullptr)
  {
    return 1; // What is missing, the pipeline says next.
  }
  const int composite = this->GetTypeOfComposite(inputVector);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const int single = this->GetTypeOfOutput(port, inputVector);
    if (single < 0)
    {
      return 1;
    }
    const int several = single == VTK_TABLE ? VTK_MULTIBLOCK_DATA_SET : composite;
    vtkDataObjectAlgorithm::SetOutputDataObject(
      composite < 0 ? single : several, outputVector->GetInformationObject(port), /*exact=*/true);
  }
  return 1;
}

int vtkHashedOctreeAlgorithm::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  // The executive has copied what the points say of their place.
  constexpr int none[] = { 0, -1, 0, -1, 0, -1 };
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkInformation* output = outputVector->GetInformationObject(port);
    output->Set(Pipeline::WHOLE_EXTENT(), none, 6);
    output->Remove(vtkDataObject::ORIGIN());
    output->Remove(vtkDataObject::SPACING());
  }
  return 1;
}

int vtkHashedOctreeAlgorithm::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  // The executive asks for the extent of the output, which is another one.
  vtkInformation* points = inputVector[0]->GetInformationObject(0);
  if (points->Has(Pipeline::WHOLE_EXTENT()))
  {
    points->Set(Pipeline::UPDATE_EXTENT(), points->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  points->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

int vtkHashedOctreeAlgorithm::GetTypeOfComposite(vtkInformationVector** inputVector)
{
  vtkDataObjectTree* input = hashedoctree::GetTreeOfBlocks(vtkDataObject::GetData(inputVector[0]));
  return input == nullptr ? -1 : input->GetDataObjectType();
}

void vtkHashedOctreeAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimension: " << this->Dimension << "\n";
  os << indent << "Plane: " << this->Plane << "\n";
  os << indent << "MaxPointsPerLeaf: " << this->MaxPointsPerLeaf << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "MaxDepth: " << this->MaxDepth << "\n";
  os << indent << "FrequencyModel: " << this->FrequencyModel << "\n";
  os << indent << "StartDepthModel: " << this->StartDepthModel << "\n";
  os << indent << "FixedStartDepth: " << this->FixedStartDepth << "\n";
  os << indent << "IncludeEmptyLeaves: " << this->IncludeEmptyLeaves << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
