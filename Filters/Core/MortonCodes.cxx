// SPDX-License-Identifier: BSD-3-Clause
#include "MortonCodes.h"

#include "PlaneSpan.h"

namespace hashedoctree
{
template <int Dim, typename Points>
Buffer<CodedPoint<Dim>> EncodePoints(Points points, const PointSelection<Dim>& selection,
  const Grid<Dim>& grid, const Execution& execution)
{
  constexpr std::size_t blockSize = 128; // Cells and keys of a block stay in the first cache.
  Buffer<CodedPoint<Dim>> coded(selection.GetNumberOfPoints());

  execution.ForChunks(points.Count, PointSelection<Dim>::ChunkSize,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      const bool keepsAll = selection.KeepsAll();
      std::array<Cell<Dim>, blockSize> cells;
      std::array<MortonKey<Dim>, blockSize> keys;
      std::size_t next = selection.GetFirstOfChunk(chunk);
      for (std::size_t block = first; block < last; block += blockSize)
      {
        const std::size_t end = std::min(last, block + blockSize);
        std::size_t kept = 0;
        for (std::size_t i = block; i < end; ++i)
        {
          const auto x = points[i];
          if (keepsAll || selection.Keeps(x))
          {
            coded[next + kept].Id = static_cast<PointIndex>(i);
            cells[kept] = grid.GetCell(x);
            ++kept;
          }
        }
        InterleaveCells<Dim>(cells.data(), kept, keys.data());
        for (std::size_t i = 0; i < kept; ++i)
        {
          coded[next + i].Key = keys[i];
        }
        next += kept;
      }
    });
  return coded;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template Buffer<CodedPoint<Dim>> EncodePoints(                                                   \
    PointSpan<Dim, float>, const PointSelection<Dim>&, const Grid<Dim>&, const Execution&);        \
  template Buffer<CodedPoint<Dim>> EncodePoints(                                                   \
    PointSpan<Dim, double>, const PointSelection<Dim>&, const Grid<Dim>&, const Execution&);
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
template Buffer<CodedPoint<2>> EncodePoints(
  PlaneSpan<float>, const PointSelection<2>&, const Grid<2>&, const Execution&);
template Buffer<CodedPoint<2>> EncodePoints(
  PlaneSpan<double>, const PointSelection<2>&, const Grid<2>&, const Execution&);
}
