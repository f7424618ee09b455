// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeFilter.h"

#include "AlgorithmExecution.h"
#include "OctreeCells.h"
#include "OctreeTables.h"
#include "PointsAdaptor.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <chrono>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

using namespace hashedoctree;

vtkStandardNewMacro(vtkHashedOctreeFilter);

namespace
{
constexpr int NumberOfPorts = 3;

/** Shares of the progress of one tree: where each step ends. The rest is for its cells. */
constexpr double AdaptorShare = 0.02;
constexpr double SelectionShare = 0.05;
constexpr double BuildShare = 0.3;
constexpr double MeasuringShare = 0.6;

using Outputs = std::array<vtkSmartPointer<vtkDataObject>, NumberOfPorts>;

struct Tree
{
  Octree<3> Nodes;
  std::size_t SkippedPoints = 0;
  std::size_t OutsidePoints = 0;
  double BuildSeconds = 0.0;
};

template <typename Array, typename Value>
void AddFieldValue(vtkFieldData* fieldData, const char* name, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  fieldData->AddArray(array);
}
}

/** One pass of RequestData. */
class vtkHashedOctreeFilter::Run
{
public:
  explicit Run(vtkHashedOctreeFilter* filter)
    : Self(filter)
  {
  }

  /** Fills the outputs. Throws Interrupted, and std::exception with what to tell the user. */
  void Execute(vtkDataObject* input, vtkInformationVector* outputVector)
  {
    const Execution execution = MakeExecution(this->Self);
    if (auto* composite = vtkDataObjectTree::SafeDownCast(input))
    {
      this->ProcessBlocks(composite, outputVector, execution);
    }
    else
    {
      const Outputs outputs = this->Process(vtkPointSet::SafeDownCast(input), execution);
      for (int port = 0; port < NumberOfPorts && outputs[port]; ++port)
      {
        vtkDataObject::GetData(outputVector, port)->ShallowCopy(outputs[port]);
      }
    }
    if (this->SkippedPoints > 0)
    {
      vtkWarningWithObjectMacro(
        this->Self, << this->SkippedPoints << " of " << this->AllPoints
                    << " points have a coordinate that is not finite; they are left out.");
    }
    this->RequireUsedPoints(outputVector->GetInformationObject(0));
  }

private:
  /** One tree per block; blocks without points, or of another kind, stay empty. */
  void ProcessBlocks(
    vtkDataObjectTree* input, vtkInformationVector* outputVector, const Execution& execution)
  {
    std::array<vtkDataObjectTree*, NumberOfPorts> outputs;
    for (int port = 0; port < NumberOfPorts; ++port)
    {
      outputs[port] = vtkDataObjectTree::GetData(outputVector, port);
      outputs[port]->CopyStructure(input);
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
      auto* points = vtkPointSet::SafeDownCast(blocks->GetCurrentDataObject());
      const Outputs results = this->Process(
        points, execution.Part(block / numberOfBlocks, (block + 1.0) / numberOfBlocks));
      for (int port = 0; port < NumberOfPorts && results[port]; ++port)
      {
        outputs[port]->SetDataSetFrom(blocks, results[port]);
      }
      block += 1.0;
    }
  }

