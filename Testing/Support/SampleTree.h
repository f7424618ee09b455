// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_SampleTree_h
#define Testing_Support_SampleTree_h

#include "ForEachNode.h"
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

#endif
