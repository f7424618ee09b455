// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointsOctree_h
#define PointsOctree_h

#include "CurveDivision.h"
#include "Octree.h"
#include "ProcessGroup.h"
#include "TreeFrame.h"
#include "TreePart.h"

#include <map>
#include <variant>
#include <vector>

namespace hashedoctree
{
/**
 * The octree or quadtree over the points of one data set, and what became of the points that are
 * not in it. Of a data set whose pieces several processes have, each of them has a part of the tree
 * (see CurveDivision): Tree is the one of all in Range only, and all numbers are of the whole.
 * Private to the module.
 */
template <int Dim>
struct PointsOctree
{
  Octree<Dim> Tree;
  TreeFrame<Dim> Frame;
  ProcessGroup Processes;      ///< Who have parts of the tree; mostly this one alone.
  CurveDivision<Dim> Division; ///< The parts, by process.
  CurveRange<Dim> Range;       ///< This process's.
  DepthCounts Counts;
  /** Of the nodes that lie in several parts, by the values of their keys. */
  std::map<std::uint64_t, PointIndex> PointsAcross;
  std::size_t TreeBytes = 0;
  std::size_t SkippedPoints = 0; ///< Not finite, or too large.
  std::size_t OutsidePoints = 0; ///< Outside the given bounds.
  double BuildSeconds = 0.0;

  /** For what the processes do together. This must outlive it. */
  TreePart<Dim> GetPart() const
  {
    return { this->Tree, this->Range, this->Counts,
      [processes = this->Processes](std::vector<std::uint64_t>& values)
      { processes.Sum(values); } };
  }

  std::size_t GetNumberOfPoints() const { return GetTotal(this->Counts.Points); }
  std::size_t GetNumberOfLeaves() const { return GetTotal(this->Counts.Leaves); }
  /** Leaves and internal nodes, each of which replaces a leaf by 2^Dim. */
  std::size_t GetNumberOfNodes() const
  {
    return this->GetNumberOfLeaves() +
      (this->GetNumberOfLeaves() - 1) / (Octree<Dim>::NumberOfOctants - 1);
  }
  int GetDeepestDepth() const { return this->Counts.GetDeepestDepth(); }

  /** Gives those nodes of the tree that have points of other processes all of them. */
  void CompletePoints(Buffer<typename Octree<Dim>::Node>& nodes) const
  {
    for (std::size_t i = 0; !this->PointsAcross.empty() && i < nodes.GetSize(); ++i)
    {
      typename Octree<Dim>::Node& node = nodes[i];
      const auto across = this->PointsAcross.find(node.NodeKey.GetValue());
      if (node.Internal && across != this->PointsAcross.end())
      {
        node.LastPoint = node.FirstPoint + across->second;
      }
    }
  }
};

using AnyPointsOctree = std::variant<PointsOctree<2>, PointsOctree<3>>;
}

#endif
