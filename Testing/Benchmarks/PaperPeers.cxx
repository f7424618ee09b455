// SPDX-License-Identifier: BSD-3-Clause
#include "PaperPeers.h"

#include "AdjacentSearch.h"
#include "InRadiusSearch.h"
#include "Interleaving.h"
#include "StartDepths.h"
#include "TopDownSearch.h"

namespace paper_benchmark
{
namespace
{
using hashedoctree::Grid;

template <typename Tree>
PlacedNode<3, typename Tree::Node> FindFromRoot(const Tree& tree, const hashedoctree::Cell<3>& x)
{
  return tree.FindLeaf(x);
}

template <typename Hash>
PlacedNode<3, typename PaperHashedOctree<3, Hash>::Node> FindFromRoot(
  const PaperHashedOctree<3, Hash>& tree, const hashedoctree::Cell<3>& x)
{
  const auto* node = tree.FindLeaf(hashedoctree::InterleaveCell<3>(x, Key::MaxDepth), 0);
  const Key key(node->Key);
  return { node, key.GetCell(), key.GetDepth() };
}

/** The classical searches from the root down. */
template <typename Tree>
class TopDownSearches
{
public:
  using Placed = PlacedNode<3, typename Tree::Node>;
  using Query = Placed;

  TopDownSearches(const Tree& tree, const Grid<3>& grid)
    : Nodes(tree)
    , RootGrid(grid)
  {
  }

  Query MakeQuery(Key leaf) const
  {
    return FindFromRoot(this->Nodes, leaf.GetFirstAtMaxDepth().GetCell());
  }
  Placed FindLeaf(const float* point) const
  {
    return FindFromRoot(this->Nodes, this->RootGrid.GetCell(point));
  }
  static std::uint64_t GetMark(const Placed& leaf)
  {
    return static_cast<std::uint64_t>(leaf.Depth);
  }
  static Key GetKey(const Placed& leaf) { return leaf.GetKey(); }
  void FindAdjacent(const Query& leaf, std::vector<Placed>& found) const
  {
    FindAdjacentTopDown(this->Nodes, leaf, found);
  }
  void FindInRadius(const Query& leaf, double radius, std::vector<Placed>& found) const
  {
    FindInRadiusTopDown(this->Nodes, this->RootGrid, leaf, radius, found);
  }

private:
  const Tree& Nodes;
  const Grid<3>& RootGrid;
};

/** Algorithms 1 and 2 in the paper's layout. */
template <typename Hash>
class PaperSearches
{
public:
  using Placed = Key;
  using Query = Key;

  PaperSearches(const PaperHashedOctree<3, Hash>& tree, const Grid<3>& grid, int startDepth)
    : Nodes(tree)
    , RootGrid(grid)
    , StartDepth(startDepth)
  {
  }

  static Query MakeQuery(Key leaf) { return leaf; }
  Key FindLeaf(const float* point) const
  {
    return Key(this->Nodes.FindLeaf(this->RootGrid.GetKey(point), this->StartDepth)->Key);
  }
  static std::uint64_t GetMark(Key leaf) { return leaf.GetValue(); }
  static Key GetKey(Key leaf) { return leaf; }
  void FindAdjacent(Key leaf, std::vector<Key>& found) const
  {
    this->Nodes.FindAdjacent(leaf, this->StartDepth, found);
  }
  void FindInRadius(Key leaf, double radius, std::vector<Key>& found) const
  {
    this->Nodes.FindInRadius(leaf, radius, this->StartDepth, found);
  }

private:
  const PaperHashedOctree<3, Hash>& Nodes;
  const Grid<3>& RootGrid;
  int StartDepth;
};

/** Our searches. */
class OurSearches
{
public:
  using Placed = hashedoctree::Neighbor<3>;
  using Query = Key;

  OurSearches(const hashedoctree::Octree<3>& tree, const hashedoctree::StartDepthOptions& options)
    : Nodes(tree)
    , Starts(tree, options)
  {
  }

