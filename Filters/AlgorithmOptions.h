// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmOptions_h
#define AlgorithmOptions_h

#include "Octree.h"

#include "vtkHashedOctreeAlgorithm.h"

namespace hashedoctree
{
// The properties of an algorithm as the core has them. Private to the module.

inline Octree<3>::Options GetTreeOptions(vtkHashedOctreeAlgorithm* algorithm)
{
  return { static_cast<std::size_t>(algorithm->GetMaxPointsPerLeaf()), algorithm->GetMaxDepth() };
}

inline StartDepthOptions GetStartDepthOptions(vtkHashedOctreeAlgorithm* algorithm)
{
  return { static_cast<StartDepthModel>(algorithm->GetStartDepthModel()),
    static_cast<FrequencyModel>(algorithm->GetFrequencyModel()), algorithm->GetFixedStartDepth() };
}

/** How the empty octants of the tree are read. */
inline EmptyOctants GetReading(vtkHashedOctreeAlgorithm* algorithm)
{
  return algorithm->GetIncludeEmptyLeaves() ? EmptyOctants::Leaves : EmptyOctants::Missing;
}

/** Where searches in a tree with these counts start. */
inline int GetStartDepth(const DepthCounts& counts, const StartDepthOptions& options)
{
  return GetStartDepth(GetDepthHistogram(counts, options.Frequency, 3), options);
}
}

#endif
