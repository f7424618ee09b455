// SPDX-License-Identifier: BSD-3-Clause
#include "PointTree.h"

#include "ForEachDimension.h"

#include <algorithm>
#include <limits>

namespace hashedoctree
{
namespace
{
constexpr std::size_t MostPointsOfTask = 16384;  // That a thread copies at a time.
constexpr std::size_t PointsAhead = 64;          // Points that are on the way from the input,
constexpr std::size_t MostInSecondCache = 65536; // when it has more points than these.

/** How many points a leaf at the last depth may hold: so few are scanned as fast as a tree is
 * searched, which takes 1.4 kilobytes. */
std::size_t ChooseMostAtLastDepth(std::size_t maxPointsPerLeaf)
{
  constexpr std::size_t factor = 4;
  constexpr std::size_t least = 32;
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max() / factor;
  return std::max(factor * std::min(maxPointsPerLeaf, most), least);
}

/** Steps of a block at `depth` up to a cell of MaxDepth in it. */
template <int Dim>
std::uint8_t GetStep(std::uint32_t cell, int depth)
{
  const int shift = MortonKey<Dim>::MaxDepth - depth;
  const std::uint64_t within = cell & ((std::uint64_t(1) << shift) - 1);
  return static_cast<std::uint8_t>(within * ChildBoxes<Dim>::Steps >> shift);
}

/** The last step that a cell of MaxDepth touches: where a step is smaller than a cell, not the
 * first one. */
template <int Dim>
std::uint8_t GetLastStep(std::uint32_t cell, int depth)
{
  const int shift = MortonKey<Dim>::MaxDepth - depth;
  const std::uint64_t within = (cell & ((std::uint64_t(1) << shift) - 1)) + 1;
  return static_cast<std::uint8_t>((within * ChildBoxes<Dim>::Steps - 1) >> shift);
}

/** Asks the machine to load points of the input, which may lie in two lines of the cache each. Into
 * the second cache, which can wait for more of them at a time than the first. (Inline for the
 * reason of NodeTable::Prefetch().) */
template <int Dim, typename Real>
[[gnu::always_inline]] inline void Prefetch(
  PointSpan<Dim, Real> points, const PointIndex* ids, const PointIndex* end)
{
  constexpr int intoSecondCache = 2;
  for (; ids < end; ++ids)
  {
    const Real* x = points[*ids];
    __builtin_prefetch(x, 0, intoSecondCache);
    __builtin_prefetch(x + Dim - 1, 0, intoSecondCache);
  }
}

template <int Dim, typename Real>
Buffer<Real> MakeCoordinates(std::size_t numberOfPoints)
{
  constexpr std::size_t padding = PointKernels<Dim, Real>::Padding;
  Buffer<Real> coordinates(Dim * numberOfPoints + padding);
  std::fill_n(&coordinates[Dim * numberOfPoints], padding, Real(0));
  return coordinates;
}
}

/** Points in their order, [First, Last). */
template <int Dim, typename Real>
struct PointTree<Dim, Real>::PointRange
{
  PointIndex First;
  PointIndex Last;
};

/** Cells of MaxDepth between two corners, both of them included. */
template <int Dim, typename Real>
struct PointTree<Dim, Real>::CellBox
{
  Cell<Dim> Lower;
  Cell<Dim> Upper;

  static CellBox OfNone()
  {
    CellBox none;
    none.Lower.fill(~std::uint32_t(0));
    none.Upper.fill(0);
    return none;
  }

  void Add(const CellBox& other)
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Lower[axis] = std::min(this->Lower[axis], other.Lower[axis]);
      this->Upper[axis] = std::max(this->Upper[axis], other.Upper[axis]);
    }
  }
};

/** A block with all that is below it, and the cells that its points lie in. */
template <int Dim, typename Real>
struct PointTree<Dim, Real>::Subtree
{
  std::uint32_t Block;
  CellBox Box;
};

template <int Dim, typename Real>
PointTree<Dim, Real>::PointTree(PointSpan<Dim, Real> points, const PointSelection<Dim>& selection,
  const Options& options, const Execution& execution)
  : PointTree(points, selection, options, execution,
      MakeCoordinates<Dim, Real>(selection.GetNumberOfPoints()), nullptr)
{
}

