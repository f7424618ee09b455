// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_CurveDivision_h
#define hashedoctree_CurveDivision_h

#include "CurveRange.h"
#include "Parted.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hashedoctree
{
/**
 * The Morton curve cut into parts, for several builders that make one tree together: each has the
 * points of one part and builds an Octree by itself.
 *
 * Whether a node is split follows from the number of its points, and these stand side by side along
 * the curve. So a builder that has GetOverlapSize() more points on either side of its part, or all
 * that there are, knows of every node with a key of the part whether it is split, and of every such
 * leaf all points. In its tree those nodes and the searches for those keys are as in the tree of
 * all points; other nodes need not be, and internal ones of GetNodesAcross() lack points of other
 * parts. The nodes that are in the ranges of the parts (CurveRange), taken together, are the one
 * tree. A part begins where a cell of the tree's MaxDepth does, so that a leaf there, which may
 * hold any number of points, has all of them in one part.
 *
 * All keys are at MortonKey::MaxDepth where nothing else is said. Immutable; thread safe.
 */
template <int Dim>
class CurveDivision
{
public:
  using Key = MortonKey<Dim>;
  using Keys = std::vector<Key>;

  /** Those of its keys that each builder gives for the division, given how many points there are in
   * all: one of every so many, at places that have no rule in common with the input, about
   * KeysPerPart for each part. */
  static Keys Sample(const Keys& keys, std::uint64_t allPoints, std::size_t numberOfParts);
  static constexpr std::uint64_t KeysPerPart = 1024;

  /** One part. */
  CurveDivision()
    : CurveDivision({}, 1, 0)
  {
  }
  /** Parts, at least one, with about as many points each, as far as a sample of the keys in any
   * order tells; `maxDepth` is that of the tree. O(s log s) for s keys. */
  CurveDivision(Keys sample, std::size_t numberOfParts, int maxDepth);

  std::size_t GetNumberOfParts() const { return this->FirstOfPart.size(); }
  /** The parts cover the curve, one after the other; some may be empty. */
  CurveRange<Dim> GetRange(std::size_t part) const;
  /** The part that a key is in. O(log(parts)). */
  std::size_t FindPart(Key key) const;
  /** The keys by part, in each in the order in which they are given. O(n log(parts)). */
  Parted<Key> Deal(const Keys& keys) const;

  /** Keys of all nodes with keys in several parts, by value: where they are internal, no builder
   * has all of their points. At most MaxDepth + 1 for each cut. */
  Keys GetNodesAcross() const;
  /** How many of the keys of a part are in each of these nodes. O(n) for n keys. */
  std::vector<std::uint64_t> CountInNodesAcross(std::size_t part, const Keys& keys) const;

  /** How many points a builder needs on either side of its part. */
  static std::size_t GetOverlapSize(std::size_t maxPointsPerLeaf) { return maxPointsPerLeaf + 1; }
  /** Those keys of a part that the builder of each other part needs, to have the `overlap` next to
   * its own ones on either side, or all if there are fewer; given how many points each part has.
   * O(n log(overlap)), O(overlap) for each part that needs some, and O(parts) for each part. */
  static Parted<Key> GetOverlaps(std::size_t part, const Keys& keys,
    const std::vector<std::uint64_t>& pointsOfParts, std::size_t overlap);

private:
  Keys FirstOfPart; ///< Ascending; of the first part that of the curve.
};
}

#endif
