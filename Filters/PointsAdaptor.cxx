// SPDX-License-Identifier: BSD-3-Clause
#include "PointsAdaptor.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

namespace hashedoctree
{
PointsAdaptor::PointsAdaptor(vtkPoints* points)
  : Count(static_cast<std::size_t>(points->GetNumberOfPoints()))
{
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
    this->Copy.resize(3 * this->Count);
    vtkSMPTools::For(0, points->GetNumberOfPoints(),
      [this, data](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          data->GetTuple(i, this->Copy.data() + 3 * i);
        }
      });
    this->Doubles = this->Copy.data();
  }
}
}
