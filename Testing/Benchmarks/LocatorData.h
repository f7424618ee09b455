// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorData_h
#define Testing_Benchmarks_LocatorData_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace locator_benchmark
{
using Position = std::array<double, 3>;

/** Points in float, in the one memory that all locators read. */
class LocatorData
{
public:
  /** Takes x, y, z of one point after the other. */
  LocatorData(std::string name, std::vector<float> coordinates);

  const std::string& GetName() const { return this->Name; }
  std::size_t GetNumberOfPoints() const { return this->Coordinates.size() / 3; }
  const float* GetPoint(std::size_t id) const { return this->Coordinates.data() + 3 * id; }

  /** The points without their bounds, which are so part of a build, and without a copy. Locators
   * that shared one object would all be out of date when it is modified. */
  vtkSmartPointer<vtkPolyData> MakePolyData() const;

  /** By this all answers are compared: double, summed in axis order. */
  double GetDistance2(std::size_t id, const Position& x) const;

private:
  std::string Name;
  std::vector<float> Coordinates;
};
}

#endif
