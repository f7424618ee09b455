// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeFilter.h"

#include "AlgorithmOptions.h"
#include "DepthStatistics.h"
#include "FieldValue.h"
#include "NodeList.h"
#include "OctreeCells.h"
#include "OctreeHyperTree.h"
#include "OctreePass.h"
#include "OctreeTables.h"
#include "PassFieldData.h"
#include "PieceRequest.h"

#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkIdTypeArray.h"
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
constexpr int NumberOfOutputs = 3;

/** Where measuring ends in the progress of one tree; the rest is for its nodes. */
constexpr double MeasuringShare = 0.6;
/** Where listing them ends in the progress of nodes that become cells. */
constexpr double ListShareOfNodes = 0.1;
}

/** What one run of RequestData makes of each tree. */
class vtkHashedOctreeFilter::Run
{
public:
  /** `typeOfNodes` is the data object that port 0 has of a tree. */
  Run(vtkHashedOctreeFilter* filter, int typeOfNodes)
    : Self(filter)
    , TypeOfNodes(typeOfNodes)
  {
  }

  /** Ports 0, 1 and 2 for one tree. */
  template <int Dim>
  OctreePass::Outputs operator()(const PointsOctree<Dim>& octree, const Execution& execution) const
  {
    const int startDepth = GetStartDepth(octree.Counts, GetStartDepthOptions<Dim>(this->Self), Dim);
    const DepthHistogram searched =
      GetDepthHistogram(octree.Counts, GetStartDepthOptions<Dim>(this->Self).Frequency, Dim);
    const MeasuredCost measured =
      MeasureCost(octree.GetPart(), execution.Part(OctreePass::BuildShare, MeasuringShare));
    const vtkSmartPointer<vtkDataObject> nodes =
      this->MakeNodes(octree, startDepth, execution.Part(MeasuringShare, 1.0));
    this->AddFieldData(nodes->GetFieldData(), octree, startDepth, searched);
    vtkNew<vtkTable> histogram;
    vtkNew<vtkTable> costs;
    if (octree.Processes.IsFirst())
    {
      FillDepthHistogram(histogram, octree.Counts, Dim);
      FillCostCurves(costs, octree.Counts, measured, Dim);
      MarkStartDepth(costs, startDepth, GetMeanCost(searched, startDepth));
    }
    PassFieldData(nodes, histogram);
    PassFieldData(nodes, costs);
    return { nodes, histogram, costs };
  }

private:
  /** What port 0 shows of a tree. */
  template <int Dim>
  vtkSmartPointer<vtkDataObject> MakeNodes(
    const PointsOctree<Dim>& octree, int startDepth, const Execution& execution) const
  {
    const bool showsEmptyLeaves = this->Self->GetIncludeEmptyLeaves();
    if (this->TypeOfNodes == VTK_HYPER_TREE_GRID)
    {
      const auto grid = vtkSmartPointer<vtkHyperTreeGrid>::New();
      FillHyperTreeGrid(octree, startDepth, showsEmptyLeaves, grid, execution);
      return grid;
    }
    auto listed =
      ListNodes(octree.Tree, NodeListOptions{ showsEmptyLeaves, this->Self->IncludeInternalNodes },
        execution.Part(0.0, ListShareOfNodes), octree.Range);
    octree.CompletePoints(listed);
    const OctreeCells<Dim> cells(octree.Tree, startDepth, listed, octree.Frame);
    const Execution cellsExecution = execution.Part(ListShareOfNodes, 1.0);
    if (this->TypeOfNodes == VTK_POLY_DATA)
    {
      const auto outlines = vtkSmartPointer<vtkPolyData>::New();
      cells.MakeOutlines(outlines, cellsExecution);
      return outlines;
    }
    const auto voxels = vtkSmartPointer<vtkUnstructuredGrid>::New();
    cells.MakeVoxels(voxels, cellsExecution);
    return voxels;
  }

  /** Where searches would start by another frequency model. */
  template <int Dim>
  int GetStartDepthBy(const PointsOctree<Dim>& octree, hashedoctree::FrequencyModel model) const
  {
    StartDepthOptions options = GetStartDepthOptions<Dim>(this->Self);
    options.Frequency = model;
    return GetStartDepth(octree.Counts, options, Dim);
  }

