// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorTerrain.h"

#include "LocatorFile.h"

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace locator_benchmark
{
namespace
{
/** The grid of measured points, row after row. */
class Terrain
{
public:
  explicit Terrain(const std::string& path)
    : Points(ReadPoints(path))
  {
    const vtkIdType count = this->Points->GetNumberOfPoints();
    this->Columns = this->CountColumns(count);
    this->Rows = this->Columns > 0 ? count / this->Columns : 0;
    if (this->Rows < 2 || this->Columns < 2 || this->Rows * this->Columns != count)
    {
      throw std::runtime_error("'" + path + "' is not a grid of terrain points");
    }
  }

  double GetColumns() const { return static_cast<double>(this->Columns); }
  double GetRows() const { return static_cast<double>(this->Rows); }

  /** The point at a fractional row and column, both from 0 to 1, between the four around it. */
  std::array<double, 3> Interpolate(double row, double column) const
  {
    const double u = column * (this->GetColumns() - 1.0);
    const double v = row * (this->GetRows() - 1.0);
    const vtkIdType i = std::min(static_cast<vtkIdType>(u), this->Columns - 2);
    const vtkIdType j = std::min(static_cast<vtkIdType>(v), this->Rows - 2);
    std::array<double, 3> result{};
    for (const vtkIdType corner : { 0, 1, 2, 3 })
    {
      const vtkIdType right = corner % 2;
      const vtkIdType down = corner / 2;
      const double weightU = right ? u - static_cast<double>(i) : static_cast<double>(i + 1) - u;
      const double weightV = down ? v - static_cast<double>(j) : static_cast<double>(j + 1) - v;
      double x[3];
      this->Points->GetPoint((j + down) * this->Columns + i + right, x);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        result[axis] += weightU * weightV * x[axis];
      }
    }
    return result;
  }

private:
  /** The points of the first row have the same y. */
  vtkIdType CountColumns(vtkIdType count) const
  {
    vtkIdType columns = 0;
    double first[3] = {};
    double x[3] = {};
    for (; columns < count; ++columns)
    {
      this->Points->GetPoint(columns, columns == 0 ? first : x);
      if (columns > 0 && x[1] != first[1])
      {
        break;
      }
    }
    return columns;
  }

  vtkSmartPointer<vtkPoints> Points;
  vtkIdType Columns = 0;
  vtkIdType Rows = 0;
};
}

std::vector<float> ResampleTerrain(const std::string& path, std::size_t count, unsigned seed)
{
  const Terrain terrain(path);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto wanted = static_cast<double>(count);
  const double columns = std::ceil(std::sqrt(wanted * terrain.GetColumns() / terrain.GetRows()));
  const double rows = std::ceil(wanted / columns);
  std::vector<float> coordinates;
  coordinates.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double row = std::floor(static_cast<double>(i) / columns);
    const double column = static_cast<double>(i) - row * columns;
    const double jitter = uniform(random);
    for (const double x :
      terrain.Interpolate((row + jitter) / rows, (column + uniform(random)) / columns))
    {
      coordinates.push_back(static_cast<float>(x));
    }
  }
  return coordinates;
}
}
