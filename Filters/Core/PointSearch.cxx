// SPDX-License-Identifier: BSD-3-Clause
#include "PointSearch.h"

#include "DirectSearch.h"

#include <algorithm>

namespace hashedoctree
{
namespace
{
/** The closest point so far. */
class ClosestOne
{
public:
  explicit ClosestOne(double radius2)
    : Best{ radius2, None }
  {
  }
  /** Points farther than this are of no use. */
  double GetBound2() const { return this->Best.Dist2; }
  void Add(double dist2, std::uint32_t id)
  {
    if (FoundPoint{ dist2, id } < this->Best)
    {
      this->Best = { dist2, id };
    }
  }
  bool HasFound() const { return this->Best.Id != None; }
  const FoundPoint& GetBest() const { return this->Best; }

private:
  static constexpr std::uint32_t None = ~std::uint32_t(0);
  FoundPoint Best;
};

/** The closest few so far: in order while they are few indeed, else as a heap with the farthest on
 * top. */
class ClosestFew
{
public:
  ClosestFew(std::size_t wanted, std::vector<FoundPoint>& found)
    : Wanted(wanted)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Bound2; }
  void Add(double dist2, std::uint32_t id)
  {
    const FoundPoint point{ dist2, id };
    if (this->Wanted > MostInOrder)
    {
      this->AddToHeap(point);
    }
    else
    {
      this->AddInOrder(point);
    }
  }
  void PutInOrder()
  {
    if (this->Wanted > MostInOrder)
    {
      std::sort_heap(this->Found.begin(), this->Found.end());
    }
  }

private:
  static constexpr std::size_t MostInOrder = 64; ///< Up to here insertion beats a heap.

  void AddInOrder(const FoundPoint& point)
  {
    if (this->Found.size() < this->Wanted)
    {
      this->Found.push_back(point);
    }
    else if (!(point < this->Found.back()))
    {
      return;
    }
    auto place = this->Found.end() - 1;
    for (; place != this->Found.begin() && point < *(place - 1); --place)
    {
      *place = *(place - 1);
    }
    *place = point;
    if (this->Found.size() == this->Wanted)
    {
      this->Bound2 = this->Found.back().Dist2;
    }
  }

  void AddToHeap(const FoundPoint& point)
  {
    if (this->Found.size() == this->Wanted)
    {
      if (!(point < this->Found.front()))
      {
        return;
      }
      std::pop_heap(this->Found.begin(), this->Found.end());
      this->Found.pop_back();
    }
    this->Found.push_back(point);
    std::push_heap(this->Found.begin(), this->Found.end());
    if (this->Found.size() == this->Wanted)
    {
      this->Bound2 = this->Found.front().Dist2;
    }
  }

  std::size_t Wanted;
  double Bound2 = std::numeric_limits<double>::infinity();
  std::vector<FoundPoint>& Found;
};

/** One search, with the position in units of cells of MaxDepth. */
template <int Dim, typename Real, typename Collector>
class Walk
{
public:
  Walk(const PointTree<Dim, Real>& tree, const Position<Dim>& x, Collector& collector)
    : Tree(tree)
    , Nodes(tree.GetOctree())
    , X(x)
    , Points(collector)
    , CellSize(this->Nodes.GetGrid().GetSide(Key::MaxDepth))
  {
    for (int axis = 0; axis < Dim; ++axis)
    {
      this->Place[axis] = (x[axis] - this->Nodes.GetGrid().GetLower()[axis]) / this->CellSize;
    }
  }

  /** All points that may be within the collector's bound, from the leaf of the position outwards,
   * beginning with a node that holds at least `wanted` points. */
  void Outwards(std::size_t wanted, int startDepth)
  {
    if (!this->Nodes.IsRootInternal())
    {
      this->ScanLeaf(0, static_cast<std::uint32_t>(this->Nodes.GetNumberOfPoints()));
      return;
    }
    const Key key = this->Nodes.GetGrid().GetKey(this->X.data());
    const FoundLeaf<Dim> leaf = FindLeaf(this->Nodes, key, startDepth);
    const auto& parent = this->Nodes.GetBlock(leaf.ParentBlock);
    const unsigned octant = leaf.Key.GetOctant();
    const std::uint32_t first = parent.FirstPoint[octant];
    const std::uint32_t last = parent.FirstPoint[octant + 1];
    if (last - first >= wanted)
    {
      this->ScanLeaf(first, last);
      if (this->HoldsBall(leaf.Key))
      {
        return;
      }
      this->ScannedPoint = first;
    }

    std::uint32_t block = leaf.ParentBlock;
    Key blockKey = leaf.Key.GetParent();
    while (blockKey != Key::Root() && CountPoints(this->Nodes.GetBlock(block)) < wanted)
    {
      blockKey = blockKey.GetParent();
      block = this->Nodes.GetTable().Find(blockKey.GetValue())->Block;
    }
    this->SearchBlock(block, blockKey);
    if (blockKey == Key::Root() || this->HoldsBall(blockKey))
    {
      return;
    }
    this->Searched = blockKey;
    this->Cover();
  }

