// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointTree_h
#define hashedoctree_PointTree_h

#include "BoxKernels.h"
#include "FreeSpace.h"
#include "Octree.h"
#include "PointKernels.h"
#include "StartDepths.h"

#include <vector>

namespace hashedoctree
{
/**
 * An octree with what searches for points need beside it: the points in Morton order, in the
 * precision of the input, the tight box of every child, the start depths, and where no points are.
 * The input may go away once the tree is built.
 *
 * Nested trees: keys end at MortonKey::MaxDepth, and a leaf there may hold any number of points.
 * One that holds more than GetMostAtLastDepth(), not all at one place, gets a tree of its own in
 * its own box, with the same options, so that no search is linear in the number of points unless
 * they coincide. (Not where the options ask for less depth: then the leaves are as large as was
 * asked for.)
 *
 * Immutable but for the start depths; const members may be called from many threads at once.
 */
template <int Dim, typename Real>
class PointTree
{
public:
  using Options = typename Octree<Dim>::Options;

  /** The tree of no points. */
  PointTree() = default;

  /** Of the selected points; O(n). Searches start at the median until SetStartDepths() says
   * otherwise. Throws as Octree does. */
  PointTree(PointSpan<Dim, Real> points, const PointSelection<Dim>& selection,
    const Options& options, const Execution& execution);

  const Octree<Dim>& GetOctree() const { return this->Tree; }
  std::size_t GetNumberOfPoints() const { return this->Tree.GetNumberOfPoints(); }

  /** Chooses anew where searches start, in nested trees too: by the same options, but for the Local
   * model at their medians. Where memory is out it throws std::bad_alloc, and the start depths are
   * as before, but perhaps for some nested trees. */
  void SetStartDepths(const StartDepthOptions& options);
  const StartDepths<Dim>& GetStartDepths() const { return this->Starts; }

  const FreeSpace<Dim>& GetFreeSpace() const { return this->Free; }
  /** Along which the points are flat. */
  const FlatAxes<Dim>& GetFlatAxes() const { return this->Flat; }

  /** Coordinates of the points of a leaf, given where its range begins: axis after axis, so that
   * the points of a leaf are near each other in memory and of one kind in a vector. No meaning for
   * a leaf with a nested tree. */
  const Real* GetLeafCoordinates(PointIndex firstPoint) const
  {
    return this->Coordinates + Dim * static_cast<std::size_t>(firstPoint);
  }
  /** Ids of all points, leaf after leaf. */
  const PointIndex* GetIds() const { return this->Ids; }
  const ChildBoxes<Dim>& GetChildBoxes(std::size_t block) const { return this->Boxes[block]; }
  /** What measures the distances to coordinates. */
  const PointKernels<Dim, Real>& GetPointKernels() const { return *this->KernelsOfPoints; }
  /** What measures the distances to boxes. */
  const BoxKernels<Dim>& GetBoxKernels() const { return *this->KernelsOfBoxes; }

  /** Whether nothing in a block parts its points: it has one child that holds points, and that is
   * internal. */
  bool IsLink(std::size_t block) const
  {
    const auto octants = this->Tree.GetOctants(block);
    return (octants.Occupied & (octants.Occupied - 1U)) == 0 && octants.Internal != 0;
  }
  /** The first block from a block down that is no link. */
  std::uint32_t GetFork(std::size_t block) const { return this->Forks[block]; }

  /** Whether points at different places are parted however near they are: then a leaf of more
   * points than GetMostAtLastDepth() has a nested tree, or all of them are at one place, by id. */
  bool PartsAllPlaces() const
  {
    return this->Tree.GetOptions().MaxDepth == MortonKey<Dim>::MaxDepth;
  }
  /** What a leaf at the last depth may hold without a nested tree: four times MaxPointsPerLeaf, and
   * at least 32. No leaf above holds more. */
  std::size_t GetMostAtLastDepth() const { return this->MostAtLastDepth; }
  /** The nested tree of a leaf, given where its range begins, or null. O(log nested trees). */
  const PointTree* FindNested(PointIndex firstPoint) const;

  /** Bytes of all of it: tree, order, boxes, coordinates, start depths and nested trees. */
  std::size_t GetBytes() const;

private:
  struct Nested;
  struct PointRange;
  struct CellBox;
  struct Subtree;

  /** With the coordinates in memory of its own, or in that of others if any, which ends no sooner.
   */
  PointTree(PointSpan<Dim, Real> points, const PointSelection<Dim>& selection,
    const Options& options, const Execution& execution, Buffer<Real> own, Real* others);

  void CopyPoints(PointSpan<Dim, Real> points, const Execution& execution);
  void ListSubtrees(std::uint32_t block, std::vector<Subtree>& subtrees) const;
  CellBox CopySubtree(std::uint32_t block, PointSpan<Dim, Real> points, const Execution& execution);
  CellBox CopyAbove(std::uint32_t block, PointSpan<Dim, Real> points, const Execution& execution,
    const std::vector<Subtree>& subtrees, std::size_t& next);
  template <typename GetBox>
  CellBox CopyBlock(std::uint32_t block, PointSpan<Dim, Real> points, const Execution& execution,
    const GetBox& getBox);
  CellBox CopyLeaf(const PointRange& leaf, PointSpan<Dim, Real> points, const Execution& execution);
  CellBox CopyPart(const PointRange& part, const PointRange& leaf, PointSpan<Dim, Real> points);
  void BuildNested(PointSpan<Dim, Real> points, const Execution& execution);
  void BuildNestedIn(
    typename Octree<Dim>::Node leaf, PointSpan<Dim, Real> points, const Execution& execution);
  void TranslateIds(const PointIndex* ids, const Execution& execution);

  Octree<Dim> Tree;
  std::size_t MostAtLastDepth = 0;
  StartDepths<Dim> Starts;
  const PointIndex* Ids = nullptr; ///< The tree's, or those in OwnIds.
  Buffer<PointIndex> OwnIds;       ///< Of a nested tree: ids in the whole input.
  Buffer<Real> OwnCoordinates;
  Real* Coordinates = nullptr; ///< Own ones; a nested tree's are in place of its leaf's.
  Buffer<ChildBoxes<Dim>> Boxes;
  Buffer<std::uint32_t> Forks;
  FreeSpace<Dim> Free;
  FlatAxes<Dim> Flat;
  std::vector<Nested> NestedTrees; ///< By FirstPoint.
  const PointKernels<Dim, Real>* KernelsOfPoints = &hashedoctree::GetPointKernels<Dim, Real>();
  const BoxKernels<Dim>* KernelsOfBoxes = &hashedoctree::GetBoxKernels<Dim>();
};

/** A tree in a leaf. */
template <int Dim, typename Real>
struct PointTree<Dim, Real>::Nested
{
  PointIndex FirstPoint; ///< Where the leaf's range begins.
  PointTree Points;
};
}

#endif
