// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_SampleTree_h
#define Testing_Support_SampleTree_h

#include "Invariants.h"
#include "PointSamples.h"

#include <gtest/gtest.h>

/** A tree over a sample with all that it was made from. Checks the laws of the tree (see
 * Invariants.h), so that no test goes on with a broken one unseen. */
template <int Dim, typename Real>
struct SampleTree
{
  using Options = typename hashedoctree::Octree<Dim>::Options;

  hashedoctree::PointSelection<Dim> Selection;
  hashedoctree::Octree<Dim> Tree;

  explicit SampleTree(const PointSample<Dim, Real>& sample, const Options& options = Options(),
    const hashedoctree::Execution& execution = hashedoctree::Execution())
    : Selection(sample.GetSpan(), {}, execution)
    , Tree(sample.GetSpan(), this->Selection, options, execution)
  {
    for (const std::string& law :
      hashedoctree::FindBrokenLaws(this->Tree, sample.GetSpan(), this->Selection))
    {
      ADD_FAILURE() << sample.Name << ": " << law;
    }
  }
};

/** Calls function(node) for every node of a tree, from the root downwards. */
template <int Dim, typename Function>
void ForEachNode(const hashedoctree::Octree<Dim>& tree, const Function& function)
{
  function(tree.GetRoot());
  for (std::size_t block = 0; block < tree.GetNumberOfInternalNodes(); ++block)
  {
    for (unsigned octant = 0; octant < hashedoctree::Octree<Dim>::NumberOfOctants; ++octant)
    {
      function(tree.GetChild(block, octant));
    }
  }
}

/** Calls function(leaf) for every leaf, empty ones too. */
template <int Dim, typename Function>
void ForEachLeaf(const hashedoctree::Octree<Dim>& tree, const Function& function)
{
  ForEachNode(tree,
    [&function](const typename hashedoctree::Octree<Dim>::Node& node)
    {
      if (!node.Internal)
      {
        function(node);
      }
    });
}

#endif
