// SPDX-License-Identifier: BSD-3-Clause
#include "KeyedPoints.h"

#include "FirstTouch.h"
#include "ForEachDimension.h"
#include "PointKeys.h"

namespace hashedoctree
{
template <int Dim, typename Points>
Buffer<KeyedPoint<Dim>> MakeKeyedPoints(Points points, const PointSelection<Dim>& selection,
  const Grid<Dim>& grid, const Execution& execution)
{
  Buffer<KeyedPoint<Dim>> keyed(selection.GetNumberOfPoints());
  TouchPages(keyed, execution);
  execution.ForChunks(points.Count, PointSelection<Dim>::ChunkSize,
    [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      const bool keepsAll = selection.KeepsAll();
      std::array<MortonKey<Dim>, MostKeysAtOnce> keys;
      std::size_t next = selection.GetFirstOfChunk(chunk);
      for (std::size_t begin = first; begin < last; begin += MostKeysAtOnce)
      {
        const std::size_t count = std::min(last - begin, MostKeysAtOnce);
        // Those of points that do not take part have no meaning.
        GetKeys<Dim>(grid, points, begin, count, keys.data());
        for (std::size_t i = 0; i < count; ++i)
        {
          if (keepsAll || selection.Keeps(points[begin + i]))
          {
            keyed[next] = KeyedPoint<Dim>(keys[i], static_cast<PointIndex>(begin + i));
            ++next;
          }
        }
      }
    });
  return keyed;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template Buffer<KeyedPoint<Dim>> MakeKeyedPoints(                                                \
    PointSpan<Dim, float>, const PointSelection<Dim>&, const Grid<Dim>&, const Execution&);        \
  template Buffer<KeyedPoint<Dim>> MakeKeyedPoints(                                                \
    PointSpan<Dim, double>, const PointSelection<Dim>&, const Grid<Dim>&, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
template Buffer<KeyedPoint<2>> MakeKeyedPoints(
  PlaneSpan<float>, const PointSelection<2>&, const Grid<2>&, const Execution&);
template Buffer<KeyedPoint<2>> MakeKeyedPoints(
  PlaneSpan<double>, const PointSelection<2>&, const Grid<2>&, const Execution&);
}
