// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_StartDepths_h
#define hashedoctree_StartDepths_h

#include "DepthStatistics.h"
#include "TreePart.h"

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/**
 * Where direct searches in a tree start, by position. All models but Local have one start depth for
 * the whole tree. Local has one for each cell of a coarse grid, the weighted median of the leaves
 * in that cell, so that where leaves lie at different depths in different places (the mixed models
 * that the paper ends with) each place has its own; a coarse cell inside one leaf takes that leaf's
 * depth. In a coarse cell without any weight, one without points by the Points model, each leaf
 * weighs one.
 *
 * Immutable; thread safe.
 */
template <int Dim>
class StartDepths
{
public:
  /** Depth of the coarse cells, or that of the deepest leaf where that is less: at most 2^12 of
   * them, one byte each. */
  static constexpr int LocalDepth = 12 / Dim;

  /** All searches start at the root. */
  StartDepths() = default;
  /** The same for all builders of a tree, all of which have to call it. O(1), of the Local model
   * O(nodes). */
  StartDepths(const TreePart<Dim>& part, const StartDepthOptions& options);

  /** The depth at which the search for a position starts, given its key at MaxDepth. */
  int Get(MortonKey<Dim> key) const
  {
    return this->Local.empty() ? this->Everywhere : this->Local[this->GetCoarseCell(key)];
  }
  /** The depth for the whole tree; of the Local model the one that Median has. */
  int GetOfTree() const { return this->Everywhere; }

  /** Bytes beside the object itself: those of the Local model. */
  std::size_t GetBytes() const { return this->Local.size(); }

  /** Mean number of nodes that a search in the tree examines, as GetMeanCost() of
   * DepthStatistics.h has it, when leaves are searched for as often as `frequency` says. 0 without
   * any weight. All builders have to call it. O(depths), of the Local model O(nodes). */
  double GetMeanCost(const TreePart<Dim>& part, FrequencyModel frequency) const;

private:
  std::size_t GetCoarseCell(MortonKey<Dim> key) const
  {
    return static_cast<std::size_t>(key.AtDepth(this->CellDepth).GetValue()) ^
      (std::size_t(1) << (Dim * this->CellDepth));
  }
  void ChooseLocal(const TreePart<Dim>& part, FrequencyModel frequency);

  int Everywhere = 0;
  int CellDepth = 0; ///< Of the coarse cells.
  std::vector<std::uint8_t> Local;
};
}

#endif
