// SPDX-License-Identifier: BSD-3-Clause
#include "OctreePass.h"

#include "AlgorithmExecution.h"
#include "AlgorithmOptions.h"
#include "BlockStructure.h"
#include "DistinctKeys.h"
#include "DistributedOctree.h"
#include "KeyedPoints.h"
#include "NodeArrays.h"
#include "OctreeHyperTree.h"
#include "PassFieldData.h"
#include "PointsAdaptor.h"
#include "QuadtreeFrame.h"
#include "SkippedPoints.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <stdexcept>

namespace hashedoctree
{
namespace
{
/** Shares of the progress of one point set: where each step ends. */
constexpr double AdaptorShare = 0.02;
constexpr double SelectionShare = 0.05;
/** Share of the progress of building a tree of keys: where these are made. */
constexpr double KeysShare = 0.2;
/** And of making them: where each point has one. */
constexpr double KeyedShare = 0.4;
constexpr std::size_t PointsAtATime = 4096; ///< Between looks whether to go on.

/** The points that a process has for a tree, but for those that VTK marks as another piece's. */
template <typename Real>
struct OwnPoints
{
  PointSpan<3, Real> Points;
  const PointSelection<3>& Selection;
  const DuplicatePoints& Others; ///< That are another piece's.
  const PointCounts& Counts;
  bool Merge; ///< Whether those in one of the smallest cells of the grid count as one.
};

/** The keys of a process's points in the grid of all of them; merged, if they are to be. */
template <int Dim, typename Real>
std::vector<MortonKey<Dim>> MakeKeys(const TreeFrame<Dim>& frame, const Grid<Dim>& grid,
  const OwnPoints<Real>& own, const Execution& execution)
{
  const auto keyed = MakeKeyedPoints(Project(own.Points, frame, own.Selection.GetBox()),
    PointSelection<Dim>(own.Selection, frame.GetAxes()), grid, execution.Part(0.0, KeyedShare));
  std::vector<MortonKey<Dim>> keys;
  keys.reserve(keyed.GetSize());
  execution.Part(KeyedShare, KeyedShare)
    .OnOneThread()
    .ForEach(keyed.GetSize(), PointsAtATime,
      [&](std::size_t i)
      {
        if (!own.Others.Have(static_cast<vtkIdType>(keyed[i].GetId())))
        {
          keys.push_back(keyed[i].GetKey());
        }
      });
  if (own.Merge)
  {
    keys = GetDistinctKeys(keys, execution.Part(KeyedShare, 1.0));
  }
  return keys;
}

/** The tree of a process alone. */
template <int Dim, typename Real>
PointsOctree<Dim> BuildAlone(const TreeFrame<Dim>& frame, const Grid<Dim>& grid,
  const OwnPoints<Real>& own, const typename Octree<Dim>::Options& options,
  const Execution& execution)
{
  PointsOctree<Dim> octree;
  if (own.Merge || own.Others.AreThere())
  {
    octree.Tree = Octree<Dim>(grid, MakeKeys(frame, grid, own, execution.Part(0.0, KeysShare)),
      options, execution.Part(KeysShare, 1.0));
  }
  else
  {
    octree.Tree = Octree<Dim>(Project(own.Points, frame, own.Selection.GetBox()),
      PointSelection<Dim>(own.Selection, frame.GetAxes()), options, execution);
  }
  octree.Counts = octree.Tree.GetDepthCounts();
  octree.TreeBytes = octree.Tree.GetTreeBytes();
  return octree;
}

template <int Dim, typename Real>
PointsOctree<Dim> BuildInFrame(const ProcessGroup& processes, const TreeFrame<Dim>& frame,
  const Box<3>& bounds, const OwnPoints<Real>& own, const typename Octree<Dim>::Options& options,
  const Execution& execution)
{
  const Grid<Dim> grid(
    Box<Dim>(frame.Project(bounds.Lower.data()), frame.Project(bounds.Upper.data())));
  PointsOctree<Dim> octree = processes.AreSeveral()
    ? BuildDistributedOctree(processes, grid,
        MakeKeys(frame, grid, own, execution.Part(0.0, KeysShare)), own.Merge, options,
        execution.Part(KeysShare, 1.0))
    : BuildAlone(frame, grid, own, options, execution);
  octree.Frame = frame;
  const PointCounts counts = own.Counts.SumOf(processes);
  octree.SkippedPoints = counts.Skipped;
  octree.OutsidePoints = counts.Outside;
  return octree;
}

/** Whether all parts have the same values. */
bool AreEqual(const Parted<std::uint64_t>& parts)
{
  const std::size_t count = parts.Counts.front();
  bool areEqual = std::count(parts.Counts.begin(), parts.Counts.end(), count) ==
    static_cast<std::ptrdiff_t>(parts.Counts.size());
  for (std::size_t i = count; areEqual && i < parts.Values.size(); ++i)
  {
    areEqual = parts.Values[i] == parts.Values[i - count];
  }
  return areEqual;
}

/** Where the leaves of a composite data set are, those that hold nothing, too. */
std::vector<std::uint64_t> ListPlaces(vtkDataObjectTreeIterator* leaves)
{
  std::vector<std::uint64_t> indices;
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    indices.push_back(leaves->GetCurrentFlatIndex());
  }
  return indices;
}
}

