// SPDX-License-Identifier: BSD-3-Clause
#include "OctreePass.h"

#include "AlgorithmExecution.h"
#include "AlgorithmOptions.h"
#include "BlockStructure.h"
#include "OctreeHyperTree.h"
#include "PassFieldData.h"
#include "PointsAdaptor.h"
#include "QuadtreeFrame.h"
#include "SkippedPoints.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace hashedoctree
{
namespace
{
/** Shares of the progress of one point set: where each step ends. */
constexpr double AdaptorShare = 0.02;
constexpr double SelectionShare = 0.05;

/** The tree of the selected points in a frame. */
template <int Dim, typename Real>
PointsOctree<Dim> BuildInFrame(const TreeFrame<Dim>& frame, PointSpan<3, Real> points,
  const PointSelection<3>& selection, vtkHashedOctreeAlgorithm* algorithm,
  const Execution& execution)
{
  return { Octree<Dim>(Project(points, frame, selection.GetBox()),
             PointSelection<Dim>(selection, frame.GetAxes()), GetTreeOptions<Dim>(algorithm),
             execution),
    frame, selection.GetNumberOfSkippedPoints(), selection.GetNumberOfOutsidePoints() };
}
}

OctreePass::OctreePass(vtkHashedOctreeAlgorithm* algorithm, std::optional<Box<3>> root)
  : Algorithm(algorithm)
  , Root(root)
{
}

void OctreePass::ExecuteAny(
  vtkDataObject* input, const Targets& targets, bool isPiece, const MakeOutputs& makeOutputs)
{
  const Execution execution = MakeExecution(this->Algorithm);
  if (auto* composite = vtkDataObjectTree::SafeDownCast(input))
  {
    this->ProcessBlocks(composite, targets, makeOutputs, execution);
  }
  else
  {
    const Outputs outputs = this->Process(input, makeOutputs, execution);
    for (std::size_t i = 0; i < outputs.size(); ++i)
    {
      HandOver(outputs[i], targets[i]);
    }
  }
  if (this->SkippedPoints > 0)
  {
    WarnOfSkippedPoints(this->Algorithm, this->SkippedPoints, this->AllPoints);
  }
  if (this->UsedPoints == 0 && !isPiece)
  {
    this->RefuseInput();
  }
  if (this->ImplicitBlocks > 0)
  {
    vtkWarningWithObjectMacro(this->Algorithm,
      << "Blocks left out because their points have no coordinates of their own, as those of "
         "images: "
      << this->ImplicitBlocks << ". vtkConvertToPointCloud gives them some.");
  }
}

void OctreePass::ProcessBlocks(vtkDataObjectTree* input, const Targets& targets,
  const MakeOutputs& makeOutputs, const Execution& execution)
{
  std::vector<vtkDataObjectTree*> outputs;
  for (vtkDataObject* target : targets)
  {
    outputs.push_back(vtkDataObjectTree::SafeDownCast(target));
    CopyStructure(input, outputs.back());
    PassFieldData(input, target); // The structure may bring no field data, which VTK relies on.
  }
  const auto blocks = vtk::TakeSmartPointer(input->NewTreeIterator());
  double numberOfBlocks = 0.0;
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    numberOfBlocks += 1.0;
  }
  double block = 0.0;
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    const Outputs results = this->Process(blocks->GetCurrentDataObject(), makeOutputs,
      execution.Part(block / numberOfBlocks, (block + 1.0) / numberOfBlocks));
    for (std::size_t i = 0; i < results.size(); ++i)
    {
      outputs[i]->SetDataSetFrom(blocks, results[i]);
    }
    block += 1.0;
  }
}

OctreePass::Outputs OctreePass::Process(
  vtkDataObject* data, const MakeOutputs& makeOutputs, const Execution& execution)
{
  auto* input = vtkPointSet::SafeDownCast(data);
  const bool hasPoints = data->GetNumberOfElements(vtkDataObject::POINT) > 0;
  if (input == nullptr || !hasPoints)
  {
    this->ImplicitBlocks += hasPoints ? 1 : 0;
    return {};
  }
  const std::optional<AnyPointsOctree> octree = this->Build(input, execution);
  Outputs outputs = octree ? makeOutputs(*octree, execution) : Outputs{};
  for (vtkDataObject* output : outputs)
  {
    PassFieldData(input, output);
  }
  return outputs;
}

std::optional<AnyPointsOctree> OctreePass::Build(vtkPointSet* input, const Execution& execution)
{
  const auto start = std::chrono::steady_clock::now();
  RequirePointIndices(static_cast<std::size_t>(input->GetNumberOfPoints())); // Before a copy.
  const PointsAdaptor points(input, execution.Part(0.0, AdaptorShare));
  std::optional<AnyPointsOctree> built;
  points.Visit(
    [&](auto span)
    {
      const PointSelection<3> selection(
        span, this->Root, execution.Part(AdaptorShare, SelectionShare));
      this->AllPoints += input->GetNumberOfPoints();
      this->SkippedPoints += selection.GetNumberOfSkippedPoints();
      this->UsedPoints += selection.GetNumberOfPoints();
      if (selection.GetNumberOfPoints() == 0)
      {
        return;
      }
      const auto build = [&](const auto& frame)
      {
        auto octree = BuildInFrame(
          frame, span, selection, this->Algorithm, execution.Part(SelectionShare, BuildShare));
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        octree.BuildSeconds = elapsed.count();
        built = std::move(octree);
      };
      const auto plane = FindQuadtreeFrame(this->Algorithm, selection.GetBox());
      plane ? build(*plane) : build(TreeFrame<3>());
    });
  return built;
}

OctreePass::Targets OctreePass::GetPorts(vtkInformationVector* outputVector)
{
  Targets ports;
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    ports.push_back(vtkDataObject::GetData(outputVector, port));
  }
  return ports;
}

bool OctreePass::IsPiece(vtkInformation* request, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int port = std::max(request->Get(Pipeline::FROM_OUTPUT_PORT()), 0); // 0 also if unknown.
  vtkInformation* information = outputVector->GetInformationObject(port);
  return information->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    information->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
}

void OctreePass::RefuseInput() const
{
  if (this->AllPoints == 0)
  {
    throw std::invalid_argument(this->ImplicitBlocks > 0
        ? "The points of the input have no coordinates of their own, as those of images; "
          "vtkConvertToPointCloud gives them some."
        : "The input has no points; give a data set with points.");
  }
  throw std::invalid_argument(this->Root
      ? "No point with finite coordinates lies in CustomBounds; widen them."
      : "No point has coordinates that are finite and not too large; mend the input.");
}
}