  /** All points within the collector's bound: its cover of cells, at once. */
  void Cover()
  {
    if (!this->Nodes.IsRootInternal())
    {
      this->ScanLeaf(0, static_cast<std::uint32_t>(this->Nodes.GetNumberOfPoints()));
      return;
    }
    const double reach = this->GetReach();
    const int depth = GetCoverDepth(reach);
    if (depth == 0)
    {
      this->SearchBlock(0, Key::Root());
      return;
    }
    const double width = GetWidth(depth);
    const double last = static_cast<double>((std::uint64_t(1) << depth) - 1);
    Cell<Dim> lower;
    Cell<Dim> upper;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const double from = (this->Place[axis] - reach) / width;
      const double to = (this->Place[axis] + reach) / width;
      if (from >= last + 1.0 || to < 0.0)
      {
        // Beside the root; only rounding may bring its points into the ball.
        this->SearchBlock(0, Key::Root());
        return;
      }
      lower[axis] = static_cast<std::uint32_t>(std::max(from, 0.0));
      upper[axis] = static_cast<std::uint32_t>(std::min(to, last));
    }
    Cell<Dim> cell;
    this->SearchCells(cell, lower, upper, depth, 0);
  }

private:
  using Key = MortonKey<Dim>;
  using Block = typename Octree<Dim>::Block;
  static constexpr std::uint32_t Nothing = ~std::uint32_t(0);
  static constexpr unsigned NumberOfOctants = Octree<Dim>::NumberOfOctants;

  static std::size_t CountPoints(const Block& block)
  {
    return block.FirstPoint[NumberOfOctants] - block.FirstPoint[0];
  }

  /** Radius of the collector's ball in cells of MaxDepth, with room for rounding. */
  double GetReach() const
  {
    const double reach = std::sqrt(this->Points.GetBound2()) / this->CellSize;
    double farthest = 0.0;
    for (const double place : this->Place)
    {
      farthest = std::max(farthest, std::abs(place));
    }
    return reach + 1e-9 + 1e-12 * (reach + farthest);
  }

  /** The deepest depth whose cells are at least as wide as a ball. */
  static int GetCoverDepth(double reach)
  {
    int exponent = 0;
    std::frexp(2.0 * reach, &exponent); // 2 * reach < 2^exponent
    return std::isfinite(reach)
      ? std::clamp(Key::MaxDepth - std::max(exponent, 0), 0, Key::MaxDepth)
      : 0;
  }

