// SPDX-License-Identifier: BSD-3-Clause
#ifndef KeptOctrees_h
#define KeptOctrees_h

#include "PointCounts.h"
#include "PointsOctree.h"

#include "vtkDataObject.h"
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
 * The octrees that a filter has built of its input, for the next update: where only what is asked
 * of them has changed, they need not be built anew. Who has one may use it, whatever is forgotten
 * meanwhile. Private to the module.
 */
class KeptOctrees
{
public:
  using Pointer = std::shared_ptr<const BuiltOctree>;

  /** When the points or their marks were changed. */
  static vtkMTimeType GetTime(vtkPointSet* points);
  /** Null where none is kept of these points as they are now. */
  Pointer Find(vtkPointSet* points) const;
  /** `time` is that of the points before the octree was built. */
  void Keep(vtkPointSet* points, vtkMTimeType time, const Pointer& built);
  /** What is not of this input as it is now: of points that have changed or are gone and, where the
   * input has been generated again, whether it says that it has changed or not, all. */
  void ForgetOthers(vtkDataObject* input);
  void Forget() { this->Octrees.clear(); }

private:
  struct Kept
  {
    vtkWeakPointer<vtkPointSet> Points;
    vtkMTimeType Time;
    Pointer Built;

    bool IsGood() const;
  };
  std::map<const vtkPointSet*, Kept> Octrees;
  vtkMTimeType UpdateTime = 0; ///< Of the input that they are of.
};
}

#endif
