// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_RangeCount_h
#define hashedoctree_RangeCount_h

#include "CurveRange.h"

namespace hashedoctree
{
/** Counts the nodes that a search examines on behalf of nodes in a range of the curve: those of
 * ranges that divide the curve add up to what NodeCount counts. */
template <int Dim>
class RangeCount
{
public:
  explicit RangeCount(const CurveRange<Dim>& range)
    : Range(range)
  {
  }

  void Enter(MortonKey<Dim> node) { this->Counts = this->Range.Has(node); }
  void AddNode() { this->AddNodes(1); }
  void AddNodes(int count) { this->Nodes += this->Counts ? static_cast<std::uint64_t>(count) : 0; }

  std::uint64_t GetNodes() const { return this->Nodes; }

private:
  CurveRange<Dim> Range;
  std::uint64_t Nodes = 0;
  bool Counts = false;
};
}

#endif
