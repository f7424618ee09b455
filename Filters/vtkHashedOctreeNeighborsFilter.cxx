// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreeNeighborsFilter.h"

#include "AdjacentSearch.h"
#include "AlgorithmOptions.h"
#include "DepthStatistics.h"
#include "FieldValue.h"
#include "InRadiusSearch.h"
#include "OctreeCells.h"
#include "OctreePass.h"
#include "PieceRequest.h"
#include "RangeCount.h"
#include "ResizeArray.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
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

constexpr std::size_t ChunkSize = 8192; // Neighbours that a thread does at a time.

template <int Dim>
using Node = typename Octree<Dim>::Node;
/** How many neighbours of each case there are. */
using CaseCounts = std::vector<std::uint64_t>;
constexpr std::size_t NumberOfCases = vtkHashedOctreeNeighborsFilter::Above + 1;
template <int Dim>
using Neighbors = std::vector<hashedoctree::Neighbor<Dim>>;

/** The case of a neighbour by its depth, and that of the node that it is a neighbour of. */
int GetCase(int depth, int nodeDepth)
{
  using Filter = vtkHashedOctreeNeighborsFilter;
  return depth == nodeDepth ? Filter::SameDepth
    : depth > nodeDepth     ? Filter::Descended
                            : Filter::Above;
}

/** The query leaf, where it is given, then its neighbours. */
template <int Dim>
Buffer<Node<Dim>> ListQueryAndNeighbors(const Octree<Dim>& tree,
  const std::optional<Node<Dim>>& query, const Neighbors<Dim>& neighbors,
  const Execution& execution)
{
  const std::size_t queries = query ? 1 : 0;
  Buffer<Node<Dim>> nodes(queries + neighbors.size());
  if (query)
  {
    nodes[0] = *query;
  }
  execution.For(neighbors.size(), ChunkSize,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        nodes[queries + i] = tree.GetChild(neighbors[i].ParentBlock, neighbors[i].Key.GetOctant());
      }
    });
  return nodes;
}

/** Cell arrays Role and Case (active) of the query leaf, if it is there, and its neighbours.
 * Returns the number of neighbours of each case. */
