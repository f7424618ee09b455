// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeLocateFilter.h"

#include "AlgorithmOptions.h"
#include "FieldValue.h"
#include "LocatedQueries.h"
#include "OctreePass.h"
#include "OctreeTables.h"
#include "PieceRequest.h"
#include "QueryBlocks.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace hashedoctree;

vtkStandardNewMacro(vtkHashedOctreeLocateFilter);

namespace
{
constexpr int NumberOfPorts = 2; // Of inputs, and of outputs.

/** Shares of the progress of one block of queries: where each step ends. The rest is for the point
 * arrays. */
constexpr double QueriesShare = 0.07;
constexpr double DepthsShare = 0.21;

/** Gives an output the times at which one of two inputs changes. */
void SetTimesOfBoth(vtkInformation* first, vtkInformation* second, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::set<double> steps;
  std::set<double> ends;
  for (vtkInformation* input : { first, second })
  {
    const double* its = input->Get(Pipeline::TIME_STEPS());
    steps.insert(its, its + input->Length(Pipeline::TIME_STEPS()));
    its = input->Get(Pipeline::TIME_RANGE());
    ends.insert(its, its + input->Length(Pipeline::TIME_RANGE()));
  }
  if (!steps.empty())
  {
    const std::vector<double> all(steps.begin(), steps.end());
    output->Set(Pipeline::TIME_STEPS(), all.data(), static_cast<int>(all.size()));
  }
  if (!ends.empty())
  {
    const double range[] = { *ends.begin(), *ends.rbegin() };
    output->Set(Pipeline::TIME_RANGE(), range, 2);
  }
}

/** Tells who comes next of the arrays of the queries, and of the active one among their points. */
void TellOfArrays(vtkInformation* queries, vtkInformation* output)
{
  constexpr int deep = 1; // What the queries tell of themselves stays as it is.
  for (auto* arrays : { vtkDataObject::POINT_DATA_VECTOR(), vtkDataObject::CELL_DATA_VECTOR() })
  {
    output->Remove(arrays);
    if (queries->Has(arrays))
    {
      output->CopyEntry(queries, arrays, deep);
    }
  }
  vtkInformation* active = vtkDataObject::SetActiveAttribute(
    output, vtkDataObject::FIELD_ASSOCIATION_POINTS, "HitCost", vtkDataSetAttributes::SCALARS);
  active->Set(vtkDataObject::FIELD_ARRAY_TYPE(), VTK_INT);
  active->Set(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS(), 1);
}

double GetMean(std::uint64_t sum, const DepthHistogram& depths)
{
  const std::uint64_t count = GetTotal(depths);
  return count > 0 ? static_cast<double>(sum) / static_cast<double>(count) : 0.0;
}
}

/** What one run of RequestData makes of each tree. */
class vtkHashedOctreeLocateFilter::Run
{
public:
  explicit Run(vtkHashedOctreeLocateFilter* filter)
    : Self(filter)
  {
  }

  /** Ports 0 and 1. Throws std::exception with what to tell the user, and Interrupted. */
  void Execute(const ProcessGroup& processes, vtkDataObject* points, vtkDataObject* queries,
    vtkInformationVector* outputVector)
  {
    const QueryBlocks blocks(points, queries, outputVector, processes);
    OctreePass pass(this->Self, processes, this->Self->GetKeptOctrees());
    pass.Execute(points, blocks.GetTargets(),
      [&](const auto& octree, const Execution& execution)
      { return this->LocateBlocks(octree, blocks.Get(), execution); });
    blocks.FillOutputs();
    const std::size_t counted = pass.GetProcesses().Sum(this->CountedQueries);
    const std::size_t skipped = pass.GetProcesses().Sum(this->SkippedQueries);
    if (skipped > 0 && pass.GetProcesses().IsFirst())
    {
      vtkWarningWithObjectMacro(
        this->Self, << skipped << " of " << counted
                    << " query points not located, for a coordinate that is not finite.");
    }
  }

private:
  /** The outputs for each block of queries, one after the other. */
  template <int Dim>
  OctreePass::Outputs LocateBlocks(const PointsOctree<Dim>& octree,
    const std::vector<vtkDataSet*>& blocks, const Execution& execution)
  {
    OctreePass::Outputs outputs;
    this->CountedQueries = 0;
    this->SkippedQueries = 0;
    QuerySearch<Dim> search(octree, GetStartDepthOptions<Dim>(this->Self), GetReading(this->Self),
      execution.Part(OctreePass::BuildShare, OctreePass::BuildShare));
    const double share = (1.0 - OctreePass::BuildShare) / static_cast<double>(blocks.size());
    double begin = OctreePass::BuildShare;
    for (vtkDataSet* block : blocks)
    {
      const auto ofBlock =
        this->LocateBlock(octree, search, block, execution.Part(begin, begin + share));
      outputs.insert(outputs.end(), ofBlock.begin(), ofBlock.end());
      begin += share;
    }
    return outputs;
  }

