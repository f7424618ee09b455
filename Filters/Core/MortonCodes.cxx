// SPDX-License-Identifier: BSD-3-Clause
#include "MortonCodes.h"

#include "PlaneSpan.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define HASHEDOCTREE_PDEP
#endif

namespace hashedoctree
{
namespace
{
#ifdef HASHEDOCTREE_PDEP
template <int Dim>
__attribute__((target("bmi2"))) void InterleaveWithPdep(
  const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys)
{
  constexpr std::uint64_t lowestAxis = Dilation<Dim>::Mask(1);
  constexpr std::uint64_t root = std::uint64_t(1) << (Dim * MortonKey<Dim>::MaxDepth);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::uint64_t value = root;
    for (int axis = 0; axis < Dim; ++axis)
    {
      value |= _pdep_u64(cells[i][axis], lowestAxis << (Dim - 1 - axis));
    }
    keys[i] = MortonKey<Dim>(value);
  }
}
#endif

Interleaving FindFastestInterleaving()
{
#ifdef HASHEDOCTREE_PDEP
  if (HasPdep() && !__builtin_cpu_is("znver1") && !__builtin_cpu_is("znver2") &&
    !__builtin_cpu_is("bdver4"))
  {
    return Interleaving::Pdep;
  }
#endif
  return Interleaving::Dilation;
}
}

bool HasPdep()
{
#ifdef HASHEDOCTREE_PDEP
  return __builtin_cpu_supports("bmi2") != 0;
#else
  return false;
#endif
}

Interleaving GetFastestInterleaving()
{
  static const Interleaving fastest = FindFastestInterleaving();
  return fastest;
}

template <int Dim>
void InterleaveCells(
  const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys, Interleaving interleaving)
{
#ifdef HASHEDOCTREE_PDEP
  if (interleaving == Interleaving::Pdep)
  {
    InterleaveWithPdep<Dim>(cells, count, keys);
    return;
  }
#endif
  static_cast<void>(interleaving);
  for (std::size_t i = 0; i < count; ++i)
  {
    keys[i] = MortonKey<Dim>::FromCell(cells[i], MortonKey<Dim>::MaxDepth);
  }
}

template <int Dim, typename Points>
Buffer<CodedPoint<Dim>> EncodePoints(Points points, const PointSelection<Dim>& selection,
  const Grid<Dim>& grid, const Execution& execution)
{
  constexpr std::size_t chunkSize = PointSelection<Dim>::ChunkSize;
  constexpr std::size_t blockSize = 128; // Cells and keys of a block stay in the first cache.
  const Interleaving interleaving = GetFastestInterleaving();
  Buffer<CodedPoint<Dim>> coded(selection.GetNumberOfPoints());

  const std::size_t numberOfChunks = (points.Count + chunkSize - 1) / chunkSize;
  execution.For(numberOfChunks, 1,
    [&](std::size_t firstChunk, std::size_t lastChunk)
    {
      std::array<Cell<Dim>, blockSize> cells;
      std::array<MortonKey<Dim>, blockSize> keys;
      std::size_t next = selection.GetFirstOfChunk(firstChunk);
      const std::size_t last = std::min(points.Count, lastChunk * chunkSize);
      for (std::size_t block = firstChunk * chunkSize; block < last; block += blockSize)
      {
        const std::size_t end = std::min(last, block + blockSize);
        std::size_t kept = 0;
        for (std::size_t i = block; i < end; ++i)
        {
          const auto x = points[i];
          if (selection.Keeps(x))
          {
            coded[next + kept].Id = static_cast<PointIndex>(i);
            cells[kept] = grid.GetCell(x);
            ++kept;
          }
        }
        InterleaveCells<Dim>(cells.data(), kept, keys.data(), interleaving);
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
  template void InterleaveCells<Dim>(                                                              \
    const Cell<Dim>*, std::size_t, MortonKey<Dim>*, Interleaving);                                 \
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
