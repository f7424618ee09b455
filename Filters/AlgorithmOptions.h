// SPDX-License-Identifier: BSD-3-Clause
#ifndef AlgorithmOptions_h
#define AlgorithmOptions_h

#include "Octree.h"
#include "PropertyModels.h"

#include "vtkHashedOctreeAlgorithm.h"

#include <algorithm>

namespace hashedoctree
{
// The properties of an algorithm as the core has them. Private to the module.

static_assert(HasModelsOfCore<vtkHashedOctreeAlgorithm>(), "models are cast");
static_assert(MortonKey<2>::MaxDepth == 31 && MortonKey<3>::MaxDepth == 21,
  "properties of vtkHashedOctreeAlgorithm are clamped to these");

/** Depths beyond the deepest of the dimension act as that one. */
template <int Dim>
typename Octree<Dim>::Options GetTreeOptions(vtkHashedOctreeAlgorithm* algorithm)
{
  return { static_cast<std::size_t>(algorithm->GetMaxPointsPerLeaf()),
    std::min(algorithm->GetMaxDepth(), MortonKey<Dim>::MaxDepth) };
}

template <int Dim>
StartDepthOptions GetStartDepthOptions(vtkHashedOctreeAlgorithm* algorithm)
{
  return { static_cast<StartDepthModel>(algorithm->GetStartDepthModel()),
    static_cast<FrequencyModel>(algorithm->GetFrequencyModel()),
    std::min(algorithm->GetFixedStartDepth(), MortonKey<Dim>::MaxDepth) };
}

/** How the empty octants of the tree are read. */
inline EmptyOctants GetReading(vtkHashedOctreeAlgorithm* algorithm)
{
  return algorithm->GetIncludeEmptyLeaves() ? EmptyOctants::Leaves : EmptyOctants::Missing;
}
}

#endif