  /** Ports 0, 1 and 2 for the points of one data set; null where it has none to use. */
  Outputs Process(vtkPointSet* input, const Execution& execution)
  {
    if (input == nullptr || input->GetNumberOfPoints() == 0)
    {
      return Outputs{};
    }
    const Tree tree = this->Build(input, execution);
    this->AllPoints += input->GetNumberOfPoints();
    this->SkippedPoints += tree.SkippedPoints;
    this->UsedPoints += tree.Nodes.GetNumberOfPoints();
    if (tree.Nodes.GetNumberOfPoints() == 0)
    {
      return Outputs{};
    }
    const DepthCounts& counts = tree.Nodes.GetDepthCounts();
    const int startDepth = this->GetStartDepth(
      counts, static_cast<hashedoctree::FrequencyModel>(this->Self->FrequencyModel));

    vtkNew<vtkTable> histogram;
    FillDepthHistogram(histogram, counts);
    vtkNew<vtkTable> costs;
    FillCostCurves(
      costs, counts, MeasureCost(tree.Nodes, execution.Part(BuildShare, MeasuringShare)));

    const OctreeCells cells(tree.Nodes, startDepth,
      NodeListOptions{ this->Self->IncludeEmptyLeaves, this->Self->IncludeInternalNodes });
    const Execution cellsExecution = execution.Part(MeasuringShare, 1.0);
    vtkSmartPointer<vtkDataObject> nodes;
    if (this->Self->OutputType == Outlines)
    {
      vtkNew<vtkPolyData> outlines;
      cells.MakeOutlines(outlines, cellsExecution);
      nodes = outlines;
    }
    else
    {
      vtkNew<vtkUnstructuredGrid> voxels;
      cells.MakeVoxels(voxels, cellsExecution);
      nodes = voxels;
    }
    this->AddFieldData(nodes->GetFieldData(), tree, startDepth);
    return Outputs{ nodes, histogram, costs };
  }

  Tree Build(vtkPointSet* input, const Execution& execution) const
  {
    std::optional<Box<3>> box;
    if (this->Self->UseCustomBounds)
    {
      const double* b = this->Self->CustomBounds;
      box = Box<3>({ b[0], b[2], b[4] }, { b[1], b[3], b[5] });
    }
    Octree<3>::Options options;
    options.MaxPointsPerLeaf = static_cast<std::size_t>(this->Self->MaxPointsPerLeaf);
    options.MaxDepth = this->Self->MaxDepth;

    const auto start = std::chrono::steady_clock::now();
    const PointsAdaptor points(input, execution.Part(0.0, AdaptorShare));
    Tree tree;
    points.Visit(
      [&](auto span)
      {
        const PointSelection<3> selection(span, box, execution.Part(AdaptorShare, SelectionShare));
        tree.Nodes =
          Octree<3>(span, selection, options, execution.Part(SelectionShare, BuildShare));
        tree.SkippedPoints = selection.GetNumberOfSkippedPoints();
        tree.OutsidePoints = selection.GetNumberOfOutsidePoints();
      });
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    tree.BuildSeconds = elapsed.count();
    return tree;
  }

  int GetStartDepth(const DepthCounts& counts, hashedoctree::FrequencyModel model) const
  {
    const StartDepthOptions options{ static_cast<hashedoctree::StartDepthModel>(
                                       this->Self->StartDepthModel),
      model, this->Self->FixedStartDepth };
    return hashedoctree::GetStartDepth(GetDepthHistogram(counts, model, 3), options);
  }

