// SPDX-License-Identifier: BSD-3-Clause
#include "PointSelection.h"

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
    const bool finite = std::abs(box.Lower[axis]) <= Grid<Dim>::MaxCoordinate &&
      std::abs(box.Upper[axis]) <= Grid<Dim>::MaxCoordinate;
    if (!finite || box.Lower[axis] > box.Upper[axis])
    {
      throw std::invalid_argument(
        "The given bounds must be finite, and each lower one at most its upper one.");
    }
  }
}

template <int Dim>
struct ChunkCensus
{
  Box<Dim> Bounds;
  std::size_t Kept = 0;
  std::size_t Skipped = 0;
};
}

template <int Dim>
template <typename Points>
PointSelection<Dim>::PointSelection(
  Points points, const std::optional<Box<Dim>>& given, const Execution& execution)
  : HasBox(given.has_value())
{
  if (points.Count > MaxNumberOfPoints)
  {
    throw std::length_error("There are more points than 32 bits can number; split the data set, or "
                            "build with HASHEDOCTREE_64BIT_IDS.");
  }
  if (given)
  {
    RequireValid(*given);
    this->Bounds = *given;
  }

  std::vector<ChunkCensus<Dim>> census(Execution::GetNumberOfChunks(points.Count, ChunkSize));
  execution.ForChunks(points.Count, ChunkSize,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      ChunkCensus<Dim> local;
      for (std::size_t i = first; i < last; ++i)
      {
        const auto x = points[i];
        if (!IsFinite(x))
        {
          ++local.Skipped;
        }
        else if (!this->HasBox || this->IsInBox(x))
        {
          ++local.Kept;
          for (int axis = 0; axis < Dim; ++axis)
          {
            const double coordinate = static_cast<double>(x[axis]);
            local.Bounds.Lower[axis] = std::min(local.Bounds.Lower[axis], coordinate);
            local.Bounds.Upper[axis] = std::max(local.Bounds.Upper[axis], coordinate);
          }
        }
      }
      census[chunk] = local;
    });

  this->FirstOfChunk.assign(1, 0);
  this->FirstOfChunk.reserve(census.size() + 1);
  for (const ChunkCensus<Dim>& chunk : census)
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
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
