// SPDX-License-Identifier: BSD-3-Clause
#include "PointSelection.h"

#include "FiniteBox.h"
#include "ForEachDimension.h"
#include "PointIndex.h"

#include <sstream>
#include <stdexcept>

namespace hashedoctree
{
namespace
{
template <int Dim>
void RequireValid(const Box<Dim>& box)
{
  for (int axis = 0; axis < Dim; ++axis)
  {
    const double lower = box.Lower[axis];
    const double upper = box.Upper[axis];
    constexpr double most = Grid<Dim>::MaxCoordinate;
    const bool isFinite = std::abs(lower) <= most && std::abs(upper) <= most;
    if (!isFinite || lower > upper)
    {
      std::ostringstream problem;
      problem << "The given bounds are from " << lower << " to " << upper << " on axis "
              << "xyzw"[axis] << "; give ";
      if (isFinite)
      {
        problem << "the lower one first.";
      }
      else
      {
        problem << "finite ones, not beyond " << most << ".";
      }
      throw std::invalid_argument(problem.str());
    }
  }
}
}

template <int Dim>
struct PointSelection<Dim>::Census
{
  Box<Dim> Bounds;
  std::size_t Kept = 0;
  std::size_t Skipped = 0;
};

/** Looks at the points [first, last), at least one. */
template <int Dim>
template <typename Points>
typename PointSelection<Dim>::Census PointSelection<Dim>::Count(
  Points points, std::size_t first, std::size_t last) const
{
  if (!this->HasBox)
  {
    if (const auto box = FindFiniteBox<Dim>(points[first], last - first))
    {
      return Census{ *box, last - first, 0 };
    }
  }
  Census census;
  for (std::size_t i = first; i < last; ++i)
  {
    const auto x = points[i];
    if (!CanBePlaced(x))
    {
      ++census.Skipped;
    }
    else if (!this->HasBox || this->IsInBox(x))
    {
      ++census.Kept;
      const Position<Dim> position = GetPosition<Dim>(points, i);
      census.Bounds.Add(Box<Dim>(position, position));
    }
  }
  return census;
}

template <int Dim>
template <typename Points>
PointSelection<Dim>::PointSelection(
  Points points, const std::optional<Box<Dim>>& given, const Execution& execution)
  : HasBox(given.has_value())
{
  RequirePointIndices(points.Count);
  if (given)
  {
    RequireValid(*given);
    this->Bounds = *given;
  }

  const auto census = execution.MapChunks(points.Count, ChunkSize,
    [&](std::size_t first, std::size_t last) { return this->Count(points, first, last); });

  this->FirstOfChunk.assign(1, 0);
  this->FirstOfChunk.reserve(census.size() + 1);
  for (const Census& chunk : census)
  {
    this->FirstOfChunk.push_back(this->FirstOfChunk.back() + chunk.Kept);
    this->Skipped += chunk.Skipped;
    this->Bounds.Add(chunk.Bounds); // A given box holds it already.
  }
  this->Outside = points.Count - this->Skipped - this->GetNumberOfPoints();
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class PointSelection<Dim>;                                                              \
  template PointSelection<Dim>::PointSelection(                                                    \
    PointSpan<Dim, float>, const std::optional<Box<Dim>>&, const Execution&);                      \
  template PointSelection<Dim>::PointSelection(                                                    \
    PointSpan<Dim, double>, const std::optional<Box<Dim>>&, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