  bool HoldsBall(Key key) const
  {
    const double reach = this->GetReach();
    const double width = GetWidth(key.GetDepth());
    const Cell<Dim> cell = key.GetCell();
    bool holds = true;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const double lower = width * cell[axis];
      holds =
        holds && this->Place[axis] - reach >= lower && this->Place[axis] + reach < lower + width;
    }
    return holds;
  }

  /** Searches the cells of a depth between two corners, axis after axis. */
  void SearchCells(
    Cell<Dim>& cell, const Cell<Dim>& lower, const Cell<Dim>& upper, int depth, int axis)
  {
    if (axis == Dim)
    {
      this->SearchCell(cell, lower, depth);
      return;
    }
    for (cell[axis] = lower[axis]; cell[axis] <= upper[axis]; ++cell[axis])
    {
      this->SearchCells(cell, lower, upper, depth, axis + 1);
    }
  }

  /** The node of a cell, or the leaf above it; a leaf only for the first of its cells. */
  void SearchCell(const Cell<Dim>& cell, const Cell<Dim>& lower, int depth)
  {
    const Key key = Key::FromCell(cell, depth);
    if (this->IsSearched(key, depth))
    {
      return;
    }
    if (const auto* entry = this->Nodes.GetTable().Find(key.GetValue()))
    {
      this->SearchBlock(entry->Block, key);
      return;
    }
    Key leaf = key;
    const typename Octree<Dim>::Entry* parent = nullptr;
    while ((parent = this->Nodes.GetTable().Find(leaf.GetParent().GetValue())) == nullptr)
    {
      leaf = leaf.GetParent();
    }
    const int levels = depth - leaf.GetDepth();
    const Cell<Dim> leafCell = leaf.GetCell();
    for (int axis = 0; axis < Dim; ++axis)
    {
      if (cell[axis] != std::max(lower[axis], leafCell[axis] << levels))
      {
        return;
      }
    }
    const Block& block = this->Nodes.GetBlock(parent->Block);
    this->ScanLeaf(block.FirstPoint[leaf.GetOctant()], block.FirstPoint[leaf.GetOctant() + 1]);
  }

  /** Whether a node lies in the one that has been searched. */
  bool IsSearched(Key key, int depth) const
  {
    return this->Searched != Key() && depth >= this->Searched.GetDepth() &&
      Key(key.GetValue() >> (Dim * (depth - this->Searched.GetDepth()))) == this->Searched;
  }

  /** A block on the way down, and where the position lies in its cell. */
  struct Visit
  {
    std::uint32_t Block;
    MortonKey<Dim> NodeKey;
    Position<Dim> Steps; ///< From the cell's lower corner, in steps of its boxes.
    double StepSize2;    ///< Squared side of a step, in world units.
  };

  void SearchBlock(std::uint32_t block, Key key)
  {
    Visit visit;
    visit.Block = block;
    visit.NodeKey = key;
    const Cell<Dim> cell = key.GetCell();
    const double width = GetWidth(key.GetDepth());
    const double step = width / ChildBoxes<Dim>::Steps;
    for (int axis = 0; axis < Dim; ++axis)
    {
      visit.Steps[axis] = (this->Place[axis] - width * cell[axis]) / step;
    }
    const double stepSize = step * this->CellSize;
    visit.StepSize2 = stepSize * stepSize;
    this->Descend(visit);
  }

  static Visit GoDown(const Visit& visit, const Block& block, unsigned octant)
  {
    Visit child;
    child.Block = Octree<Dim>::GetChildBlock(block, octant);
    child.NodeKey = visit.NodeKey.GetChild(octant);
    for (int axis = 0; axis < Dim; ++axis)
    {
      const bool upper = (octant >> (Dim - 1 - axis) & 1U) != 0;
      child.Steps[axis] = 2.0 * visit.Steps[axis] - (upper ? ChildBoxes<Dim>::Steps : 0);
    }
    child.StepSize2 = 0.25 * visit.StepSize2;
    return child;
  }

  void Descend(const Visit& visit)
  {
    if (visit.NodeKey == this->Searched)
    {
      return;
    }
    const Block& block = this->Nodes.GetBlock(visit.Block);
    float dist2[NumberOfOctants];
    this->Kernels.ToBoxes(this->Tree.GetChildBoxes(visit.Block), visit.Steps.data(), dist2);
    const double scale = visit.StepSize2 * (1.0 - DistanceKernels<Dim, Real>::BoxError);
    const auto limit = static_cast<float>(
      this->Points.GetBound2() / scale * (1.0 + DistanceKernels<Dim, Real>::BoxError));
    unsigned left = 0;
    for (unsigned octant = 0; octant < NumberOfOctants; ++octant)
    {
      // Not "<=": where distances overflow, the limit is no number, and nothing may be left out.
      left |= (dist2[octant] > limit ? 0U : 1U) << octant;
    }
    left &= block.Occupied;
    while (left != 0)
    {
      auto nearest = static_cast<unsigned>(__builtin_ctz(left));
      for (unsigned others = left & (left - 1); others != 0; others &= others - 1)
      {
        const auto octant = static_cast<unsigned>(__builtin_ctz(others));
        nearest = dist2[octant] < dist2[nearest] ? octant : nearest;
      }
      if (static_cast<double>(dist2[nearest]) * scale > this->Points.GetBound2())
      {
        return;
      }
      left &= ~(1U << nearest);
      if ((block.Internal >> nearest & 1U) != 0)
      {
        this->Descend(GoDown(visit, block, nearest));
      }
      else
      {
        this->ScanLeaf(block.FirstPoint[nearest], block.FirstPoint[nearest + 1]);
      }
    }
  }

  void ScanLeaf(std::uint32_t first, std::uint32_t last)
  {
    if (first == this->ScannedPoint)
    {
      return;
    }
    const std::size_t size = last - first;
    double dist2[LeafBlock];
    if (size <= LeafBlock)
    {
      this->Kernels.ToPoints(this->Tree.GetLeafCoordinates(first), size, this->X.data(), dist2);
      this->Collect(dist2, this->Tree.GetIds() + first, size);
    }
    else
    {
      std::vector<double> many(size);
      this->Kernels.ToPoints(
        this->Tree.GetLeafCoordinates(first), size, this->X.data(), many.data());
      this->Collect(many.data(), this->Tree.GetIds() + first, size);
    }
  }
  static constexpr std::size_t LeafBlock = 64; ///< Leaves up to this size need no memory.

  void Collect(const double* dist2, const std::uint32_t* ids, std::size_t size)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      if (dist2[i] <= this->Points.GetBound2())
      {
        this->Points.Add(dist2[i], ids[i]);
      }
    }
  }

  /** Width of the cells of a depth, in cells of MaxDepth. */
  static double GetWidth(int depth)
  {
    return static_cast<double>(std::uint64_t(1) << (Key::MaxDepth - depth));
  }

  const PointTree<Dim, Real>& Tree;
  const DistanceKernels<Dim, Real>& Kernels = GetDistanceKernels<Dim, Real>();
  const Octree<Dim>& Nodes;
  const Position<Dim>& X;
  Collector& Points;
  double CellSize;
  Position<Dim> Place;                  ///< In cells of MaxDepth from the lower corner of the root.
  Key Searched = Key();                 ///< All of this node has been searched.
  std::uint32_t ScannedPoint = Nothing; ///< The range that begins there has been scanned.
};

