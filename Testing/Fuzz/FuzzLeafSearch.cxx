// SPDX-License-Identifier: BSD-3-Clause
#include "AdjacentSearch.h"
#include "DirectBatch.h"
#include "InRadiusSearch.h"
#include "Invariants.h"

#include "BruteForceNeighbors.h"
#include "LeafSearchInput.h"
#include "TreeOptions.h"

#include <cstdlib>
#include <iostream>

using namespace hashedoctree;

namespace
{
[[noreturn]] void Fail(const std::string& what)
{
  std::cerr << what << std::endl;
  std::abort();
}

/** The three searches of a query, in one reading, against oracles. */
template <int Dim>
class LeafQuestion
{
public:
  LeafQuestion(const Octree<Dim>& tree, const BruteForceNeighbors<Dim>& oracle,
    const LeafQuery<Dim>& query, EmptyOctants reading)
    : Tree(tree)
    , Oracle(oracle)
    , Query(query)
    , Reading(reading)
    , Cell(tree.GetGrid().GetKey(query.X.data()))
    , Leaf(this->GoDown())
    , Node(this->Cell.AtDepth(std::min(query.Depth, this->Leaf.NodeKey.GetDepth())))
  {
  }

  void Ask() const
  {
    this->AskForLeaf();
    this->AskForBatch();
    const double side = this->Tree.GetGrid().GetSide();
    this->AskForNeighbors("adjacent leaves", this->Oracle.FindAdjacent(this->Node, this->Reading),
      [this](int startDepth, Neighbors& found)
      { FindAdjacentLeaves(this->Tree, this->Node, startDepth, found, this->Reading); });
    this->AskForNeighbors("leaves in the radius",
      this->Oracle.FindInRadius(this->Node, this->Query.Radius, side, this->Reading),
      [this](int startDepth, Neighbors& found)
      {
        FindLeavesInRadius(
          this->Tree, this->Node, this->Query.Radius, startDepth, found, this->Reading);
      });
  }

private:
  using Key = MortonKey<Dim>;
  using TreeNode = typename Octree<Dim>::Node;
  using Neighbors = std::vector<Neighbor<Dim>>;

  /** From the root, without the table. */
  TreeNode GoDown() const
  {
    TreeNode node = this->Tree.GetRoot();
    for (std::uint32_t block = 0; node.Internal;)
    {
      const unsigned octant = this->Cell.AtDepth(node.NodeKey.GetDepth() + 1).GetOctant();
      node = this->Tree.GetChild(block, octant);
      block = node.Internal ? this->Tree.GetChildBlock(block, octant) : block;
    }
    return node;
  }

  void AskForLeaf() const
  {
    for (int startDepth = 0; startDepth <= Key::MaxDepth; ++startDepth)
    {
      NodeCount count;
      this->ExpectLeaf(FindLeaf(this->Tree, this->Cell, startDepth, count, this->Reading));
      const int away = std::abs(this->Leaf.NodeKey.GetDepth() - startDepth);
      if (count.Nodes != static_cast<std::uint64_t>(1 + away))
      {
        Fail("direct search: " + std::to_string(count.Nodes) + " nodes from depth " +
          std::to_string(startDepth));
      }
    }
  }

  void AskForBatch() const
  {
    const PointSpan<Dim, double> position{ this->Query.X.data(), 1 };
    FindLeaves(
      this->Tree, position, 0, 1, this->Query.StartDepth,
      [this](std::size_t, const FoundLeaf<Dim>& leaf) { this->ExpectLeaf(leaf); }, this->Reading);
  }

  void ExpectLeaf(const FoundLeaf<Dim>& found) const
  {
    const bool exists = this->Reading == EmptyOctants::Leaves || !this->Leaf.IsEmpty();
    if (found.Key != this->Leaf.NodeKey || found.Exists != exists ||
      !this->IsWellDescribed(found.Key, found.ParentBlock))
    {
      Fail("direct search: " + std::to_string(found.Key.GetValue()) + " instead of " +
        std::to_string(this->Leaf.NodeKey.GetValue()));
    }
  }

  /** The root has no parent. */
  bool IsWellDescribed(Key key, std::uint32_t parentBlock) const
  {
    return key == Key::Root() || this->Tree.GetBlockKey(parentBlock) == key.GetParent();
  }

  /** What search(startDepth, found) finds must be the expected keys, from everywhere in one order.
   */
  template <typename Search>
  void AskForNeighbors(
    const char* what, const std::vector<std::uint64_t>& expected, const Search& search) const
  {
    Neighbors first;
    search(0, first);
    for (const int startDepth : { 0, this->Query.StartDepth, Key::MaxDepth })
    {
      Neighbors found(1);
      search(startDepth, found);
      std::vector<std::uint64_t> keys;
      bool good = found.size() == first.size();
      for (std::size_t i = 0; good && i < found.size(); ++i)
      {
        good =
          found[i].Key == first[i].Key && this->IsWellDescribed(found[i].Key, found[i].ParentBlock);
        keys.push_back(found[i].Key.GetValue());
      }
      std::sort(keys.begin(), keys.end());
      if (!good || keys != expected)
      {
        Fail(std::string(what) + " of " + std::to_string(this->Node.GetValue()) + " from depth " +
          std::to_string(startDepth) + ": " + std::to_string(found.size()) + " instead of " +
          std::to_string(expected.size()) + ", or wrong ones");
      }
    }
  }

  const Octree<Dim>& Tree;
  const BruteForceNeighbors<Dim>& Oracle;
  const LeafQuery<Dim>& Query;
  const EmptyOctants Reading;
  const Key Cell; ///< Of the query's position, at MaxDepth.
  const TreeNode Leaf;
  const Key Node;
};

template <int Dim>
void Run(FuzzBytes& bytes)
{
  const auto options = ReadTreeOptions<Dim>(bytes);
  const LeafSearchInput<Dim> input(bytes);
  Box<Dim> unitCube;
  unitCube.Lower.fill(0.0);
  unitCube.Upper.fill(1.0);
  const PointSelection<Dim> selection(input.GetPoints(), unitCube, Execution());
  const Octree<Dim> tree(input.GetPoints(), selection, options, Execution());
  for (const std::string& law : FindBrokenLaws(tree, input.GetPoints(), selection))
  {
    Fail(law);
  }
  const BruteForceNeighbors<Dim> oracle(tree);
  for (const LeafQuery<Dim>& query : input.GetQueries())
  {
    for (const EmptyOctants reading : { EmptyOctants::Leaves, EmptyOctants::Missing })
    {
      LeafQuestion<Dim>(tree, oracle, query, reading).Ask();
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  switch (bytes.ReadByte() % 4)
  {
    case 0:
      Run<3>(bytes);
      break;
    case 1:
      Run<2>(bytes);
      break;
    case 2:
      Run<1>(bytes);
      break;
    default:
      Run<4>(bytes);
      break;
  }
  return 0;
}
