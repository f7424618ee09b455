// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeNeighborsFilter.h"

#include "AdjacentSearch.h"
#include "AlgorithmOptions.h"
#include "AlgorithmProblems.h"
#include "FieldValue.h"
#include "InRadiusSearch.h"
#include "OctreeCells.h"
#include "OctreePass.h"
#include "ResizeArray.h"
#include "StartDepths.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

using namespace hashedoctree;

vtkStandardNewMacro(vtkHashedOctreeNeighborsFilter);

namespace
{
/** Shares of the progress of one tree: where each step ends. The rest is for Role and Case. */
constexpr double NodesShare = 0.35;
constexpr double CellsShare = 0.95;

/** The query leaf stands apart: what draws boxes leaves out faces that two of them share, all of it
 * among neighbours of its depth, and goes by the points, so that its edges are drawn last. */
constexpr std::size_t QueryLeaves = 1;

constexpr std::size_t ChunkSize = 8192; // Neighbours that a thread does at a time.

template <int Dim>
using Node = typename Octree<Dim>::Node;
template <int Dim>
using Neighbors = std::vector<hashedoctree::Neighbor<Dim>>;

int GetCase(NeighborCase neighborCase)
{
  switch (neighborCase)
  {
    case NeighborCase::SameDepth:
      return vtkHashedOctreeNeighborsFilter::SameDepth;
    case NeighborCase::Descended:
      return vtkHashedOctreeNeighborsFilter::Descended;
    default:
      return vtkHashedOctreeNeighborsFilter::Above;
  }
}

/** The query leaf, then its neighbours. */
template <int Dim>
Buffer<Node<Dim>> ListNodes(const Octree<Dim>& tree, const Node<Dim>& query,
  const Neighbors<Dim>& neighbors, const Execution& execution)
{
  Buffer<Node<Dim>> nodes(1 + neighbors.size());
  nodes[0] = query;
  execution.For(neighbors.size(), ChunkSize,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        nodes[1 + i] = tree.GetChild(neighbors[i].ParentBlock, neighbors[i].Key.GetOctant());
      }
    });
  return nodes;
}

/** Cell arrays Role and Case (active), and the number of neighbours of each case. */
template <int Dim>
void AddNeighborArrays(
  vtkUnstructuredGrid* output, const Neighbors<Dim>& neighbors, const Execution& execution)
{
  using Filter = vtkHashedOctreeNeighborsFilter;
  using Counts = std::array<vtkIdType, 4>;
  vtkNew<vtkIntArray> roles;
  roles->SetName("Role");
  ResizeArray(roles.Get(), 1 + neighbors.size());
  roles->SetValue(0, Filter::Query);
  vtkNew<vtkIntArray> cases;
  cases->SetName("Case");
  ResizeArray(cases.Get(), 1 + neighbors.size());
  cases->SetValue(0, Filter::QueryLeaf);
  const auto ofChunks = execution.MapChunks(neighbors.size(), ChunkSize,
    [&](std::size_t first, std::size_t last)
    {
      Counts ofChunk{};
      for (std::size_t i = first; i < last; ++i)
      {
        const int neighborCase = GetCase(neighbors[i].Case);
        roles->SetValue(static_cast<vtkIdType>(1 + i), Filter::Neighbor);
        cases->SetValue(static_cast<vtkIdType>(1 + i), neighborCase);
        ++ofChunk[static_cast<std::size_t>(neighborCase)];
      }
      return ofChunk;
    });
  Counts counts{};
  for (const Counts& ofChunk : ofChunks)
  {
    std::transform(counts.begin(), counts.end(), ofChunk.begin(), counts.begin(), std::plus<>());
  }
  output->GetCellData()->AddArray(roles);
  output->GetCellData()->AddArray(cases);
  output->GetCellData()->SetActiveScalars("Case");
  vtkFieldData* fieldData = output->GetFieldData();
  AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfSameDepthNeighbors", counts[Filter::SameDepth]);
  AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfDescendedNeighbors", counts[Filter::Descended]);
  AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfAboveNeighbors", counts[Filter::Above]);
}
}

/** What one run of RequestData makes of each tree. */
class vtkHashedOctreeNeighborsFilter::Run
{
public:
  explicit Run(vtkHashedOctreeNeighborsFilter* filter)
    : Self(filter)
    , Reading(GetReading(filter))
  {
  }

  /** Throws std::invalid_argument. */
  void RequireQuery() const
  {
    const double* x = this->Self->Center;
    if (!this->Self->UseLeafKey && !IsFinite(Position<3>{ x[0], x[1], x[2] }))
    {
      throw std::invalid_argument("Center has a coordinate that is not finite; give a position.");
    }
    if (this->Self->SearchMode == InRadius && !(this->Self->Radius >= 0.0))
    {
      std::ostringstream problem;
      problem << "Radius is " << this->Self->Radius << "; give 0 or more.";
      throw std::invalid_argument(problem.str());
    }
  }

