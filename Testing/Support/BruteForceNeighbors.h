// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_BruteForceNeighbors_h
#define Testing_Support_BruteForceNeighbors_h

#include "ForEachNode.h"
#include "NodeBox.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

/** The oracle for neighbour searches: looks at every node, with integers. */
template <int Dim>
class BruteForceNeighbors
{
public:
  using Key = hashedoctree::MortonKey<Dim>;
  using Keys = std::vector<std::uint64_t>; ///< Sorted.

  explicit BruteForceNeighbors(const hashedoctree::Octree<Dim>& tree)
  {
    ForEachNode(tree, [this](const auto& node) { this->Nodes.push_back(Listed(node)); });
  }

  /** The leaves that touch a node and do not lie in it. */
  Keys FindAdjacent(Key node, hashedoctree::EmptyOctants reading) const
  {
    const NodeBox<Dim> box(node);
    return this->FindLeaves(reading,
      [&box](const NodeBox<Dim>& leaf) { return leaf.Touches(box) && !box.Contains(leaf); });
  }

  /** The leaves that meet a ball around the center of a node and do not lie in it, by the
   * definition in NodeBall.h. `side` is that of the root. */
  Keys FindInRadius(Key node, double radius, double side, hashedoctree::EmptyOctants reading) const
  {
    const NodeBox<Dim> box(node);
    const double radius2 = GetRadius2(radius, side);
    return this->FindLeaves(reading,
      [&box, radius, radius2](const NodeBox<Dim>& leaf)
      { return radius >= 0.0 && !box.Contains(leaf) && GetDist2(box, leaf) <= radius2; });
  }

  /** How many nodes, leaves or not, touch a node from outside and are not larger. */
  std::uint64_t CountAdjacentNodes(Key node) const
  {
    const NodeBox<Dim> box(node);
    return static_cast<std::uint64_t>(std::count_if(this->Nodes.begin(), this->Nodes.end(),
      [&box](const Listed& other) {
        return other.Box.Depth >= box.Depth && other.Box.Touches(box) && !box.Contains(other.Box);
      }));
  }

private:
  struct Listed
  {
    std::uint64_t Key;
    NodeBox<Dim> Box;
    bool Internal;
    bool IsEmpty;

    explicit Listed(const typename hashedoctree::Octree<Dim>::Node& node)
      : Key(node.NodeKey.GetValue())
      , Box(node.NodeKey)
      , Internal(node.Internal)
      , IsEmpty(node.IsEmpty())
    {
    }
  };

  /** Squared distance from the center of a node to a box, in half cells of MaxDepth. */
  static double GetDist2(const NodeBox<Dim>& node, const NodeBox<Dim>& box)
  {
    double dist2 = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const std::int64_t center = node.Lower[axis] + node.Upper[axis];
      const std::int64_t nearest = std::clamp(center, 2 * box.Lower[axis], 2 * box.Upper[axis]);
      const auto distance = static_cast<double>(center - nearest);
      dist2 += distance * distance;
    }
    return dist2;
  }
  static double GetRadius2(double radius, double side)
  {
    const double inHalfCells = radius / side * std::pow(2.0, Key::MaxDepth + 1);
    return inHalfCells * inHalfCells;
  }

  template <typename Predicate>
  Keys FindLeaves(hashedoctree::EmptyOctants reading, const Predicate& isFound) const
  {
    Keys found;
    for (const Listed& node : this->Nodes)
    {
      const bool isLeaf =
        !node.Internal && (reading == hashedoctree::EmptyOctants::Leaves || !node.IsEmpty);
      if (isLeaf && isFound(node.Box))
      {
        found.push_back(node.Key);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  std::vector<Listed> Nodes;
};

#endif
