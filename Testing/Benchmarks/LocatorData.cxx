// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorData.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace locator_benchmark
{
LocatorData::LocatorData(std::string name, std::vector<float> coordinates)
  : Name(std::move(name))
  , Coordinates(std::move(coordinates))
{
}

vtkSmartPointer<vtkPolyData> LocatorData::MakePolyData() const
{
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetArray(const_cast<float*>(this->Coordinates.data()),
    static_cast<vtkIdType>(this->Coordinates.size()), /*save=*/1);
  vtkNew<vtkPoints> points;
  points->SetData(array);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

double LocatorData::GetDistance2(std::size_t id, const Position& x) const
{
  const float* point = this->GetPoint(id);
  double distance2 = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double difference = x[axis] - static_cast<double>(point[axis]);
    distance2 += difference * difference;
  }
  return distance2;
}
}