template <int Dim>
CaseCounts AddNeighborArrays(vtkUnstructuredGrid* output, std::size_t queries, int queryDepth,
  const Neighbors<Dim>& neighbors, const Execution& execution)
{
  using Filter = vtkHashedOctreeNeighborsFilter;
  const auto roles = MakeArray<vtkIntArray>("Role", queries + neighbors.size());
  const auto cases = MakeArray<vtkIntArray>("Case", queries + neighbors.size());
  if (queries > 0)
  {
    roles->SetValue(0, Filter::Query);
    cases->SetValue(0, Filter::QueryLeaf);
  }
  const auto ofChunks = execution.MapChunks(neighbors.size(), ChunkSize,
    [&](std::size_t first, std::size_t last)
    {
      CaseCounts ofChunk(NumberOfCases);
      for (std::size_t i = first; i < last; ++i)
      {
        const int neighborCase = GetCase(neighbors[i].Key.GetDepth(), queryDepth);
        roles->SetValue(static_cast<vtkIdType>(queries + i), Filter::Neighbor);
        cases->SetValue(static_cast<vtkIdType>(queries + i), neighborCase);
        ++ofChunk[static_cast<std::size_t>(neighborCase)];
      }
      return ofChunk;
    });
  output->GetCellData()->AddArray(roles);
  output->GetCellData()->AddArray(cases);
  output->GetCellData()->SetActiveScalars("Case");
  CaseCounts counts(NumberOfCases);
  for (const CaseCounts& ofChunk : ofChunks)
  {
    std::transform(counts.begin(), counts.end(), ofChunk.begin(), counts.begin(), std::plus<>());
  }
  return counts;
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
    const int startDepth = GetStartDepth(octree.Counts, GetStartDepthOptions<Dim>(this->Self), Dim);
    ++this->Trees;
    const std::uint64_t found = this->FindQuery(octree, startDepth).GetValue();
    const MortonKey<Dim> query(octree.Processes.Sum(found)); // One process at most has it.
    if (query == MortonKey<Dim>(0))
    {
      return {};
    }
    ++this->TreesWithQuery;
    RangeCount<Dim> examined(octree.Range);
    const Neighbors<Dim> neighbors = this->FindNeighbors(octree, query, startDepth, examined);
    vtkNew<vtkUnstructuredGrid> cells;
    CaseCounts counts = MakeCells(octree, query, startDepth, neighbors, cells, execution);
    octree.Processes.Sum(counts);

    vtkFieldData* fieldData = cells->GetFieldData();
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfSameDepthNeighbors", counts[SameDepth]);
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfDescendedNeighbors", counts[Descended]);
    AddFieldValue<vtkIdTypeArray>(fieldData, "NumberOfAboveNeighbors", counts[Above]);
    AddFieldValue<vtkIntArray>(fieldData, "StartDepth", startDepth);
    AddFieldValue<vtkIdTypeArray>(
      fieldData, "ExaminedNodes", octree.Processes.Sum(examined.GetNodes()));
    AddFieldValue<vtkIdTypeArray>(fieldData, "SkippedPoints", octree.SkippedPoints);
    return { cells.Get() };
  }

  /** Throws std::invalid_argument when no tree has the leaf of LeafKey, unless other pieces may
   * have it, which are not of these processes; warns when trees have none at Center. */
  void CheckQueryLeaves(const ProcessGroup& processes) const
  {
    if (this->TreesWithQuery == this->Trees)
    {
      return;
    }
    if (!this->Self->UseLeafKey)
    {
      if (!processes.IsFirst())
      {
        return; // All would warn of the same.
      }
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
    else if (this->TreesWithQuery == 0 && processes.HaveAll())
    {
      std::ostringstream problem;
      problem << "LeafKey " << this->Self->LeafKey
              << " names no leaf; give the MortonKey of one that vtkHashedOctreeFilter shows with "
                 "the same properties.";
      throw std::invalid_argument(problem.str());
    }
  }

private:
  /** The leaf, if it is to be found in this process's part of the tree, else key 0. */
  template <int Dim>
  MortonKey<Dim> FindQuery(const PointsOctree<Dim>& octree, int startDepth) const
  {
    const Octree<Dim>& tree = octree.Tree;
    MortonKey<Dim> key(static_cast<std::uint64_t>(this->Self->LeafKey));
    MortonKey<Dim> where = key;
    if (!this->Self->UseLeafKey)
    {
      where = tree.GetGrid().GetKey(octree.Frame.Project(this->Self->Center));
      key = FindLeaf(tree, where, startDepth).Key;
    }
    const std::optional<Node<Dim>> node = tree.FindNode(key, this->Reading);
    return node && !node->Internal && octree.Range.Has(where) ? key : MortonKey<Dim>(0);
  }

  /** Those in this process's part of the tree. */
  template <int Dim>
  Neighbors<Dim> FindNeighbors(const PointsOctree<Dim>& octree, MortonKey<Dim> query,
    int startDepth, RangeCount<Dim>& examined) const
  {
    const Octree<Dim>& tree = octree.Tree;
    Neighbors<Dim> found;
    if (this->Self->SearchMode == InRadius)
    {
      FindLeavesInRadius(
        tree, query, this->Self->Radius, startDepth, found, examined, this->Reading);
    }
    else
    {
      FindAdjacentLeaves(tree, query, startDepth, found, examined, this->Reading);
    }
    const auto isElsewhere = [&octree](const hashedoctree::Neighbor<Dim>& neighbor)
    { return !octree.Range.Has(neighbor.Key); };
    found.erase(std::remove_if(found.begin(), found.end(), isElsewhere), found.end());
    return found;
  }

  /** Returns the number of neighbours of each case. */
  template <int Dim>
  static CaseCounts MakeCells(const PointsOctree<Dim>& octree, MortonKey<Dim> query, int startDepth,
    const Neighbors<Dim>& neighbors, vtkUnstructuredGrid* cells, const Execution& execution)
  {
    std::optional<Node<Dim>> listed;
    if (octree.Range.Has(query))
    {
      listed = octree.Tree.FindNode(query);
    }
    // The query leaf stands apart: what draws boxes leaves out faces that two of them share, all of
    // it among neighbours of its depth, and goes by the points, so that its edges are drawn last.
    const std::size_t apart = listed ? 1 : 0;
    const Buffer<Node<Dim>> nodes = ListQueryAndNeighbors<Dim>(
      octree.Tree, listed, neighbors, execution.Part(OctreePass::BuildShare, NodesShare));
    OctreeCells<Dim>(octree.Tree, startDepth, nodes, octree.Frame, apart)
      .MakeVoxels(cells, execution.Part(NodesShare, CellsShare));
    return AddNeighborArrays<Dim>(
      cells, apart, query.GetDepth(), neighbors, execution.Part(CellsShare, 1.0));
  }

  vtkHashedOctreeNeighborsFilter* Self;
  EmptyOctants Reading;
  int Trees = 0;
  int TreesWithQuery = 0;
};

vtkHashedOctreeNeighborsFilter::vtkHashedOctreeNeighborsFilter()
{
  // Most positions in the box of a scan lie in empty leaves.
  this->SetIncludeEmptyLeaves(true);
}

void vtkHashedOctreeNeighborsFilter::SetSearchMode(int mode)
{
  this->SetOfSearches<int>(this->SearchMode, std::clamp<int>(mode, Adjacent, InRadius));
}

void vtkHashedOctreeNeighborsFilter::SetCenter(double x, double y, double z)
{
  const double center[] = { x, y, z };
  this->SetCenter(center);
}

void vtkHashedOctreeNeighborsFilter::SetCenter(const double x[3])
{
  if (!std::equal(x, x + 3, this->Center))
  {
    std::copy_n(x, 3, this->Center);
    this->ModifiedSearches();
  }
}

void vtkHashedOctreeNeighborsFilter::SetUseLeafKey(bool use)
{
  this->SetOfSearches(this->UseLeafKey, use);
}

void vtkHashedOctreeNeighborsFilter::SetLeafKey(vtkTypeInt64 key)
{
  this->SetOfSearches(this->LeafKey, key);
}

void vtkHashedOctreeNeighborsFilter::SetRadius(double radius)
{
  this->SetOfSearches(this->Radius, radius);
}

int vtkHashedOctreeNeighborsFilter::GetTypeOfOutput(
  int vtkNotUsed(port), vtkInformationVector** vtkNotUsed(inputVector))
{
  return VTK_UNSTRUCTURED_GRID;
}

int vtkHashedOctreeNeighborsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return RunTogether(this, request, outputVector,
    [&](const ProcessGroup& processes)
    {
      Run run(this);
      run.RequireQuery();
      OctreePass pass(this, processes, this->GetKeptOctrees());
      pass.Execute(vtkDataObject::GetData(inputVector[0]), OctreePass::GetPorts(outputVector),
        [&run](const auto& octree, const Execution& execution)
        { return run.Process(octree, execution); });
      run.CheckQueryLeaves(pass.GetProcesses());
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