  /** As Locate(); where there is not enough memory, the error is about the queries. */
  template <int Dim>
  OctreePass::Outputs LocateBlock(const PointsOctree<Dim>& octree, QuerySearch<Dim>& search,
    vtkDataSet* queries, const Execution& execution)
  {
    try
    {
      return this->Locate(octree, search, queries, execution);
    }
    catch (const std::bad_alloc&)
    {
      throw std::runtime_error(
        "There is not enough memory to locate the queries; take fewer of them.");
    }
  }

  /** `queries` is null where another process has the block. */
  template <int Dim>
  OctreePass::Outputs Locate(const PointsOctree<Dim>& octree, QuerySearch<Dim>& search,
    vtkDataSet* queries, const Execution& execution)
  {
    using Comparison = SearchComparison<Dim>;
    const LocatedQueries<Dim> located(queries, octree, execution.Part(0.0, QueriesShare));
    this->CountedQueries += located.GetNumberOfCounted();
    this->SkippedQueries += located.GetNumberOfSkipped();
    const DepthHistogram depths = located.MeasureDepths(execution.Part(QueriesShare, DepthsShare));
    Comparison& comparison = search.GetComparison();
    comparison.SetQueryDepths(depths);
    const auto output = queries != nullptr ? vtk::TakeSmartPointer(queries->NewInstance())
                                           : vtkSmartPointer<vtkDataSet>(vtkNew<vtkPolyData>());
    if (queries != nullptr)
    {
      output->ShallowCopy(queries);
    }
    const typename Comparison::Costs costs =
      located.Search(search, output, execution.Part(DepthsShare, 1.0));

    vtkNew<vtkTable> table;
    if (octree.Processes.IsFirst())
    {
      this->FillTable(table, octree, comparison, costs, depths);
    }
    OctreePass::Outputs outputs{ output, table };
    for (vtkDataObject* filled : outputs)
    {
      vtkFieldData* fieldData = GetOwnFieldData(filled);
      AddFieldValue<vtkIntArray>(
        fieldData, "StartDepth", comparison.GetStartDepth(Comparison::Chosen));
      AddFieldValue<vtkDoubleArray>(
        fieldData, "MeanHitCost", GetMean(costs[Comparison::Chosen], depths));
      AddFieldValue<vtkIntArray>(
        fieldData, "BestStartDepth", comparison.GetStartDepth(Comparison::BestForQueries));
      AddFieldValue<vtkIdTypeArray>(fieldData, "SkippedPoints", octree.SkippedPoints);
    }
    return outputs;
  }

  template <int Dim>
  void FillTable(vtkTable* table, const PointsOctree<Dim>& octree,
    const SearchComparison<Dim>& searches, const typename SearchComparison<Dim>::Costs& costs,
    const DepthHistogram& depths) const
  {
    using Comparison = SearchComparison<Dim>;
    std::vector<SearchRow> rows;
    if (GetTotal(depths) == 0)
    {
      FillSearchTable(table, rows); // There is no mean, and no best start depth.
      return;
    }
    const auto add = [&](const char* name, typename Comparison::Search search)
    {
      rows.push_back({ name, searches.GetStartDepth(search), searches.GetPredictedMean(search),
        GetMean(costs[search], depths) });
    };
    add("Root", Comparison::Root);
    add("Median", Comparison::Median);
    add("Mean", Comparison::Mean);
    if (this->Self->GetStartDepthModel() == Fixed)
    {
      add("Fixed", Comparison::Chosen);
    }
    add("Local", Comparison::Local);
    add("Decision tree", Comparison::DecisionTree);
    add("Best for these queries", Comparison::BestForQueries);
    const DepthHistogram predicted =
      GetDepthHistogram(octree.Counts, GetStartDepthOptions<Dim>(this->Self).Frequency, Dim);
    rows.push_back({ "Entropy bound", -1, GetEntropyBound(predicted), GetEntropyBound(depths) });
    FillSearchTable(table, rows);
  }

