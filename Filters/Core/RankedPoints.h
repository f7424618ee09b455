// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_RankedPoints_h
#define hashedoctree_RankedPoints_h

#include "PointIndex.h"

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/**
 * The closest points so far, in the order of their squared distances, equal ones by id. The points
 * of a leaf are put among them all at once: the place of each is the number of those before it,
 * which is counted without a branch whose way is hard to foresee. Private to ClosestFew.
 *
 * Compared are the upper halves of the distances, eight at a time where the machine has AVX2. As
 * whole numbers they are in the order of the distances, since none of these is negative. Where two
 * are equal and the distances are not, whole distances are compared. Equally near
 * points are left in the order of the leaf, which at one place is that of their ids, and sorted
 * where need be.
 */
class RankedPoints
{
public:
  static constexpr std::size_t MostKept = 256; ///< Points that are kept,
  static constexpr std::size_t MostAdded = 64; ///< and that are added at a time.
  static constexpr std::size_t Padding = 16;   ///< Vectors read and write beyond the last.

  RankedPoints() = default;
  RankedPoints(const RankedPoints&) = delete;
  void operator=(const RankedPoints&) = delete;

  /** Puts in their places those points of a leaf whose bits are set in `chosen`, and
   * keeps the first `most`, MostKept at most. `ids` must stay as they are. */
  void Merge(const double* dist2, const PointIndex* ids, std::uint64_t chosen, std::size_t most);
  /** The same by AVX2, which the machine must have. */
  void MergeWithVectors(
    const double* dist2, const PointIndex* ids, std::uint64_t chosen, std::size_t most);

  std::size_t Size = 0;
  double* Dist2 = Dist2Lists[0];
  const PointIndex** Ids = IdLists[0]; ///< Far away in memory, and looked at as late as can be.

private:
  template <typename Key>
  class Newcomers;
  /** Puts points in order as far as the first `most`. */
  using Sort = void (*)(double* dist2, const PointIndex** ids, std::size_t count, std::size_t most);
  template <typename Key>
  void MergeRanked(Newcomers<Key>& added, const double* dist2, const PointIndex* ids,
    std::size_t most, Sort putInOrder);
  void MergeInline(const double* dist2, const PointIndex* ids, std::uint64_t chosen,
    std::size_t most, Sort putInOrder);

  double Dist2Lists[2][MostKept + MostAdded + Padding]; ///< One is read while the other is written.
  const PointIndex* IdLists[2][MostKept + MostAdded + Padding];
};
}

#endif
