// SPDX-License-Identifier: BSD-3-Clause
#include "Invariants.h"

#include "ForEachDimension.h"

#include <map>
#include <set>

namespace hashedoctree
{
namespace
{
template <int Dim, typename Real>
class Checker
{
public:
  Checker(
    const Octree<Dim>& tree, PointSpan<Dim, Real> points, const PointSelection<Dim>& selection)
    : Tree(tree)
    , Points(points)
    , Selection(selection)
    , WalkedBlocks(tree.GetNumberOfInternalNodes(), 0)
    , NextCell(tree.GetRoot().NodeKey.GetFirstAtMaxDepth().GetValue())
  {
  }

  std::vector<std::string> Check()
  {
    if (!this->CheckOrder())
    {
      return this->Broken;
    }
    const Node root = this->Tree.GetRoot();
    this->Require(root.FirstPoint == 0 && root.LastPoint == this->Selection.GetNumberOfPoints(),
      "the root's range is all points", root.NodeKey);
    this->Walk(root, 0);
    this->Require(this->NextCell - 1 == root.NodeKey.GetLastAtMaxDepth().GetValue(),
      "the leaves tile the root", root.NodeKey);
    this->CheckTable();
    this->CheckCounts();
    return this->Broken;
  }

private:
  using Key = MortonKey<Dim>;
  using Node = typename Octree<Dim>::Node;

  void Require(bool holds, const char* law, Key where)
  {
    if (!holds && this->Named.insert(law).second)
    {
      this->Broken.push_back(
        std::string(law) + ", broken at key " + std::to_string(where.GetValue()));
    }
  }

  /** Cell of a point at MaxDepth, straight from its position. */
  Key KeyOf(std::size_t place) const
  {
    return this->Tree.GetGrid().GetKey(this->Points[this->Tree.GetPointIds()[place]]);
  }

  /** False when an id names no point: nothing else can be checked then. */
  bool CheckOrder()
  {
    std::vector<char> seen(this->Points.Count, 0);
    for (std::size_t place = 0; place < this->Tree.GetNumberOfPoints(); ++place)
    {
      const PointIndex id = this->Tree.GetPointIds()[place];
      const bool valid = id < this->Points.Count && seen[id] == 0;
      this->Require(valid, "each point stands in the order once", Key::Root());
      if (!valid)
      {
        return id < this->Points.Count;
      }
      seen[id] = 1;
    }
    for (std::size_t id = 0; id < this->Points.Count; ++id)
    {
      this->Require((seen[id] != 0) == this->Selection.Keeps(this->Points[id]),
        "just the selected points take part", Key::Root());
    }
    return true;
  }

  void Walk(const Node& node, std::uint32_t block)
  {
    const auto& options = this->Tree.GetOptions();
    this->Require(node.Internal ==
        (node.GetNumberOfPoints() > options.MaxPointsPerLeaf &&
          node.NodeKey.GetDepth() < options.MaxDepth),
      "a node is internal just when it holds more than MaxPointsPerLeaf points above MaxDepth",
      node.NodeKey);
    if (node.Internal)
    {
      this->WalkChildren(node, block);
    }
    else
    {
      this->CheckLeaf(node);
    }
  }

  void WalkChildren(const Node& node, std::uint32_t block)
  {
    const bool valid = block < this->WalkedBlocks.size() && this->WalkedBlocks[block]++ == 0 &&
      this->Tree.GetBlockKey(block) == node.NodeKey;
    this->Require(valid, "keys and masks agree", node.NodeKey);
    if (!valid)
    {
      return;
    }
    this->Require(block == 0 || this->IsBefore(this->Tree.GetBlockKey(block - 1), node.NodeKey),
      "blocks are ordered by depth, then by key", node.NodeKey);

    PointIndex next = node.FirstPoint;
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      const Node child = this->Tree.GetChild(block, octant);
      this->Require(child.FirstPoint == next && child.LastPoint >= next,
        "ranges partition the points", node.NodeKey);
      next = child.LastPoint;
      this->Walk(child, this->Tree.GetChildBlock(block, octant));
    }
    this->Require(next == node.LastPoint, "ranges partition the points", node.NodeKey);
  }

  static bool IsBefore(Key a, Key b)
  {
    return a.GetDepth() < b.GetDepth() || (a.GetDepth() == b.GetDepth() && a < b);
  }

