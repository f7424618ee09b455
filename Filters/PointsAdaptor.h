// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointsAdaptor_h
#define PointsAdaptor_h

#include "Buffer.h"
#include "Execution.h"
#include "PointSpan.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"

namespace hashedoctree
{
/**
 * The bridge from the points of a vtkDataSet, or an array of three components, to the core's point
 * spans. Arrays of float or double tuples are viewed where they are; any other layout or type, and
 * points that no array holds, are copied to doubles. The points must outlive the adaptor and not
 * change meanwhile. Private to the module.
 */
class PointsAdaptor
{
public:
  /** Throws Interrupted and std::bad_alloc while it copies, and std::invalid_argument where the
   * points have an array of more or fewer than three components. */
  PointsAdaptor(vtkDataSet* dataSet, const Execution& execution);
  PointsAdaptor(vtkDataArray* data, const Execution& execution);

  /** Calls function(span) with a PointSpan<3, float> or PointSpan<3, double>. */
  template <typename Function>
  void Visit(const Function& function) const
  {
    if (this->Floats != nullptr)
    {
      function(PointSpan<3, float>{ this->Floats, this->Count });
    }
    else
    {
      function(PointSpan<3, double>{ this->Doubles, this->Count });
    }
  }

private:
  void ViewOrCopy(vtkDataArray* data, const Execution& execution);
  /** Calls getPoint(i, x) for each point. */
  template <typename GetPoint>
  void CopyPoints(const GetPoint& getPoint, const Execution& execution);

  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  std::size_t Count = 0;
  Buffer<Position<3>> Copy;
};
}

#endif