template <int Dim, typename Real>
PointTree<Dim, Real>::PointTree(PointSpan<Dim, Real> points, const PointSelection<Dim>& selection,
  const Options& options, const Execution& execution, Buffer<Real> own, Real* others)
  : Tree(points, selection, options, execution.Part(0.0, 0.6),
      // The coordinates are copied after the points are in order.
      { others == nullptr ? own.GetData() : others,
        Dim * sizeof(Real) * selection.GetNumberOfPoints() })
  , MostAtLastDepth(ChooseMostAtLastDepth(options.MaxPointsPerLeaf))
  , Starts(this->Tree, StartDepthOptions())
  , Ids(this->Tree.GetPointIds())
  , OwnCoordinates(std::move(own))
  , Coordinates(others == nullptr ? this->OwnCoordinates.GetData() : others)
{
  this->CopyPoints(points, execution.Part(0.6, 0.9));
  if (this->Tree.IsRootInternal())
  {
    this->Free = FreeSpace<Dim>(this->Tree, this->Boxes);
    this->Flat = FlatAxes<Dim>(selection.GetBox(), this->Tree.GetGrid());
  }
  this->BuildNested(points, execution.Part(0.9, 1.0));
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::SetStartDepths(const StartDepthOptions& options)
{
  StartDepths<Dim> starts(this->Tree, options);
  StartDepthOptions ofNested = options;
  if (options.Model == StartDepthModel::Local)
  {
    ofNested.Model = StartDepthModel::Median; // They are in one place each.
  }
  for (Nested& nested : this->NestedTrees)
  {
    nested.Points.SetStartDepths(ofNested);
  }
  this->Starts = std::move(starts);
}

template <int Dim, typename Real>
std::size_t PointTree<Dim, Real>::GetBytes() const
{
  std::size_t bytes = this->Tree.GetTreeBytes() + this->Tree.GetOrderBytes() +
    this->OwnIds.GetBytes() + this->Boxes.GetBytes() + this->Forks.GetBytes() +
    this->Free.GetBytes() + this->OwnCoordinates.GetBytes() + this->Starts.GetBytes();
  for (const Nested& nested : this->NestedTrees)
  {
    bytes += sizeof(Nested) + nested.Points.GetBytes();
  }
  return bytes;
}

/** Copies the points of a leaf, which must not be empty, and returns the cells that they lie in.
 * More points than a task has come after the tasks, with progress at its end. */
template <int Dim, typename Real>
typename PointTree<Dim, Real>::CellBox PointTree<Dim, Real>::CopyLeaf(
  const PointRange& leaf, PointSpan<Dim, Real> points, const Execution& execution)
{
  const std::size_t count = leaf.Last - leaf.First;
  if (count <= MostPointsOfTask)
  {
    return this->CopyPart(leaf, leaf, points);
  }
  const auto boxes = execution.Part(1.0, 1.0).MapChunks(count, MostPointsOfTask,
    [&](std::size_t first, std::size_t last)
    {
      const PointRange part{ static_cast<PointIndex>(leaf.First + first),
        static_cast<PointIndex>(leaf.First + last) };
      return this->CopyPart(part, leaf, points);
    });
  CellBox whole = CellBox::OfNone();
  for (const CellBox& box : boxes)
  {
    whole.Add(box);
  }
  return whole;
}

/** Copies some points of a leaf, at least one, and returns the cells that they lie in. */
template <int Dim, typename Real>
typename PointTree<Dim, Real>::CellBox PointTree<Dim, Real>::CopyPart(
  const PointRange& part, const PointRange& leaf, PointSpan<Dim, Real> points)
{
  const std::size_t end = this->GetNumberOfPoints();
  if (end > MostInSecondCache)
  {
    Prefetch(points, this->Ids + std::min(part.First + PointsAhead, end),
      this->Ids + std::min(part.Last + PointsAhead, end));
  }
  const std::size_t count = leaf.Last - leaf.First;
  Real* coordinates =
    this->Coordinates + Dim * static_cast<std::size_t>(leaf.First) + (part.First - leaf.First);
  std::array<Real, Dim> lower;
  std::array<Real, Dim> upper;
  lower.fill(std::numeric_limits<Real>::max());
  upper.fill(std::numeric_limits<Real>::lowest());
  for (std::size_t i = 0; i < part.Last - part.First; ++i)
  {
    const Real* x = points[this->Ids[part.First + i]];
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      coordinates[axis * count + i] = x[axis];
      lower[axis] = std::min(lower[axis], x[axis]);
      upper[axis] = std::max(upper[axis], x[axis]);
    }
  }
  const Grid<Dim>& grid = this->Tree.GetGrid();
  return CellBox{ grid.GetCell(lower), grid.GetCell(upper) };
}

