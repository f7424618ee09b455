// SPDX-License-Identifier: BSD-3-Clause
#include "PointsAdaptor.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

namespace hashedoctree
{
PointsAdaptor::PointsAdaptor(vtkPoints* points, const Execution& execution)
  : Count(static_cast<std::size_t>(points->GetNumberOfPoints()))
{
  constexpr std::size_t grain = 8192; // Points that a thread copies at a time.
  vtkDataArray* data = points->GetData();
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(data))
  {
    this->Floats = floats->GetPointer(0);
  }
  else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(data))
  {
    this->Doubles = doubles->GetPointer(0);
  }
  else
  {
    this->Copy = Buffer<double>(3 * this->Count);
    execution.For(this->Count, grain,
      [this, data](std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          data->GetTuple(static_cast<vtkIdType>(i), &this->Copy[3 * i]);
        }
      });
    this->Doubles = this->Copy.GetData();
  }
}
}