template <int Dim>
bool IsFinite(const Position<Dim>& x)
{
  return std::all_of(
    x.begin(), x.end(), [](double coordinate) { return std::isfinite(coordinate); });
}

/** Takes all that is within a fixed radius. */
class AllWithin
{
public:
  AllWithin(double radius2, std::vector<std::uint32_t>& found)
    : Radius2(radius2)
    , Found(found)
  {
  }
  double GetBound2() const { return this->Radius2; }
  void Add(double, std::uint32_t id) { this->Found.push_back(id); }

private:
  double Radius2;
  std::vector<std::uint32_t>& Found;
};
}

template <int Dim, typename Real>
bool PointSearch<Dim, Real>::FindClosest(
  const Position<Dim>& x, FoundPoint& found, double radius2) const
{
  if (!IsFinite<Dim>(x) || !(radius2 >= 0.0) || this->Tree.GetNumberOfPoints() == 0)
  {
    return false;
  }
  ClosestOne closest(radius2);
  Walk<Dim, Real, ClosestOne>(this->Tree, x, closest).Outwards(1, this->StartDepth);
  if (closest.HasFound())
  {
    found = closest.GetBest();
  }
  return closest.HasFound();
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindClosest(
  const Position<Dim>& x, std::size_t count, std::vector<FoundPoint>& found) const
{
  found.clear();
  if (!IsFinite<Dim>(x) || count == 0 || this->Tree.GetNumberOfPoints() == 0)
  {
    return;
  }
  ClosestFew closest(count, found);
  Walk<Dim, Real, ClosestFew>(this->Tree, x, closest).Outwards(count, this->StartDepth);
  closest.PutInOrder();
}

template <int Dim, typename Real>
void PointSearch<Dim, Real>::FindWithin(
  const Position<Dim>& x, double radius, std::vector<std::uint32_t>& found) const
{
  found.clear();
  if (!IsFinite<Dim>(x) || !(radius >= 0.0) || this->Tree.GetNumberOfPoints() == 0)
  {
    return;
  }
  AllWithin within(radius * radius, found);
  Walk<Dim, Real, AllWithin>(this->Tree, x, within).Cover();
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class PointSearch<Dim, float>;                                                          \
  template class PointSearch<Dim, double>;
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
