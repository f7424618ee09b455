// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_PointClouds_h
#define Testing_Cxx_PointClouds_h

#include "PointSamples.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <type_traits>
#include <vector>

template <typename Real>
constexpr int TypeOfPoints = std::is_same<Real, float>::value ? VTK_FLOAT : VTK_DOUBLE;

/** Points of a VTK type, that of their coordinates unless given, from three of these for each. */
template <typename Real = double>
vtkSmartPointer<vtkPoints> MakePoints(
  const std::vector<Real>& coordinates, int type = TypeOfPoints<Real>)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(coordinates.size() / 3));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const Real* x = coordinates.data() + 3 * i;
    points->SetPoint(
      i, static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]));
  }
  return points;
}

/** The same points in a data set, without cells. */
template <typename Real = double>
vtkSmartPointer<vtkPolyData> MakePolyData(
  const std::vector<Real>& coordinates, int type = TypeOfPoints<Real>)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(MakePoints(coordinates, type));
  return data;
}

/** Uniform random points in the unit cube. */
inline vtkSmartPointer<vtkPolyData> MakeUniform(std::size_t count, unsigned seed)
{
  return MakePolyData(MakeUniformPoints<3, double>(count, seed));
}

#endif
