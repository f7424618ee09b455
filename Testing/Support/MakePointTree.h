// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_MakePointTree_h
#define Testing_Support_MakePointTree_h

#include "PointTree.h"

/** The search structure of all points of a span, made on one thread. */
template <int Dim, typename Real>
hashedoctree::PointTree<Dim, Real> MakePointTree(hashedoctree::PointSpan<Dim, Real> points,
  std::size_t maxPointsPerLeaf, int maxDepth = hashedoctree::MortonKey<Dim>::MaxDepth)
{
  const hashedoctree::Execution execution;
  const hashedoctree::PointSelection<Dim> selection(points, {}, execution);
  return { points, selection, { maxPointsPerLeaf, maxDepth }, execution };
}

#endif