OctreePass::OctreePass(vtkHashedOctreeAlgorithm* algorithm, const ProcessGroup& processes,
  const std::optional<Box<3>>& bounds)
  : Algorithm(algorithm)
  , Processes(processes)
  , Bounds(bounds)
{
}

OctreePass::OctreePass(
  vtkHashedOctreeAlgorithm* algorithm, const ProcessGroup& processes, KeptOctrees& kept)
  : Algorithm(algorithm)
  , Processes(processes)
  , Kept(&kept)
{
}

void OctreePass::ExecuteAny(
  vtkDataObject* input, const Targets& targets, const MakeOutputs& makeOutputs)
{
  const Execution execution = MakeExecution(this->Algorithm);
  if (this->Kept != nullptr)
  {
    this->Kept->ForgetOthers(input); // Before others are built, which need the memory.
  }
  vtkDataObjectTree* composite = GetTreeOfBlocks(input);
  if (this->Processes.IsTrueInAll(composite != nullptr,
        "Some processes have blocks of points, others have not; give all of them blocks."))
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
  this->Met = this->Met.SumOf(this->Processes);
  this->MetCorners = this->Processes.Max(this->MetCorners ? 1 : 0) > 0;
  this->TellOfPoints();
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
  blocks->SetSkipEmptyNodes(0); // Another process may have something there.
  const std::vector<std::uint64_t> places = ListPlaces(blocks);
  if (!AreEqual(this->Processes.Gather(places)))
  {
    this->Processes = ProcessGroup::OfPart();
  }
  const auto numberOfBlocks = static_cast<double>(places.size());
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
  vtkNew<vtkPolyData> nothing;
  auto* input = vtkPointSet::SafeDownCast(data);
  if (input == nullptr)
  {
    input = nothing;
  }
  const bool isImplicit =
    data != nullptr && input == nothing && data->GetNumberOfElements(vtkDataObject::POINT) > 0;
  this->ImplicitBlocks += this->Processes.Max(isImplicit ? 1 : 0);
  this->MetCorners = this->MetCorners || HaveNodeArrays(input->GetCellData());
  const KeptOctrees::Pointer built = this->FindOrBuild(input, execution);
  this->Met.Add(built->Counts);
  Outputs outputs = built->Octree ? makeOutputs(*built->Octree, execution) : Outputs{};
  for (vtkDataObject* output : outputs)
  {
    PassFieldData(input, output);
  }
  return outputs;
}

