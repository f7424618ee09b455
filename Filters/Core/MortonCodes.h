// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_MortonCodes_h
#define hashedoctree_MortonCodes_h

#include "Buffer.h"
#include "PointSelection.h"

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/** How cells are interleaved into keys; both ways give the same keys. */
enum class Interleaving
{
  Dilation, ///< Shifts and masks, on any machine.
  Pdep      ///< The parallel bit deposit instruction of BMI2.
};

/** The faster one on the machine at hand, found once at run time. Pdep is not taken where it is
 * microcoded and slower than shifts (AMD before Zen 3). */
Interleaving GetFastestInterleaving();

/** Whether the machine can run Interleaving::Pdep at all. */
bool HasPdep();

/** Keys at MaxDepth of `count` cells of MaxDepth, in their order. O(count). Pdep must only be asked
 * for where HasPdep(). Instantiated for 1 to 4 dimensions. */
template <int Dim>
void InterleaveCells(
  const Cell<Dim>* cells, std::size_t count, MortonKey<Dim>* keys, Interleaving interleaving);

/** A point of a data set by its id, and its key at MaxDepth. */
template <int Dim>
struct CodedPoint
{
  MortonKey<Dim> Key;
  PointIndex Id;
};

/** The selected points with their keys, in the order of the data set. O(n). Throws Interrupted.
 * Instantiated for PointSpans of float and double, in two dimensions for PlaneSpans, too. */
template <int Dim, typename Points>
Buffer<CodedPoint<Dim>> EncodePoints(Points points, const PointSelection<Dim>& selection,
  const Grid<Dim>& grid, const Execution& execution);
}

#endif
