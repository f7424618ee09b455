// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeHyperTree.h"

#include "NodeArrays.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTree.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

namespace hashedoctree
{
namespace
{
constexpr std::size_t NodesAtATime = 512; // That a thread does.

/** Where VTK has an octant among its siblings: with the bits of the axes turned around. */
template <int Dim>
unsigned GetPlaceOfOctant(unsigned octant)
{
  unsigned place = 0;
  for (int axis = 0; axis < Dim; ++axis)
  {
    place |= (octant >> axis & 1U) << (Dim - 1 - axis);
  }
  return place;
}

/** The vertex of the child in an octant of an internal node. */
template <int Dim>
std::size_t GetChildVertex(std::size_t block, unsigned octant)
{
  return 1 + Octree<Dim>::NumberOfOctants * block + GetPlaceOfOctant<Dim>(octant);
}

/** All nodes in the order of the vertices. */
template <int Dim>
Buffer<typename Octree<Dim>::Node> ListVertices(const Octree<Dim>& tree, const Execution& execution)
{
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  Buffer<typename Octree<Dim>::Node> nodes(tree.GetNumberOfNodes());
  nodes[0] = tree.GetRoot();
  execution.ForEach(numberOfBlocks, NodesAtATime,
    [&](std::size_t block)
    {
      for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
      {
        nodes[GetChildVertex<Dim>(block, octant)] = tree.GetChild(block, octant);
      }
    });
  return nodes;
}

/** The root as the only cell of the grid. */
template <int Dim>
void PlaceRoot(const Octree<Dim>& tree, const TreeFrame<Dim>& frame, vtkHyperTreeGrid* output)
{
  Cell<Dim> corner;
  double lower[3];
  double upper[3];
  corner.fill(0);
  frame.GetCorner(tree.GetGrid(), corner, lower);
  corner.fill(static_cast<std::uint32_t>(MortonKey<Dim>::CellsPerSide));
  frame.GetCorner(tree.GetGrid(), corner, upper);

  unsigned dimensions[3] = { 1, 1, 1 };
  for (const int axis : frame.GetAxes())
  {
    dimensions[axis] = 2;
  }
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    coordinates[axis]->InsertNextValue(lower[axis]);
    if (dimensions[axis] == 2)
    {
      coordinates[axis]->InsertNextValue(upper[axis]);
    }
  }
  output->SetBranchFactor(BranchFactor);
  output->SetDimensions(dimensions);
  output->SetXCoordinates(coordinates[0]);
  output->SetYCoordinates(coordinates[1]);
  output->SetZCoordinates(coordinates[2]);
}

/** Splits the root and what comes of it: each internal node in its turn, so that its children have
 * the numbers of GetChildVertex(). */
template <int Dim>
void Subdivide(const Octree<Dim>& tree, vtkHyperTree* hyperTree, const Execution& execution)
{
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  if (numberOfBlocks > 0)
  {
    hyperTree->SubdivideLeaf(0, 0);
  }
  execution.OnOneThread().ForEach(numberOfBlocks, NodesAtATime,
    [&](std::size_t block)
    {
      const int depth = tree.GetBlockKey(block).GetDepth() + 1;
      for (unsigned rest = tree.GetOctants(block).Internal; rest != 0; rest &= rest - 1)
      {
        const auto octant = static_cast<unsigned>(__builtin_ctz(rest));
        hyperTree->SubdivideLeaf(
          static_cast<vtkIdType>(GetChildVertex<Dim>(block, octant)), static_cast<unsigned>(depth));
      }
    });
}

/** Masks the vertices that are not to be seen. */
template <typename IsMasked>
void MaskVertices(
  std::size_t count, const IsMasked& isMasked, vtkHyperTreeGrid* output, const Execution& execution)
{
  vtkNew<vtkBitArray> mask;
  mask->SetNumberOfTuples(static_cast<vtkIdType>(count));
  execution.OnOneThread().ForEach(count, NodesAtATime,
    [&](std::size_t i) { mask->SetValue(static_cast<vtkIdType>(i), isMasked(i) ? 1 : 0); });
  output->SetMask(mask);
}

/** The arrays of all vertices, and the mask. */
template <int Dim>
void DescribeVertices(const PointsOctree<Dim>& octree, int startDepth, bool showsEmptyLeaves,
  vtkHyperTreeGrid* output, const Execution& execution)
{
  const Octree<Dim>& tree = octree.Tree;
  auto nodes = ListVertices(tree, execution.Part(0.0, 0.1));
  octree.CompletePoints(nodes);
  AddNodeArrays(tree, startDepth, nodes, output->GetCellData(), execution.Part(0.1, 0.8));
  const bool hidesSome = !showsEmptyLeaves && tree.GetNumberOfEmptyLeaves() > 0;
  if (hidesSome || octree.Processes.AreSeveral())
  {
    const auto isMasked = [&](std::size_t i)
    {
      const typename Octree<Dim>::Node& node = nodes[i];
      return !node.Internal && ((hidesSome && node.IsEmpty()) || !octree.Range.Has(node.NodeKey));
    };
    MaskVertices(nodes.GetSize(), isMasked, output, execution.Part(0.8, 1.0));
  }
}
}

template <int Dim>
void FillHyperTreeGrid(const PointsOctree<Dim>& octree, int startDepth, bool showsEmptyLeaves,
  vtkHyperTreeGrid* output, const Execution& execution)
{
  const Octree<Dim>& tree = octree.Tree;
  RequireHyperTreeVertices(tree.GetNumberOfNodes());
  DescribeVertices(octree, startDepth, showsEmptyLeaves, output, execution.Part(0.0, 0.8));
  PlaceRoot(tree, octree.Frame, output);
  vtkHyperTree* hyperTree = output->GetTree(0, /*create=*/true);
  hyperTree->SetGlobalIndexStart(0);
  Subdivide(tree, hyperTree, execution.Part(0.8, 1.0));
}

void HandOver(vtkDataObject* from, vtkDataObject* to)
{
  auto* grid = vtkHyperTreeGrid::SafeDownCast(from);
  const vtkSmartPointer<vtkBitArray> mask = grid != nullptr ? grid->GetMask() : nullptr;
  if (mask)
  {
    grid->SetMask(nullptr);
  }
  to->ShallowCopy(from);
  if (mask)
  {
    vtkHyperTreeGrid::SafeDownCast(to)->SetMask(mask);
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void FillHyperTreeGrid(                                                                 \
    const PointsOctree<Dim>&, int, bool, vtkHyperTreeGrid*, const Execution&);
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
#undef HASHEDOCTREE_INSTANTIATE
}
