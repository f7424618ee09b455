// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeFilter.h"

#include "AlgorithmProblems.h"
#include "FieldValue.h"
#include "NodeList.h"
#include "OctreeCells.h"
#include "OctreePass.h"
#include "OctreeTables.h"

#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <optional>

using namespace hashedoctree;

vtkStandardNewMacro(vtkHashedOctreeFilter);

namespace
{
constexpr int NumberOfPorts = 3;

/** Shares of the progress of one tree: where each step ends. The rest is for its cells. */
constexpr double MeasuringShare = 0.6;
constexpr double ListShare = 0.64;
}

/** What one run of RequestData makes of each tree. */
class vtkHashedOctreeFilter::Run
{
public:
  explicit Run(vtkHashedOctreeFilter* filter)
    : Self(filter)
  {
  }

  /** Ports 0, 1 and 2 for one tree. */
  OctreePass::Outputs operator()(const PointsOctree& octree, const Execution& execution) const
  {
    const Octree<3>& tree = octree.Tree;
    const DepthCounts& counts = tree.GetDepthCounts();
    const int startDepth = this->GetStartDepth(
      counts, static_cast<hashedoctree::FrequencyModel>(this->Self->FrequencyModel));

    vtkNew<vtkTable> histogram;
    FillDepthHistogram(histogram, counts);
    vtkNew<vtkTable> costs;
    FillCostCurves(
      costs, counts, MeasureCost(tree, execution.Part(OctreePass::BuildShare, MeasuringShare)));

    const auto listed = ListNodes(tree,
      NodeListOptions{ this->Self->IncludeEmptyLeaves, this->Self->IncludeInternalNodes },
      execution.Part(MeasuringShare, ListShare));
    const OctreeCells cells(tree, startDepth, listed);
    const Execution cellsExecution = execution.Part(ListShare, 1.0);
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
    this->AddFieldData(nodes->GetFieldData(), octree, startDepth);
    return { nodes, histogram, costs };
  }

private:
  int GetStartDepth(const DepthCounts& counts, hashedoctree::FrequencyModel model) const
  {
    const StartDepthOptions options{ static_cast<hashedoctree::StartDepthModel>(
                                       this->Self->StartDepthModel),
      model, this->Self->FixedStartDepth };
    return hashedoctree::GetStartDepth(GetDepthHistogram(counts, model, 3), options);
  }

  void AddFieldData(vtkFieldData* fieldData, const PointsOctree& octree, int startDepth) const
  {
    using Model = hashedoctree::FrequencyModel;
    const Octree<3>& tree = octree.Tree;
    const DepthCounts& counts = tree.GetDepthCounts();
    const DepthHistogram histogram =
      GetDepthHistogram(counts, static_cast<Model>(this->Self->FrequencyModel), 3);
    const double hitCost = GetMeanCost(histogram, startDepth);
    const double rootCost = GetMeanCost(histogram, 0);

    AddFieldValue<vtkIntArray>(fieldData, "StartDepth", startDepth);
    AddFieldValue<vtkDoubleArray>(fieldData, "MeanHitCost", hitCost);
    AddFieldValue<vtkDoubleArray>(fieldData, "MeanRootCost", rootCost);
    AddFieldValue<vtkDoubleArray>(fieldData, "CostRatio", hitCost > 0 ? rootCost / hitCost : 1.0);
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfPoints", tree.GetNumberOfPoints());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfNodes", tree.GetNumberOfNodes());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfLeaves", tree.GetNumberOfLeaves());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfEmptyLeaves", tree.GetNumberOfEmptyLeaves());
    AddFieldValue<vtkIntArray>(fieldData, "DeepestDepth", tree.GetDeepestDepth());
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthLeaves", this->GetStartDepth(counts, Model::Leaves));
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthPoints", this->GetStartDepth(counts, Model::Points));
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthGrid", this->GetStartDepth(counts, Model::Grid));
    AddFieldValue<vtkIdTypeArray>(fieldData, "TreeBytes", tree.GetTreeBytes());
    AddFieldValue<vtkDoubleArray>(fieldData, "BuildSeconds", octree.BuildSeconds);
    AddFieldValue<vtkIdTypeArray>(fieldData, "SkippedPoints", octree.SkippedPoints);
    AddFieldValue<vtkIdTypeArray>(fieldData, "OutsidePoints", octree.OutsidePoints);
  }

  vtkHashedOctreeFilter* Self;
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
  return RunReportingProblems(this, outputVector,
    [&]
    {
      std::optional<Box<3>> root;
      if (this->UseCustomBounds)
      {
        const double* b = this->CustomBounds;
        root = Box<3>({ b[0], b[2], b[4] }, { b[1], b[3], b[5] });
      }
      Octree<3>::Options options;
      options.MaxPointsPerLeaf = static_cast<std::size_t>(this->MaxPointsPerLeaf);
      options.MaxDepth = this->MaxDepth;
      OctreePass(this, options, root)
        .Execute(vtkDataObject::GetData(inputVector[0]), outputVector, Run(this));
    });
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
