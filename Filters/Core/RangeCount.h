// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_RangeCount_h
#define hashedoctree_RangeCount_h

#include "CurveRange.h"

#include <cstdint>

namespace hashedoctree
{
/** Counts the nodes that a neighbour search examines on behalf of nodes in a range of the curve:
 * those of ranges that divide the curve add up to those of the whole curve. For one thread. */
template <int Dim>
class RangeCount
{
public:
  /** All of them. */
  RangeCount() = default;
  explicit RangeCount(const CurveRange<Dim>& range)
    : Range(range)
  {
  }

  /** The next nodes are examined on behalf of this one. Every search tells so before it counts. */
  void Enter(MortonKey<Dim> node) { this->IsInRange = this->Range.Has(node); }
  void AddNode() { this->AddNodes(1); }
  void AddNodes(int count)
  {
    this->Nodes += this->IsInRange ? static_cast<std::uint64_t>(count) : 0;
  }

  std::uint64_t GetNodes() const { return this->Nodes; }

private:
  CurveRange<Dim> Range;
  std::uint64_t Nodes = 0;
  bool IsInRange = false; ///< The node that was entered last.
};
}

#endif