  template <int Dim>
  void AddFieldData(vtkFieldData* fieldData, const PointsOctree<Dim>& octree, int startDepth,
    const DepthHistogram& searched) const
  {
    using Model = hashedoctree::FrequencyModel;
    const double hitCost = GetMeanCost(searched, startDepth);
    const double rootCost = GetMeanCost(searched, 0);

    AddFieldValue<vtkIntArray>(fieldData, "Dimension", Dim);
    AddFieldValue<vtkIntArray>(fieldData, "StartDepth", startDepth);
    AddFieldValue<vtkDoubleArray>(fieldData, "MeanHitCost", hitCost);
    AddFieldValue<vtkDoubleArray>(fieldData, "MeanRootCost", rootCost);
    AddFieldValue<vtkDoubleArray>(fieldData, "CostRatio", rootCost / hitCost);
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfPoints", octree.GetNumberOfPoints());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfNodes", octree.GetNumberOfNodes());
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfLeaves", octree.GetNumberOfLeaves());
    AddFieldValue<vtkIdTypeArray>(
      fieldData, "NumberOfEmptyLeaves", GetTotal(octree.Counts.EmptyLeaves));
    AddFieldValue<vtkIntArray>(fieldData, "DeepestDepth", octree.GetDeepestDepth());
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthLeaves", this->GetStartDepthBy(octree, Model::Leaves));
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthPoints", this->GetStartDepthBy(octree, Model::Points));
    AddFieldValue<vtkIntArray>(
      fieldData, "StartDepthGrid", this->GetStartDepthBy(octree, Model::Grid));
    AddFieldValue<vtkIdTypeArray>(fieldData, "TreeBytes", octree.TreeBytes);
    AddFieldValue<vtkDoubleArray>(fieldData, "BuildSeconds", octree.BuildSeconds);
    AddFieldValue<vtkIdTypeArray>(fieldData, "SkippedPoints", octree.SkippedPoints);
    AddFieldValue<vtkIdTypeArray>(fieldData, "OutsidePoints", octree.OutsidePoints);
  }

  vtkHashedOctreeFilter* Self;
  int TypeOfNodes;
};

vtkHashedOctreeFilter::vtkHashedOctreeFilter()
{
  this->SetNumberOfOutputPorts(NumberOfOutputs);
}

int vtkHashedOctreeFilter::GetTypeOfOutput(int port, vtkInformationVector** vtkNotUsed(inputVector))
{
  if (port != 0)
  {
    return VTK_TABLE;
  }
  switch (this->OutputType)
  {
    case Outlines:
      return VTK_POLY_DATA;
    case HyperTreeGrid:
      return VTK_HYPER_TREE_GRID;
    default:
      return VTK_UNSTRUCTURED_GRID;
  }
}

int vtkHashedOctreeFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = RunTogether(this, request, outputVector,
    [&](const ProcessGroup& processes)
    {
      std::optional<Box<3>> bounds;
      if (this->UseCustomBounds)
      {
        const double* b = this->CustomBounds;
        bounds = Box<3>({ b[0], b[2], b[4] }, { b[1], b[3], b[5] });
      }
      OctreePass pass(this, processes, bounds);
      const OctreePass::Targets ports = OctreePass::GetPorts(outputVector);
      // Whoever hears of the progress may have set the property since output 0 was made.
      const int typeOfNodes = vtkDataObjectTree::SafeDownCast(ports.front()) != nullptr
        ? this->GetTypeOfOutput(0, inputVector)
        : ports.front()->GetDataObjectType();
      pass.Execute(vtkDataObject::GetData(inputVector[0]), ports, Run(this, typeOfNodes));
      const ProcessGroup& together = pass.GetProcesses();
      if (pass.AreAllOutside() && together.HaveAll() && together.IsFirst())
      {
        vtkWarningMacro(<< "No point with finite coordinates lies in CustomBounds; widen them.");
      }
    });
  // Without points, and after an error. VTK's reader ends the program where a file has none.
  auto* grid = vtkHyperTreeGrid::GetData(outputVector, 0);
  if (grid != nullptr && grid->GetBranchFactor() == 0)
  {
    grid->SetBranchFactor(BranchFactor);
  }
  return done;
}

void vtkHashedOctreeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputType: " << this->OutputType << "\n";
  os << indent << "IncludeInternalNodes: " << this->IncludeInternalNodes << "\n";
  os << indent << "UseCustomBounds: " << this->UseCustomBounds << "\n";
  os << indent << "CustomBounds: " << this->CustomBounds[0];
  for (int i = 1; i < 6; ++i)
  {
    os << ", " << this->CustomBounds[i];
  }
  os << "\n";
}