  void CheckLeaf(const Node& leaf)
  {
    this->Require(leaf.NodeKey.GetFirstAtMaxDepth().GetValue() == this->NextCell,
      "the leaves tile the root", leaf.NodeKey);
    this->NextCell = leaf.NodeKey.GetLastAtMaxDepth().GetValue() + 1;
    // If not, some node's children do not partition its range.
    const bool inside = leaf.LastPoint <= this->Tree.GetNumberOfPoints();
    std::map<std::uint64_t, PointIndex> lastIds; // By key.
    for (std::size_t place = leaf.FirstPoint; inside && place < leaf.LastPoint; ++place)
    {
      const Key key = this->KeyOf(place);
      this->Require(key.AtDepth(leaf.NodeKey.GetDepth()) == leaf.NodeKey,
        "each point lies in the cell of its leaf", leaf.NodeKey);
      const PointIndex id = this->Tree.GetPointIds()[place];
      const auto [last, isFirst] = lastIds.insert({ key.GetValue(), id });
      this->Require(isFirst || last->second < id, "points of equal keys stand by id", key);
      last->second = id;
    }
    const auto depth = static_cast<std::size_t>(leaf.NodeKey.GetDepth());
    this->Leaves[depth] += 1;
    this->EmptyLeaves[depth] += leaf.IsEmpty() ? 1 : 0;
    this->LeafPoints[depth] += leaf.GetNumberOfPoints();
  }

  void CheckTable()
  {
    const auto& table = this->Tree.GetTable();
    this->Require(table.GetNumberOfKeys() == this->Tree.GetNumberOfInternalNodes(),
      "the table holds nothing else", Key::Root());
    for (std::size_t block = 0; block < this->WalkedBlocks.size(); ++block)
    {
      const Key key = this->Tree.GetBlockKey(block);
      this->Require(this->WalkedBlocks[block] == 1, "every block is reached from the root", key);
      const auto* entry = table.Find(key.GetValue());
      this->Require(entry != nullptr && entry->Block == block, "the table finds every node", key);
      unsigned occupied = 0;
      for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
      {
        const Node child = this->Tree.GetChild(block, octant);
        occupied |= (child.IsEmpty() ? 0U : 1U) << octant;
        const auto* below = table.Find(child.NodeKey.GetValue());
        this->Require(
          (below != nullptr) == child.Internal, "the table finds nothing else", child.NodeKey);
      }
      const auto octants = this->Tree.GetOctants(block);
      this->Require(entry != nullptr && entry->Internal == octants.Internal &&
          entry->Occupied == occupied && octants.Occupied == occupied,
        "keys and masks agree", key);
    }
  }

  void CheckCounts()
  {
    const DepthCounts& counts = this->Tree.GetDepthCounts();
    const bool sized = !counts.Leaves.empty() && counts.Leaves.size() <= this->Leaves.size() &&
      counts.EmptyLeaves.size() == counts.Leaves.size() &&
      counts.Points.size() == counts.Leaves.size() && counts.Leaves.back() != 0;
    this->Require(sized, "the counts end at the deepest leaf", Key::Root());
    for (std::size_t depth = 0; sized && depth < this->Leaves.size(); ++depth)
    {
      const bool listed = depth < counts.Leaves.size();
      this->Require(this->Leaves[depth] == (listed ? counts.Leaves[depth] : 0) &&
          this->EmptyLeaves[depth] == (listed ? counts.EmptyLeaves[depth] : 0) &&
          this->LeafPoints[depth] == (listed ? counts.Points[depth] : 0),
        "the counts per depth are those of the leaves", Key::Root());
    }
  }

  const Octree<Dim>& Tree;
  PointSpan<Dim, Real> Points;
  const PointSelection<Dim>& Selection;
  std::vector<char> WalkedBlocks;
  std::uint64_t NextCell; ///< Where the next leaf of the walk must begin.
  std::array<std::uint64_t, Key::MaxDepth + 1> Leaves{};
  std::array<std::uint64_t, Key::MaxDepth + 1> EmptyLeaves{};
  std::array<std::uint64_t, Key::MaxDepth + 1> LeafPoints{};
  std::set<std::string> Named;
  std::vector<std::string> Broken;
};
}

template <int Dim, typename Real>
std::vector<std::string> FindBrokenLaws(
  const Octree<Dim>& tree, PointSpan<Dim, Real> points, const PointSelection<Dim>& selection)
{
  return Checker<Dim, Real>(tree, points, selection).Check();
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template std::vector<std::string> FindBrokenLaws(                                                \
    const Octree<Dim>&, PointSpan<Dim, float>, const PointSelection<Dim>&);                        \
  template std::vector<std::string> FindBrokenLaws(                                                \
    const Octree<Dim>&, PointSpan<Dim, double>, const PointSelection<Dim>&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
