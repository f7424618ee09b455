// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_CurveRange_h
#define hashedoctree_CurveRange_h

#include "MortonKey.h"

namespace hashedoctree
{
/** A stretch of the Morton curve: the keys at MaxDepth from First to Last, none where First is the
 * larger one. The default is the whole curve. A node is in the range that its first key is in, so
 * that ranges which divide the curve divide the nodes of a tree, too. */
template <int Dim>
struct CurveRange
{
  MortonKey<Dim> First = MortonKey<Dim>::Root().GetFirstAtMaxDepth();
  MortonKey<Dim> Last = MortonKey<Dim>::Root().GetLastAtMaxDepth();

  bool Has(MortonKey<Dim> node) const
  {
    const MortonKey<Dim> key = node.GetFirstAtMaxDepth();
    return this->First <= key && key <= this->Last;
  }
};
}

#endif