/** Copies the points of the leaves of a block, and fills the boxes of its children and its fork.
 * `getBox(block)` sees to an internal child, and returns, as this does, the cells that its points
 * lie in. */
template <int Dim, typename Real>
template <typename GetBox>
typename PointTree<Dim, Real>::CellBox PointTree<Dim, Real>::CopyBlock(std::uint32_t block,
  PointSpan<Dim, Real> points, const Execution& execution, const GetBox& getBox)
{
  const auto& children = this->Tree.GetBlock(block);
  const auto octants = this->Tree.GetOctants(block);
  const int depth = this->Tree.GetBlockKey(block).GetDepth();
  CellBox whole = CellBox::OfNone();
  for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
  {
    if ((octants.Occupied >> octant & 1U) == 0)
    {
      continue;
    }
    const CellBox box = (octants.Internal >> octant & 1U) != 0
      ? getBox(this->Tree.GetChildBlock(block, octant))
      : this->CopyLeaf(
          { children.FirstPoint[octant], children.FirstPoint[octant + 1] }, points, execution);
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Boxes[block].Lower[axis][octant] = GetStep<Dim>(box.Lower[axis], depth);
      this->Boxes[block].Upper[axis][octant] = GetLastStep<Dim>(box.Upper[axis], depth);
    }
    whole.Add(box);
  }
  this->Forks[block] = this->IsLink(block) ? this->Forks[octants.FirstChild] : block;
  return whole;
}

/** Copies all points below a block, in their order. */
template <int Dim, typename Real>
typename PointTree<Dim, Real>::CellBox PointTree<Dim, Real>::CopySubtree(
  std::uint32_t block, PointSpan<Dim, Real> points, const Execution& execution)
{
  return this->CopyBlock(block, points, execution,
    [&](std::uint32_t child) { return this->CopySubtree(child, points, execution); });
}

/** Copies the points below a block that are not in the next subtrees, and passes over these. */
template <int Dim, typename Real>
typename PointTree<Dim, Real>::CellBox PointTree<Dim, Real>::CopyAbove(std::uint32_t block,
  PointSpan<Dim, Real> points, const Execution& execution, const std::vector<Subtree>& subtrees,
  std::size_t& next)
{
  if (next < subtrees.size() && subtrees[next].Block == block)
  {
    return subtrees[next++].Box;
  }
  return this->CopyBlock(block, points, execution,
    [&](std::uint32_t child) { return this->CopyAbove(child, points, execution, subtrees, next); });
}

