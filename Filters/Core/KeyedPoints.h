// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_KeyedPoints_h
#define hashedoctree_KeyedPoints_h

#include "Buffer.h"
#include "PointIndex.h"
#include "PointSelection.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace hashedoctree
{
/** A point of a data set by its id, and its key at MaxDepth. Sorting moves all of them several
 * times, so nothing is between one and the next: where an id has 32 bits, the key is aligned as it.
 */
template <int Dim>
class KeyedPoint
{
public:
  /** A variable without initialiser holds nothing yet, as with MortonKey. */
  KeyedPoint() = default;
  KeyedPoint(MortonKey<Dim> key, PointIndex id)
    : Id(id)
  {
    const std::uint64_t value = key.GetValue();
    std::memcpy(this->KeyHalves.data(), &value, sizeof(value));
  }

  MortonKey<Dim> GetKey() const
  {
    std::uint64_t value = 0;
    std::memcpy(&value, this->KeyHalves.data(), sizeof(value));
    return MortonKey<Dim>(value);
  }
  PointIndex GetId() const { return this->Id; }

private:
  std::array<std::uint32_t, 2> KeyHalves;
  PointIndex Id;
};

/** Points that are known by their keys, from the first on. Throws Interrupted, and
 * std::length_error for more than ids can tell apart. */
template <int Dim>
Buffer<KeyedPoint<Dim>> NumberKeys(
  const std::vector<MortonKey<Dim>>& keys, const Execution& execution)
{
  constexpr std::size_t grain = 4096; // Keys that a thread numbers at a time.
  RequirePointIndices(keys.size());
  Buffer<KeyedPoint<Dim>> keyed(keys.size());
  execution.ForEach(keys.size(), grain,
    [&](std::size_t i) { keyed[i] = KeyedPoint<Dim>(keys[i], static_cast<PointIndex>(i)); });
  return keyed;
}

/** The selected points with their keys, in the order of the data set. O(n). Throws Interrupted.
 * Instantiated for PointSpans of float and double, in two dimensions for PlaneSpans, too. */
template <int Dim, typename Points>
Buffer<KeyedPoint<Dim>> MakeKeyedPoints(Points points, const PointSelection<Dim>& selection,
  const Grid<Dim>& grid, const Execution& execution);
}

#endif