  vtkHashedOctreeLocateFilter* Self;
  std::size_t CountedQueries = 0; ///< Of this process, as the last tree counted them,
  std::size_t SkippedQueries = 0; ///< and those of them that are not finite.
};

vtkHashedOctreeLocateFilter::vtkHashedOctreeLocateFilter()
{
  this->SetNumberOfInputPorts(NumberOfPorts);
  this->SetNumberOfOutputPorts(NumberOfPorts);
}

int vtkHashedOctreeLocateFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkHashedOctreeLocateFilter::GetTypeOfOutput(int port, vtkInformationVector** inputVector)
{
  vtkDataObject* queries = vtkDataObject::GetData(inputVector[1]);
  if (queries == nullptr)
  {
    return -1;
  }
  if (port == 0)
  {
    return queries->GetDataObjectType();
  }
  return vtkCompositeDataSet::SafeDownCast(queries) != nullptr ? VTK_MULTIBLOCK_DATA_SET
                                                               : VTK_TABLE;
}

int vtkHashedOctreeLocateFilter::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestDataObject(request, inputVector, outputVector);
  vtkDataObject* queries = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  if (queries != nullptr && this->GetTypeOfComposite(inputVector) < 0 &&
    (output == nullptr || std::string(output->GetClassName()) != queries->GetClassName()))
  {
    // The type of a plain vtkPointSet does not name its class.
    outputVector->GetInformationObject(0)->Set(
      vtkDataObject::DATA_OBJECT(), vtk::TakeSmartPointer(queries->NewInstance()));
  }
  return done;
}

int vtkHashedOctreeLocateFilter::GetTypeOfComposite(vtkInformationVector** inputVector)
{
  const int ofPoints = this->Superclass::GetTypeOfComposite(inputVector);
  const bool areBoth = ofPoints >= 0 && vtkCompositeDataSet::GetData(inputVector[1]) != nullptr;
  return areBoth ? VTK_MULTIBLOCK_DATA_SET : ofPoints;
}

int vtkHashedOctreeLocateFilter::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The outputs are where the queries are; from the table, too, the extent that is asked for goes
  // on to them.
  vtkInformation* points = inputVector[0]->GetInformationObject(0);
  vtkInformation* queries = inputVector[1]->GetInformationObject(0);
  for (int port = 0; port < NumberOfPorts; ++port)
  {
    vtkInformation* output = outputVector->GetInformationObject(port);
    output->CopyEntry(queries, vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    output->CopyEntry(queries, vtkDataObject::ORIGIN());
    output->CopyEntry(queries, vtkDataObject::SPACING());
    SetTimesOfBoth(points, queries, output);
  }
  TellOfArrays(queries, outputVector->GetInformationObject(0));
  return 1;
}

int vtkHashedOctreeLocateFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = RunTogether(this, request, outputVector,
    [&](const ProcessGroup& processes)
    {
      Run(this).Execute(processes, vtkDataObject::GetData(inputVector[0]),
        vtkDataObject::GetData(inputVector[1]), outputVector);
    });
  // Without points, and after an error. What has less than the extent that it told is made again.
  auto* queries = vtkDataSet::GetData(inputVector[1]);
  auto* located = vtkDataSet::GetData(outputVector, 0);
  if (queries != nullptr && located != nullptr && located->GetNumberOfPoints() == 0 &&
    queries->GetExtentType() == VTK_3D_EXTENT)
  {
    located->CopyStructure(queries);
  }
  return done;
}

void vtkHashedOctreeLocateFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
