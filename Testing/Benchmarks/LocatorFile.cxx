// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorFile.h"

#include "LocatorOptions.h"

#include "vtkNew.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace locator_benchmark
{
vtkSmartPointer<vtkPoints> ReadPoints(const std::string& path)
{
  if (!std::ifstream(path))
  {
    throw std::runtime_error("cannot read '" + path + "'; give a .vtp file with points");
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  vtkSmartPointer<vtkPoints> points;
  if (reader->CanReadFile(path.c_str()))
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    points = reader->GetOutput()->GetPoints();
  }
  if (!points || points->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("VTK finds no points in '" + path +
      "'; give polygonal data in .vtp, saved as ascii or inline binary");
  }
  return points;
}

LocatorData ReadOwnData(const std::string& path)
{
  const vtkSmartPointer<vtkPoints> points = ReadPoints(path);
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  if (count < LocatorOptions::LeastSize)
  {
    throw std::runtime_error("'" + path + "' has only " + std::to_string(count) +
      " points; give a file of at least " + std::to_string(LocatorOptions::LeastSize));
  }
  std::vector<float> coordinates;
  coordinates.reserve(3 * count);
  for (std::size_t id = 0; id < count; ++id)
  {
    double x[3];
    points->GetPoint(static_cast<vtkIdType>(id), x);
    std::transform(x, x + 3, std::back_inserter(coordinates),
      [](double coordinate) { return static_cast<float>(coordinate); });
  }
  if (!std::all_of(
        coordinates.begin(), coordinates.end(), [](float x) { return std::isfinite(x); }))
  {
    throw std::runtime_error("'" + path +
      "' has points that are not finite in float, which other locators cannot take; remove or "
      "scale them");
  }
  return { std::filesystem::path(path).stem().string(), std::move(coordinates) };
}
}