KeptOctrees::Pointer OctreePass::FindOrBuild(vtkPointSet* input, const Execution& execution)
{
  const bool keeps = this->Kept != nullptr && !this->Processes.AreSeveral();
  KeptOctrees::Pointer built = keeps ? this->Kept->Find(input) : nullptr;
  if (!built)
  {
    const vtkMTimeType time = KeptOctrees::GetTime(input);
    const vtkMTimeType asked = this->Algorithm->GetMTime();
    built = std::make_shared<const BuiltOctree>(this->Build(input, execution));
    if (keeps && this->Algorithm->GetMTime() == asked) // Observers may have set other properties.
    {
      this->Kept->Keep(input, time, built);
    }
  }
  return built;
}

BuiltOctree OctreePass::Build(vtkPointSet* input, const Execution& execution) const
{
  const auto start = std::chrono::steady_clock::now();
  RequirePointIndices(static_cast<std::size_t>(input->GetNumberOfPoints())); // Before a copy.
  const PointsAdaptor points(input, execution.Part(0.0, AdaptorShare));
  BuiltOctree built;
  points.Visit(
    [&](auto span)
    {
      const PointSelection<3> selection(
        span, this->Bounds, execution.Part(AdaptorShare, SelectionShare));
      const DuplicatePoints others(input);
      const PointCounts counts(
        span, selection, others, execution.Part(SelectionShare, SelectionShare));
      built.Counts = counts;
      const std::optional<Box<3>> bounds = this->FindBounds(selection);
      if (!bounds)
      {
        return;
      }
      const auto build = [&](const auto& frame)
      {
        constexpr int dim = std::tuple_size_v<std::decay_t<decltype(frame.GetAxes())>>;
        auto octree = BuildInFrame(this->Processes, frame, *bounds,
          OwnPoints<std::decay_t<decltype(*span.Coordinates)>>{
            span, selection, others, counts, this->Algorithm->GetMergePoints() },
          GetTreeOptions<dim>(this->Algorithm), execution.Part(SelectionShare, BuildShare));
        if (octree.GetNumberOfPoints() > 0) // Not all are other pieces'.
        {
          built.Octree = std::move(octree);
        }
      };
      const auto plane = FindQuadtreeFrame(this->Algorithm, *bounds);
      plane ? build(*plane) : build(TreeFrame<3>());
    });
  if (built.Octree)
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    double seconds = elapsed.count();
    this->Processes.Max(&seconds, 1);
    std::visit([seconds](auto& octree) { octree.BuildSeconds = seconds; }, *built.Octree);
  }
  return built;
}

std::optional<Box<3>> OctreePass::FindBounds(const PointSelection<3>& selection) const
{
  if (this->Processes.Sum(selection.GetNumberOfPoints()) == 0)
  {
    return {};
  }
  Box<3> bounds = selection.GetBox();
  this->Processes.Min(bounds.Lower.data(), bounds.Lower.size());
  this->Processes.Max(bounds.Upper.data(), bounds.Upper.size());
  return bounds;
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

void OctreePass::TellOfPoints() const
{
  const std::uint64_t all = this->Met.Own + this->Met.Others;
  if (this->ImplicitBlocks > 0 && all == 0 && this->Processes.HaveAll())
  {
    throw std::invalid_argument("The points of the input have no coordinates of their own, as "
                                "those of images; vtkConvertToPointCloud gives them some.");
  }
  if (!this->Processes.IsFirst())
  {
    return; // All would warn of the same.
  }
  if (this->Met.Skipped > 0)
  {
    WarnOfSkippedPoints(this->Algorithm, this->Met.Skipped, static_cast<vtkIdType>(this->Met.Own));
  }
  if (this->ImplicitBlocks > 0)
  {
    vtkWarningWithObjectMacro(this->Algorithm,
      << "Blocks left out because their points have no coordinates of their own, as those of "
         "images: "
      << this->ImplicitBlocks << ". vtkConvertToPointCloud gives them some.");
  }
  if (this->MetCorners)
  {
    vtkWarningWithObjectMacro(this->Algorithm,
      "The points of the input are the corners of an octree's cells. For a tree of the original "
      "points connect the data that this octree was built from.");
  }
}
}
