// SPDX-License-Identifier: BSD-3-Clause
#ifndef KeptOctrees_h
#define KeptOctrees_h

#include "PointCounts.h"
#include "PointsOctree.h"

#include "vtkPointSet.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <optional>

namespace hashedoctree
{
/** What was built of the points of one data set. Private to the module. */
struct BuiltOctree
{
  PointCounts Counts;
  std::optional<AnyPointsOctree> Octree; ///< None where there is no point to use.
};

/**
 * The octrees of a filter's last update, for the next one: where only what is asked of them has
 * changed, they need not be built anew. Who has one may use it, whatever is forgotten meanwhile.
 * Private to the module.
 */
class KeptOctrees
{
public:
  using Pointer = std::shared_ptr<const BuiltOctree>;

  /** Null where none is kept of these points. */
  Pointer Find(vtkPointSet* points) const;
  /** `time` is that of the points before the octree was built. */
  void Keep(vtkPointSet* points, vtkMTimeType time, const Pointer& built);
  /** Those of points that have changed since, or are gone. */
  void ForgetChanged();
  void Forget() { this->Octrees.clear(); }

private:
  struct Kept
  {
    vtkWeakPointer<vtkPointSet> Points;
    vtkMTimeType Time;
    Pointer Built;
  };
  std::map<const vtkPointSet*, Kept> Octrees;
};
}

#endif