  /** The cells for one tree; nothing where it has no query leaf. */
  template <int Dim>
  OctreePass::Outputs Process(const PointsOctree<Dim>& octree, const Execution& execution)
  {
    const Octree<Dim>& tree = octree.Tree;
    const int startDepth = GetStartDepth(tree, GetStartDepthOptions<Dim>(this->Self));
    ++this->Trees;
    const std::optional<Node<Dim>> query = this->FindQuery(octree, startDepth);
    if (!query)
    {
      return {};
    }
    ++this->TreesWithQuery;

    Neighbors<Dim> neighbors;
    NodeCount examined;
    if (this->Self->SearchMode == InRadius)
    {
      FindLeavesInRadius(
        tree, query->NodeKey, this->Self->Radius, startDepth, neighbors, examined, this->Reading);
    }
    else
    {
      FindAdjacentLeaves(tree, query->NodeKey, startDepth, neighbors, examined, this->Reading);
    }

    vtkNew<vtkUnstructuredGrid> cells;
    const Buffer<Node<Dim>> nodes =
      ListNodes<Dim>(tree, *query, neighbors, execution.Part(OctreePass::BuildShare, NodesShare));
    OctreeCells<Dim>(tree, startDepth, nodes, octree.Frame, QueryLeaves)
      .MakeVoxels(cells, execution.Part(NodesShare, CellsShare));
    AddNeighborArrays<Dim>(cells, neighbors, execution.Part(CellsShare, 1.0));
    AddFieldValue<vtkIntArray>(cells->GetFieldData(), "StartDepth", startDepth);
    AddFieldValue<vtkIdTypeArray>(cells->GetFieldData(), "ExaminedNodes", examined.Nodes);
    AddFieldValue<vtkIdTypeArray>(cells->GetFieldData(), "SkippedPoints", octree.SkippedPoints);
    return { cells.Get() };
  }

  /** Throws std::invalid_argument when no tree has the leaf of LeafKey, unless other pieces may
   * have it; warns when trees have none at Center. */
  void CheckQueryLeaves(bool isPiece) const
  {
    if (this->TreesWithQuery == this->Trees)
    {
      return;
    }
    if (!this->Self->UseLeafKey)
    {
      std::ostringstream where;
      if (this->Trees > 1)
      {
        where << " of " << this->Trees - this->TreesWithQuery << " of " << this->Trees
              << " octrees";
      }
      vtkWarningWithObjectMacro(this->Self,
        << "Center lies in an empty cell" << where.str()
        << ", where there is no leaf; move it to points, or turn IncludeEmptyLeaves on.");
    }
    else if (this->TreesWithQuery == 0 && !isPiece)
    {
      std::ostringstream problem;
      problem << "LeafKey " << this->Self->LeafKey
              << " names no leaf; give the MortonKey of one that vtkHashedOctreeFilter shows with "
                 "the same properties.";
      throw std::invalid_argument(problem.str());
    }
  }

private:
  template <int Dim>
  std::optional<Node<Dim>> FindQuery(const PointsOctree<Dim>& octree, int startDepth) const
  {
    const Octree<Dim>& tree = octree.Tree;
    MortonKey<Dim> key(static_cast<std::uint64_t>(this->Self->LeafKey));
    if (!this->Self->UseLeafKey)
    {
      const Position<Dim> center = octree.Frame.Project(this->Self->Center);
      key = FindLeaf(tree, tree.GetGrid().GetKey(center), startDepth).Key;
    }
    const std::optional<Node<Dim>> node = tree.FindNode(key, this->Reading);
    return node && !node->Internal ? node : std::nullopt;
  }

  vtkHashedOctreeNeighborsFilter* Self;
  EmptyOctants Reading;
  int Trees = 0;
  int TreesWithQuery = 0;
};

vtkHashedOctreeNeighborsFilter::vtkHashedOctreeNeighborsFilter()
{
  // Most positions in the box of a scan lie in empty leaves.
  this->IncludeEmptyLeaves = true;
}

int vtkHashedOctreeNeighborsFilter::GetTypeOfOutput(
  int vtkNotUsed(port), vtkInformationVector** vtkNotUsed(inputVector))
{
  return VTK_UNSTRUCTURED_GRID;
}

int vtkHashedOctreeNeighborsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return RunReportingProblems(this, outputVector,
    [&]
    {
      Run run(this);
      run.RequireQuery();
      OctreePass(this).Execute(vtkDataObject::GetData(inputVector[0]), request, outputVector,
        [&run](const auto& octree, const Execution& execution)
        { return run.Process(octree, execution); });
      run.CheckQueryLeaves(OctreePass::IsPiece(request, outputVector));
    });
}

void vtkHashedOctreeNeighborsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SearchMode: " << this->SearchMode << "\n";
  os << indent << "Center: " << this->Center[0] << ", " << this->Center[1] << ", "
     << this->Center[2] << "\n";
  os << indent << "UseLeafKey: " << this->UseLeafKey << "\n";
  os << indent << "LeafKey: " << this->LeafKey << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
}
