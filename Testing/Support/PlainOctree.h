// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_PlainOctree_h
#define Testing_Support_PlainOctree_h

#include "Grid.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

/**
 * The oracle for octrees: a recursive splitter that knows nothing of Morton keys, tables or
 * sorting. A node is named by its depth and the place of its cell in the grid of that depth.
 */
template <int Dim>
class PlainOctree
{
public:
  static constexpr int GridDepth = hashedoctree::MortonKey<Dim>::MaxDepth;

  struct Name
  {
    int Depth;
    hashedoctree::Cell<Dim> Cell;
    bool operator<(const Name& other) const
    {
      return this->Depth != other.Depth ? this->Depth < other.Depth : this->Cell < other.Cell;
    }
  };
  struct Node
  {
    bool Internal;
    std::vector<std::uint32_t> Ids; ///< In the order of the data set.
  };

  /** Nodes of the octree over the points at the given places, which index into `coordinates`. */
  template <typename Real>
  PlainOctree(const Real* coordinates, const std::vector<std::uint32_t>& ids,
    std::size_t maxPointsPerLeaf, int maxDepth)
    : MaxPointsPerLeaf(maxPointsPerLeaf)
    , MaxDepth(maxDepth)
  {
    double lower[Dim];
    double side = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      double upper = -INFINITY;
      lower[axis] = INFINITY;
      for (const std::uint32_t id : ids)
      {
        const double x = coordinates[Dim * id + axis];
        lower[axis] = std::fmin(lower[axis], x);
        upper = std::fmax(upper, x);
      }
      side = std::fmax(side, upper - lower[axis]);
    }
    side = side > 0.0 ? side : 1.0;
    for (const std::uint32_t id : ids)
    {
      hashedoctree::Cell<Dim>& cell = this->Cells[id];
      for (int axis = 0; axis < Dim; ++axis)
      {
        const double x = coordinates[Dim * id + axis];
        const double size = std::ldexp(1.0, GridDepth);
        const double place = std::floor((x - lower[axis]) / side * size);
        cell[axis] = static_cast<std::uint32_t>(std::fmin(place, size - 1.0));
      }
    }
    this->Split({ 0, {} }, ids);
  }

  const std::map<Name, Node>& GetNodes() const { return this->Nodes; }

private:
  void Split(const Name& name, const std::vector<std::uint32_t>& ids)
  {
    const bool internal = ids.size() > this->MaxPointsPerLeaf && name.Depth < this->MaxDepth;
    this->Nodes[name] = { internal, ids };
    for (unsigned child = 0; internal && child < (1U << Dim); ++child)
    {
      Name below{ name.Depth + 1, {} };
      for (int axis = 0; axis < Dim; ++axis)
      {
        below.Cell[axis] = 2 * name.Cell[axis] + (child >> axis & 1U);
      }
      std::vector<std::uint32_t> inside;
      for (const std::uint32_t id : ids)
      {
        bool isInside = true;
        for (int axis = 0; axis < Dim; ++axis)
        {
          isInside =
            isInside && this->Cells[id][axis] >> (GridDepth - below.Depth) == below.Cell[axis];
        }
        if (isInside)
        {
          inside.push_back(id);
        }
      }
      this->Split(below, inside);
    }
  }

  std::size_t MaxPointsPerLeaf;
  int MaxDepth;
  std::map<std::uint32_t, hashedoctree::Cell<Dim>> Cells;
  std::map<Name, Node> Nodes;
};

#endif
