// SPDX-License-Identifier: BSD-3-Clause
#include "PointsAdaptor.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <stdexcept>

namespace hashedoctree
{
namespace
{
/** Arrays that compute their tuples may keep the last one, as those of vtkAngularPeriodicFilter do:
 * such can be read on one thread only. */
bool HoldsItsTuples(vtkDataArray* data)
{
  const int type = data->GetArrayType();
  return type == vtkAbstractArray::AoSDataArrayTemplate ||
    type == vtkAbstractArray::SoADataArrayTemplate;
}
}

PointsAdaptor::PointsAdaptor(vtkDataSet* dataSet, const Execution& execution)
  : Count(static_cast<std::size_t>(dataSet->GetNumberOfPoints()))
{
  auto* pointSet = vtkPointSet::SafeDownCast(dataSet);
  if (pointSet == nullptr || pointSet->GetPoints() == nullptr)
  {
    if (this->Count > 0)
    {
      double x[3];
      dataSet->GetPoint(0, x); // From then on any thread may, says vtkDataSet.
    }
    this->CopyPoints([dataSet](vtkIdType id, double* x) { dataSet->GetPoint(id, x); }, execution);
    return;
  }
  vtkDataArray* data = pointSet->GetPoints()->GetData();
  if (this->Count > 0 && data->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument(
      "The array of the points must have three components, one tuple for each point.");
  }
  this->ViewOrCopy(data, execution);
}

PointsAdaptor::PointsAdaptor(vtkDataArray* data, const Execution& execution)
  : Count(static_cast<std::size_t>(data->GetNumberOfTuples()))
{
  this->ViewOrCopy(data, execution);
}

void PointsAdaptor::ViewOrCopy(vtkDataArray* data, const Execution& execution)
{
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
    this->CopyPoints([data](vtkIdType id, double* x) { data->GetTuple(id, x); },
      HoldsItsTuples(data) ? execution : execution.OnOneThread());
  }
}

template <typename GetPoint>
void PointsAdaptor::CopyPoints(const GetPoint& getPoint, const Execution& execution)
{
  constexpr std::size_t grain = 8192; // Points that a thread copies at a time.
  this->Copy = Buffer<Position<3>>(this->Count);
  execution.For(this->Count, grain,
    [this, &getPoint](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        getPoint(static_cast<vtkIdType>(i), this->Copy[i].data());
      }
    });
  this->Doubles = this->Count > 0 ? this->Copy[0].data() : nullptr;
}
}
