// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_OracleOctree_h
#define Testing_Cxx_OracleOctree_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/**
 * What the filter must say of a few points: an octree by splitting lists of points again and again,
 * and means by adding up over its leaves. Slow, plain, and it knows nothing of Filters/Core.
 */
class OracleOctree
{
public:
  static constexpr int GridDepth = 21;

  using Place = std::array<std::int64_t, 3>;

  struct Node
  {
    int Depth;
    std::uint64_t Key;
    Place Lower;       ///< Lower corner, in cells of GridDepth.
    std::int64_t Side; ///< In cells of GridDepth.
    std::vector<std::size_t> Points;
    bool Internal;
  };

  /** How often a leaf is searched for. */
  using Weight = std::int64_t (*)(const OracleOctree&, const Node&);
  static std::int64_t Leaves(const OracleOctree&, const Node&) { return 1; }
  static std::int64_t Points(const OracleOctree&, const Node& leaf)
  {
    return static_cast<std::int64_t>(leaf.Points.size());
  }
  static std::int64_t Grid(const OracleOctree& tree, const Node& leaf)
  {
    return std::int64_t(1) << (3 * (tree.GetDeepestDepth() - leaf.Depth));
  }

  /** Of points with finite coordinates, three for each; the root is the cube around them. */
  OracleOctree(const std::vector<double>& coordinates, std::size_t maxPointsPerLeaf = 1,
    int maxDepth = GridDepth)
    : OracleOctree(coordinates, GetBounds(coordinates), maxPointsPerLeaf, maxDepth)
  {
  }
  /** Of those of the points that lie in given bounds (xmin, xmax, ymin, ...). */
  OracleOctree(const std::vector<double>& coordinates, const std::array<double, 6>& bounds,
    std::size_t maxPointsPerLeaf = 1, int maxDepth = GridDepth)
    : MaxPointsPerLeaf(maxPointsPerLeaf)
    , MaxDepth(maxDepth)
    , Origin{ bounds[0], bounds[2], bounds[4] }
    , RootSide(std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }))
  {
    if (this->RootSide == 0.0)
    {
      this->RootSide = 1.0;
    }
    Node root{ 0, 1, { 0, 0, 0 }, std::int64_t(1) << GridDepth, {}, false };
    for (std::size_t point = 0; point < coordinates.size() / 3; ++point)
    {
      const double* x = coordinates.data() + 3 * point;
      this->Places.push_back(
        { this->FindPlace(x, 0), this->FindPlace(x, 1), this->FindPlace(x, 2) });
      if (x[0] >= bounds[0] && x[0] <= bounds[1] && x[1] >= bounds[2] && x[1] <= bounds[3] &&
        x[2] >= bounds[4] && x[2] <= bounds[5])
      {
        root.Points.push_back(point);
      }
    }
    this->Split(std::move(root));
    std::sort(this->Nodes.begin(), this->Nodes.end(),
      [](const Node& a, const Node& b)
      { return a.Depth != b.Depth ? a.Depth < b.Depth : a.Key < b.Key; });
  }

  /** All nodes, ordered by depth, then by key. */
  const std::vector<Node>& GetNodes() const { return this->Nodes; }
  double GetRootSide() const { return this->RootSide; }
  int GetDeepestDepth() const { return this->Nodes.back().Depth; }

  /** World position of a corner on one axis. */
  double GetPosition(const Place& corner, std::size_t axis) const
  {
    return this->Origin[axis] +
      this->RootSide * std::ldexp(static_cast<double>(corner[axis]), -GridDepth);
  }

  /** Sum of value(leaf) over the leaves. */
  template <typename Value>
  std::int64_t Sum(const Value& value) const
  {
    std::int64_t sum = 0;
    for (const Node& node : this->Nodes)
    {
      sum += node.Internal ? 0 : value(node);
    }
    return sum;
  }

  /** Weighted means over the leaves: of the nodes on the way from the start depth, and of the
   * depth. */
  long double GetMeanCost(Weight weight, int startDepth) const
  {
    return this->GetMean(
      weight, [startDepth](const Node& leaf) { return 1 + std::abs(leaf.Depth - startDepth); });
  }
  long double GetMeanDepth(Weight weight) const
  {
    return this->GetMean(weight, [](const Node& leaf) { return leaf.Depth; });
  }

  /** The start depth that costs the least, the smallest of equals; found by trying all. */
  int GetBestStartDepth(Weight weight) const
  {
    int cheapest = 0;
    for (int depth = 1; depth <= this->GetDeepestDepth(); ++depth)
    {
      if (this->GetMeanCost(weight, depth) < this->GetMeanCost(weight, cheapest))
      {
        cheapest = depth;
      }
    }
    return cheapest;
  }

private:
  static std::array<double, 6> GetBounds(const std::vector<double>& coordinates)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 6> bounds{ infinity, -infinity, infinity, -infinity, infinity, -infinity };
    for (std::size_t i = 0; i < coordinates.size(); ++i)
    {
      double* ofAxis = bounds.data() + 2 * (i % 3);
      ofAxis[0] = std::min(ofAxis[0], coordinates[i]);
      ofAxis[1] = std::max(ofAxis[1], coordinates[i]);
    }
    return bounds;
  }

  std::int64_t FindPlace(const double* x, std::size_t axis) const
  {
    const double size = std::ldexp(1.0, GridDepth);
    const double place = std::floor((x[axis] - this->Origin[axis]) / this->RootSide * size);
    return static_cast<std::int64_t>(std::clamp(place, 0.0, size - 1.0));
  }

  bool Holds(const Node& node, const Place& place) const
  {
    return std::equal(place.begin(), place.end(), node.Lower.begin(),
      [&node](std::int64_t x, std::int64_t lower) { return x >= lower && x < lower + node.Side; });
  }

  void Split(Node node)
  {
    node.Internal = node.Points.size() > this->MaxPointsPerLeaf && node.Depth < this->MaxDepth;
    for (unsigned octant = 0; node.Internal && octant < 8; ++octant)
    {
      Node child{ node.Depth + 1, 8 * node.Key + octant, node.Lower, node.Side / 2, {}, false };
      child.Lower[0] += (octant & 4U) != 0 ? child.Side : 0;
      child.Lower[1] += (octant & 2U) != 0 ? child.Side : 0;
      child.Lower[2] += (octant & 1U) != 0 ? child.Side : 0;
      std::copy_if(node.Points.begin(), node.Points.end(), std::back_inserter(child.Points),
        [this, &child](std::size_t point) { return this->Holds(child, this->Places[point]); });
      this->Split(std::move(child));
    }
    this->Nodes.push_back(std::move(node));
  }

  template <typename Value>
  long double GetMean(Weight weight, const Value& value) const
  {
    long double sum = 0.0L;
    long double total = 0.0L;
    for (const Node& node : this->Nodes)
    {
      if (!node.Internal)
      {
        const auto times = static_cast<long double>(weight(*this, node));
        sum += times * static_cast<long double>(value(node));
        total += times;
      }
    }
    return sum / total;
  }

  std::size_t MaxPointsPerLeaf;
  int MaxDepth;
  std::array<double, 3> Origin;
  double RootSide;
  std::vector<Place> Places; ///< Cell of GridDepth of each point.
  std::vector<Node> Nodes;
};

#endif
