// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointCounts_h
#define PointCounts_h

#include "DuplicatePoints.h"
#include "PointSelection.h"
#include "ProcessGroup.h"

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/** How many points of each kind there are, those that VTK marks as another piece's apart, which
 * count there. Private to the module. */
struct PointCounts
{
  std::uint64_t Own = 0;
  std::uint64_t Skipped = 0; ///< Own ones that are not finite, or too large,
  std::uint64_t Outside = 0; ///< and others outside the given bounds.
  std::uint64_t Others = 0;  ///< Another piece's.

  PointCounts() = default;
  /** Of a span, from which the selection was made. O(points) where some are another piece's. Throws
   * Interrupted. */
  template <typename Points>
  PointCounts(Points points, const PointSelection<3>& selection, const DuplicatePoints& others,
    const Execution& execution)
    : Own(points.Count)
    , Skipped(selection.GetNumberOfSkippedPoints())
    , Outside(selection.GetNumberOfOutsidePoints())
  {
    constexpr std::size_t grain = 4096; // Points between looks whether to go on.
    execution.OnOneThread().ForEach(others.AreThere() ? points.Count : 0, grain,
      [&](std::size_t i)
      {
        if (others.Have(static_cast<vtkIdType>(i)))
        {
          const bool isSkipped = !PointSelection<3>::CanBePlaced(points[i]);
          this->Skipped -= isSkipped ? 1 : 0;
          this->Outside -= !isSkipped && !selection.Keeps(points[i]) ? 1 : 0;
          --this->Own;
          ++this->Others;
        }
      });
  }

  void Add(const PointCounts& other)
  {
    this->Own += other.Own;
    this->Skipped += other.Skipped;
    this->Outside += other.Outside;
    this->Others += other.Others;
  }
  /** Those of all processes, all of which have to call it. */
  PointCounts SumOf(const ProcessGroup& processes) const
  {
    std::vector<std::uint64_t> sums{ this->Own, this->Skipped, this->Outside, this->Others };
    processes.Sum(sums);
    PointCounts ofAll;
    ofAll.Own = sums[0];
    ofAll.Skipped = sums[1];
    ofAll.Outside = sums[2];
    ofAll.Others = sums[3];
    return ofAll;
  }
};
}

#endif