  static Query MakeQuery(Key leaf) { return leaf; }
  hashedoctree::FoundLeaf<3> FindLeaf(const float* point) const
  {
    const Key key = this->Nodes.GetGrid().GetKey(point);
    return hashedoctree::FindLeaf(this->Nodes, key, this->Starts.Get(key));
  }
  static std::uint64_t GetMark(const hashedoctree::FoundLeaf<3>& leaf)
  {
    return leaf.Key.GetValue();
  }
  template <typename Leaf>
  static Key GetKey(const Leaf& leaf)
  {
    return leaf.Key;
  }
  void FindAdjacent(Key leaf, std::vector<Placed>& found) const
  {
    const int startDepth = this->Starts.Get(leaf.GetFirstAtMaxDepth());
    hashedoctree::FindAdjacentLeaves(this->Nodes, leaf, startDepth, found);
  }
  void FindInRadius(Key leaf, double radius, std::vector<Placed>& found) const
  {
    const int startDepth = this->Starts.Get(leaf.GetFirstAtMaxDepth());
    hashedoctree::FindLeavesInRadius(this->Nodes, leaf, radius, startDepth, found);
  }

private:
  const hashedoctree::Octree<3>& Nodes;
  hashedoctree::StartDepths<3> Starts;
};

/** Asks one kind of searches. */
template <typename Searches>
class PeerOf : public PaperPeer
{
public:
  explicit PeerOf(Searches searches)
    : Single(std::move(searches))
  {
  }

  std::uint64_t FindLeaves(const std::vector<float>& points) override
  {
    std::uint64_t marks = 0;
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
      marks += this->Single.GetMark(this->Single.FindLeaf(&points[i]));
    }
    return marks;
  }
  void SetLeaves(const std::vector<Key>& leaves) override
  {
    this->Queries.clear();
    for (const Key leaf : leaves)
    {
      this->Queries.push_back(this->Single.MakeQuery(leaf));
    }
  }
  std::uint64_t FindAdjacent() override
  {
    std::uint64_t count = 0;
    for (const auto& query : this->Queries)
    {
      this->Single.FindAdjacent(query, this->Found);
      count += this->Found.size();
    }
    return count;
  }
  std::uint64_t FindInRadius(double radius) override
  {
    std::uint64_t count = 0;
    for (const auto& query : this->Queries)
    {
      this->Single.FindInRadius(query, radius, this->Found);
      count += this->Found.size();
    }
    return count;
  }

  std::uint64_t GetLeaf(const float* point) override
  {
    return this->Single.GetKey(this->Single.FindLeaf(point)).GetValue();
  }
  Keys GetAdjacent(std::size_t leaf) override
  {
    this->Single.FindAdjacent(this->Queries[leaf], this->Found);
    return this->GetSortedKeys();
  }
  Keys GetInRadius(std::size_t leaf, double radius) override
  {
    this->Single.FindInRadius(this->Queries[leaf], radius, this->Found);
    return this->GetSortedKeys();
  }

private:
  Keys GetSortedKeys() const
  {
    Keys keys;
    for (const auto& leaf : this->Found)
    {
      keys.push_back(this->Single.GetKey(leaf).GetValue());
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  Searches Single;
  std::vector<typename Searches::Query> Queries;
  std::vector<typename Searches::Placed> Found;
};

template <typename Searches>
std::unique_ptr<PaperPeer> MakePeer(Searches searches)
{
  return std::make_unique<PeerOf<Searches>>(std::move(searches));
}
}

const std::vector<std::string>& GetPeerNames()
{
  static const std::vector<std::string> names{ "8 pointers", "brother/child",
    "brother/child, parents", "paper, root", "paper, start depth", "paper, mixing hash",
    "ours, root", "ours, median", "ours, local" };
  return names;
}

PaperPeers MakePeers(const PaperTrees& trees, int startDepth)
{
  using hashedoctree::StartDepthModel;
  using hashedoctree::StartDepthOptions;
  const Grid<3>& grid = trees.Ours.GetGrid();
  PaperPeers peers;
  peers.push_back(MakePeer(TopDownSearches(*trees.Pointers, grid)));
  peers.push_back(MakePeer(TopDownSearches(*trees.BrotherChild, grid)));
  peers.push_back(MakePeer(TopDownSearches(*trees.WithParents, grid)));
  peers.push_back(MakePeer(TopDownSearches(*trees.Paper, grid)));
  peers.push_back(MakePeer(PaperSearches(*trees.Paper, grid, startDepth)));
  peers.push_back(MakePeer(PaperSearches(*trees.PaperMixing, grid, startDepth)));
  StartDepthOptions options;
  options.Model = StartDepthModel::Root;
  peers.push_back(MakePeer(OurSearches(trees.Ours, options)));
  options.Model = StartDepthModel::Fixed;
  options.Fixed = startDepth;
  peers.push_back(MakePeer(OurSearches(trees.Ours, options)));
  options.Model = StartDepthModel::Local;
  peers.push_back(MakePeer(OurSearches(trees.Ours, options)));
  return peers;
}
}
