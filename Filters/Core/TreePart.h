// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_TreePart_h
#define hashedoctree_TreePart_h

#include "CurveRange.h"
#include "Octree.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace hashedoctree
{
/** The part that one of several builders has of the tree that they make together (CurveDivision),
 * or a whole tree. What it refers to must outlive it. */
template <int Dim>
class TreePart
{
public:
  /** Adds to each value those that the other builders have in its place, and returns when all of
   * them have called it. */
  using AddUpFunction = std::function<void(std::vector<std::uint64_t>&)>;

  /** A whole tree; implicit, as that is what it mostly is. */
  TreePart(const Octree<Dim>& tree)
    : TreePart(tree, CurveRange<Dim>(), tree.GetDepthCounts(), {})
  {
  }
  TreePart(Octree<Dim>&&) = delete; // It would not outlive this.
  /** The nodes in `range` of a builder's tree, and the leaves of all of them in `counts`. */
  TreePart(const Octree<Dim>& tree, const CurveRange<Dim>& range, const DepthCounts& counts,
    AddUpFunction addUp)
    : Tree(&tree)
    , Range(range)
    , Counts(&counts)
    , AddUpWithOthers(std::move(addUp))
  {
  }

  /** This builder's; for nodes in the range, and searches for keys there, it is that of all. */
  const Octree<Dim>& GetTree() const { return *this->Tree; }
  bool Has(MortonKey<Dim> node) const { return this->Range.Has(node); }

  /** Of all builders. */
  const DepthCounts& GetDepthCounts() const { return *this->Counts; }
  int GetDeepestDepth() const { return this->Counts->GetDeepestDepth(); }

  /** Waits for the other builders; see AddUpFunction. */
  void AddUp(std::vector<std::uint64_t>& values) const
  {
    if (this->AddUpWithOthers)
    {
      this->AddUpWithOthers(values);
    }
  }

private:
  const Octree<Dim>* Tree;
  CurveRange<Dim> Range;
  const DepthCounts* Counts;
  AddUpFunction AddUpWithOthers;
};
}

#endif
