// SPDX-License-Identifier: BSD-3-Clause
#include "GridCells.h"

#include "ForEachDimension.h"
#include "Lanes.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <array>
#include <cmath>
#include <cstring>

namespace hashedoctree
{
namespace
{
constexpr std::size_t Width = 4; // Coordinates at a time.
using Doubles = Lanes<double, Width>;

/** For each coordinate of Width positions as they stand, of whatever axis, the one of the lower
 * corner of the grid. */
template <int Dim>
std::array<double, Dim * Width> RepeatLower(const Grid<Dim>& grid)
{
  std::array<double, Dim * Width> lower;
  for (std::size_t i = 0; i < lower.size(); ++i)
  {
    lower[i] = grid.GetLower()[i % Dim];
  }
  return lower;
}

/** Of `count` positions, a multiple of Width. */
template <int Dim, typename Real>
void ComputeCells(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  constexpr double size = MortonKey<Dim>::CellsPerSide;
  const Doubles zero = {};
  const Doubles last = zero + (size - 1.0);
  const Doubles side = zero + grid.GetSide();
  Doubles lower[Dim];
  std::memcpy(lower, RepeatLower<Dim>(grid).data(), sizeof(lower));
  for (std::size_t done = 0; done < count; done += Width)
  {
    for (std::size_t i = 0; i < Dim; ++i)
    {
      Lanes<Real, Width> x;
      std::memcpy(&x, coordinates + Dim * done + Width * i, sizeof(x));
      Doubles t = (__builtin_convertvector(x, Doubles) - lower[i]) / side * size;
      t = t > zero ? t : zero;
      t = t < last ? t : last;
      const auto cell = __builtin_convertvector(t, Lanes<std::int32_t, Width>); // Never negative.
      std::memcpy(cells[done].data() + Width * i, &cell, sizeof(cell));
    }
  }
}

#if defined(__x86_64__)
// Between these sides no product that tells cells apart is too small or too large to be exact.
constexpr double LeastSideOfProducts = 0x1p-800;
constexpr double MostSideOfProducts = 0x1p+800;

HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE __m256d Load(const double* x)
{
  return _mm256_loadu_pd(x);
}
HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE __m256d Load(const float* x)
{
  return _mm256_cvtps_pd(_mm_loadu_ps(x));
}

/** The same in half the time: of t / side, the product with the inverse and then two fused products
 * give the quotient, rounded to nearest as a division rounds it (Brisebarre, Muller and Raina 2004,
 * doi 10.1109/TC.2004.37). */
template <int Dim, typename Real>
HASHEDOCTREE_WITH_AVX2 void ComputeCellsByProducts(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  const __m256d size = _mm256_set1_pd(MortonKey<Dim>::CellsPerSide);
  const __m256d zero = _mm256_setzero_pd();
  const __m256d side = _mm256_set1_pd(grid.GetSide());
  const __m256d last = _mm256_set1_pd(std::nextafter(grid.GetSide(), 0.0)); // In the last cell.
  const __m256d inverse = _mm256_set1_pd(1.0 / grid.GetSide());
  __m256d lower[Dim];
  std::memcpy(lower, RepeatLower<Dim>(grid).data(), sizeof(lower));
  for (std::size_t done = 0; done < count; done += Width)
  {
    for (std::size_t i = 0; i < Dim; ++i)
    {
      __m256d t = _mm256_sub_pd(Load(coordinates + Dim * done + Width * i), lower[i]);
      t = _mm256_min_pd(_mm256_max_pd(t, zero), last); // What is no number becomes 0.
      const __m256d product = _mm256_mul_pd(t, inverse);
      const __m256d rest = _mm256_fnmadd_pd(product, side, t);
      const __m256d quotient = _mm256_fmadd_pd(rest, inverse, product);
      const __m128i cell = _mm256_cvttpd_epi32(_mm256_mul_pd(quotient, size));
      std::memcpy(cells[done].data() + Width * i, &cell, sizeof(cell));
    }
  }
}
#endif

/** The last positions, fewer than Width, one by one; returns how many are before them. */
template <int Dim, typename Real>
std::size_t ComputeLastCells(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  const std::size_t before = count - count % Width;
  for (std::size_t i = before; i < count; ++i)
  {
    cells[i] = grid.GetCell(coordinates + Dim * i);
  }
  return before;
}
}

template <int Dim, typename Real>
void GetCells(const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
#if defined(__x86_64__)
  const double side = grid.GetSide();
  const bool roundsToNearest = _MM_GET_ROUNDING_MODE() == _MM_ROUND_NEAREST;
  if (HasAvx2() && roundsToNearest && LeastSideOfProducts <= side && side <= MostSideOfProducts)
  {
    const std::size_t before = ComputeLastCells<Dim>(grid, coordinates, count, cells);
    ComputeCellsByProducts<Dim>(grid, coordinates, before, cells);
    return;
  }
#endif
  GetCellsPlainly<Dim>(grid, coordinates, count, cells);
}

template <int Dim, typename Real>
void GetCellsPlainly(
  const Grid<Dim>& grid, const Real* coordinates, std::size_t count, Cell<Dim>* cells)
{
  const std::size_t before = ComputeLastCells<Dim>(grid, coordinates, count, cells);
  ComputeCells<Dim>(grid, coordinates, before, cells);
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void GetCells<Dim>(const Grid<Dim>&, const float*, std::size_t, Cell<Dim>*);            \
  template void GetCells<Dim>(const Grid<Dim>&, const double*, std::size_t, Cell<Dim>*);           \
  template void GetCellsPlainly<Dim>(const Grid<Dim>&, const float*, std::size_t, Cell<Dim>*);     \
  template void GetCellsPlainly<Dim>(const Grid<Dim>&, const double*, std::size_t, Cell<Dim>*);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