  void AddFieldData(vtkFieldData* fieldData, const Tree& tree, int startDepth) const
  {
    using Model = hashedoctree::FrequencyModel;
    const DepthCounts& counts = tree.Nodes.GetDepthCounts();
    const DepthHistogram histogram =
      GetDepthHistogram(counts, static_cast<Model>(this->Self->FrequencyModel), 3);
    const double hitCost = GetMeanCost(histogram, startDepth);
    const double rootCost = GetMeanCost(histogram, 0);

    AddFieldValue<vtkIntArray>(fieldData, "StartDepth", startDepth);
    AddFieldValue<vtkDoubleArray>(fieldData, "MeanHitCost", hitCost);
    AddFieldValue<vtkDoubleArray>(fieldData, "MeanRootCost", rootCost);
    AddFieldValue<vtkDoubleArray>(fieldData, "CostRatio", hitCost > 0 ? rootCost / hitCost : 1.0);
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfPoints", tree.Nodes.GetNumberOfPoints());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfNodes", tree.Nodes.GetNumberOfNodes());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfLeaves", tree.Nodes.GetNumberOfLeaves());
    AddFieldValue<vtkIdTypeArray>(
      fieldData, "NumberOfEmptyLeaves", tree.Nodes.GetNumberOfEmptyLeaves());
    AddFieldValue<vtkIntArray>(fieldData, "DeepestDepth", tree.Nodes.GetDeepestDepth());
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthLeaves", this->GetStartDepth(counts, Model::Leaves));
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthPoints", this->GetStartDepth(counts, Model::Points));
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthGrid", this->GetStartDepth(counts, Model::Grid));
    AddFieldValue<vtkIdTypeArray>(fieldData, "TreeBytes", tree.Nodes.GetTreeBytes());
    AddFieldValue<vtkDoubleArray>(fieldData, "BuildSeconds", tree.BuildSeconds);
    AddFieldValue<vtkIdTypeArray>(fieldData, "SkippedPoints", tree.SkippedPoints);
    AddFieldValue<vtkIdTypeArray>(fieldData, "OutsidePoints", tree.OutsidePoints);
  }

  /** An empty piece of a distributed data set is no error: other pieces have the points. */
  void RequireUsedPoints(vtkInformation* outputInformation) const
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    const bool isPiece = outputInformation->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
      outputInformation->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
    if (this->UsedPoints > 0 || isPiece)
    {
      return;
    }
    if (this->AllPoints == 0)
    {
      throw std::invalid_argument("The input has no points; give a data set with points.");
    }
    throw std::invalid_argument(this->Self->UseCustomBounds
        ? "No point with finite coordinates lies in CustomBounds; widen them."
        : "No point has finite coordinates; mend the input.");
  }

  vtkHashedOctreeFilter* Self;
  vtkIdType AllPoints = 0;
  std::size_t SkippedPoints = 0;
  std::size_t UsedPoints = 0;
};

vtkHashedOctreeFilter::vtkHashedOctreeFilter()
{
  this->SetNumberOfOutputPorts(NumberOfPorts);
}

int vtkHashedOctreeFilter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

int vtkHashedOctreeFilter::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  // Port 0 depends on OutputType, and all ports on whether the input is composite.
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkHashedOctreeFilter::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (input == nullptr)
  {
    return 0;
  }
  const int cells = this->OutputType == Outlines ? VTK_POLY_DATA : VTK_UNSTRUCTURED_GRID;
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    const int type = vtkDataObjectTree::SafeDownCast(input) ? input->GetDataObjectType()
      : port == 0                                           ? cells
                                                            : VTK_TABLE;
    vtkDataObjectAlgorithm::SetOutputDataObject(
      type, outputVector->GetInformationObject(port), /*exact=*/true);
  }
  return 1;
}

int vtkHashedOctreeFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  std::string problem;
  try
  {
    Run(this).Execute(vtkDataObject::GetData(inputVector[0]), outputVector);
    return 1;
  }
  catch (const Interrupted&)
  {
  }
  catch (const std::bad_alloc&)
  {
    problem =
      "There is not enough memory for the octree; raise MaxPointsPerLeaf or lower MaxDepth.";
  }
  catch (const std::exception& exception)
  {
    problem = exception.what();
  }
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
  }
  return problem.empty() ? 1 : 0;
}

void vtkHashedOctreeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaxPointsPerLeaf: " << this->MaxPointsPerLeaf << "\n";
  os << indent << "MaxDepth: " << this->MaxDepth << "\n";
  os << indent << "FrequencyModel: " << this->FrequencyModel << "\n";
  os << indent << "StartDepthModel: " << this->StartDepthModel << "\n";
  os << indent << "FixedStartDepth: " << this->FixedStartDepth << "\n";
  os << indent << "OutputType: " << this->OutputType << "\n";
  os << indent << "IncludeEmptyLeaves: " << this->IncludeEmptyLeaves << "\n";
  os << indent << "IncludeInternalNodes: " << this->IncludeInternalNodes << "\n";
  os << indent << "UseCustomBounds: " << this->UseCustomBounds << "\n";
  os << indent << "CustomBounds: " << this->CustomBounds[0];
  for (int i = 1; i < 6; ++i)
  {
    os << ", " << this->CustomBounds[i];
  }
  os << "\n";
}