/** Appends the largest subtrees, in their order, that are small enough for a task. */
template <int Dim, typename Real>
void PointTree<Dim, Real>::ListSubtrees(std::uint32_t block, std::vector<Subtree>& subtrees) const
{
  constexpr unsigned numberOfOctants = Octree<Dim>::NumberOfOctants;
  const auto& children = this->Tree.GetBlock(block);
  const std::size_t count = children.FirstPoint[numberOfOctants] - children.FirstPoint[0];
  if (count <=
    std::max(MostPointsOfTask, numberOfOctants * this->Tree.GetOptions().MaxPointsPerLeaf))
  {
    subtrees.push_back({ block, {} });
    return;
  }
  const unsigned internal = this->Tree.GetOctants(block).Internal;
  for (unsigned rest = internal; rest != 0; rest &= rest - 1)
  {
    this->ListSubtrees(
      this->Tree.GetChildBlock(block, static_cast<unsigned>(__builtin_ctz(rest))), subtrees);
  }
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::CopyPoints(PointSpan<Dim, Real> points, const Execution& execution)
{
  if (!this->Tree.IsRootInternal())
  {
    if (this->GetNumberOfPoints() > 0)
    {
      this->CopyLeaf({ 0, static_cast<PointIndex>(this->GetNumberOfPoints()) }, points, execution);
    }
    return;
  }
  const std::size_t numberOfBlocks = this->Tree.GetNumberOfInternalNodes();
  this->Boxes = Buffer<ChildBoxes<Dim>>(numberOfBlocks);
  this->Forks = Buffer<std::uint32_t>(numberOfBlocks);

  // Leaves in the order of their points in memory, whatever their depths.
  std::vector<Subtree> subtrees;
  this->ListSubtrees(0, subtrees);
  const Execution alone;
  execution.ForEach(subtrees.size(), 1,
    [&](std::size_t i) { subtrees[i].Box = this->CopySubtree(subtrees[i].Block, points, alone); });
  std::size_t next = 0;
  this->CopyAbove(0, points, execution, subtrees, next);
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::BuildNested(PointSpan<Dim, Real> points, const Execution& execution)
{
  if (this->Tree.GetDeepestDepth() < MortonKey<Dim>::MaxDepth)
  {
    return;
  }
  // Blocks are ordered by depth, and what the last of them hold are leaves.
  const std::size_t numberOfBlocks = this->Tree.GetNumberOfInternalNodes();
  const std::size_t firstBlock =
    numberOfBlocks - this->Tree.GetDepthCounts().Leaves.back() / Octree<Dim>::NumberOfOctants;
  for (std::size_t block = firstBlock; block < numberOfBlocks; ++block)
  {
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      const auto leaf = this->Tree.GetChild(block, octant);
      if (leaf.GetNumberOfPoints() > this->MostAtLastDepth)
      {
        const auto before = static_cast<double>(leaf.FirstPoint);
        const auto all = static_cast<double>(this->GetNumberOfPoints());
        this->BuildNestedIn(
          leaf, points, execution.Part(before / all, static_cast<double>(leaf.LastPoint) / all));
      }
    }
  }
}

template <int Dim, typename Real>
void PointTree<Dim, Real>::BuildNestedIn(
  typename Octree<Dim>::Node leaf, PointSpan<Dim, Real> points, const Execution& execution)
{
  const std::size_t count = leaf.GetNumberOfPoints();
  const PointIndex* ids = this->Ids + leaf.FirstPoint;
  const Real* first = points[ids[0]];
  // By their differences in double, as Grid has it: where the processor takes the smallest numbers
  // for zero, it would never part points that differ by less.
  const auto isSame = [](Real a, Real b)
  { return static_cast<double>(a) - static_cast<double>(b) == 0.0; };
  if (std::all_of(ids, ids + count,
        [&](PointIndex id) { return std::equal(first, first + Dim, points[id], isSame); }))
  {
    return;
  }
  // The leaf's ids ascend, so points that the nested tree numbers in this order keep their order.
  Buffer<Real> own(Dim * count);
  execution.Part(0.0, 0.05).ForEach(count, MostPointsOfTask,
    [&](std::size_t i) { std::copy_n(points[ids[i]], Dim, &own[Dim * i]); });
  const PointSpan<Dim, Real> span{ own.GetData(), count };
  const PointSelection<Dim> selection(span, {}, execution.Part(0.05, 0.1));
  this->NestedTrees.push_back({ leaf.FirstPoint,
    PointTree(span, selection, this->Tree.GetOptions(), execution.Part(0.1, 1.0), Buffer<Real>(),
      this->Coordinates + Dim * static_cast<std::size_t>(leaf.FirstPoint)) });
  this->NestedTrees.back().Points.TranslateIds(ids, execution);
}

/** From places in a list of ids to the ids that stand there. */
template <int Dim, typename Real>
void PointTree<Dim, Real>::TranslateIds(const PointIndex* ids, const Execution& execution)
{
  Buffer<PointIndex> translated(this->GetNumberOfPoints());
  execution.Part(1.0, 1.0).ForEach(translated.GetSize(), MostPointsOfTask,
    [&](std::size_t i) { translated[i] = ids[this->Ids[i]]; });
  this->OwnIds = std::move(translated);
  this->Ids = this->OwnIds.GetData();
  for (Nested& nested : this->NestedTrees)
  {
    nested.Points.TranslateIds(ids, execution);
  }
}

template <int Dim, typename Real>
const PointTree<Dim, Real>* PointTree<Dim, Real>::FindNested(PointIndex firstPoint) const
{
  const auto nested = std::lower_bound(this->NestedTrees.begin(), this->NestedTrees.end(),
    firstPoint, [](const Nested& tree, PointIndex first) { return tree.FirstPoint < first; });
  return nested != this->NestedTrees.end() && nested->FirstPoint == firstPoint ? &nested->Points
                                                                               : nullptr;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class PointTree<Dim, float>;                                                            \
  template class PointTree<Dim, double>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
