// SPDX-License-Identifier: BSD-3-Clause
#include "PointKernels.h"

#include "ForEachDimension.h"
#include "Lanes.h"
#include "PlacesOfBits.h"

#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hashedoctree
{
namespace
{
template <int Dim, typename Real>
struct PlainPoints
{
  static double MeasurePoints(
    const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2)
  {
    constexpr std::size_t width = 4;
    using Doubles = Lanes<double, width>;
    using Places = Lanes<std::int64_t, width>;
    const Doubles infinity = Doubles{} + std::numeric_limits<double>::infinity();
    Doubles least = infinity;
    Places left = Places{ 0, -1, -2, -3 } + static_cast<std::int64_t>(count);
    for (std::size_t i = 0; i < count; i += width, left -= width)
    {
      Doubles sum = {};
      for (std::size_t axis = 0; axis < Dim; ++axis)
      {
        Lanes<Real, width> loaded;
        std::memcpy(&loaded, coordinates + axis * stride + i, sizeof(loaded));
        const Doubles difference = __builtin_convertvector(loaded, Doubles) - x[axis];
        sum += difference * difference;
      }
      sum = left > 0 ? sum : infinity;
      least = sum < least ? sum : least;
      std::memcpy(dist2 + i, &sum, sizeof(sum));
    }
    const double a = least[0] < least[1] ? least[0] : least[1];
    const double b = least[2] < least[3] ? least[2] : least[3];
    return a < b ? a : b;
  }
  static std::uint64_t MeasurePointsWithin(const Real* coordinates, std::size_t stride,
    std::size_t count, const double* x, double limit, double* dist2)
  {
    return MeasurePoints(coordinates, stride, count, x, dist2) <= limit
      ? Select(dist2, count, limit)
      : 0;
  }
  static std::uint64_t Select(const double* dist2, std::size_t count, double limit)
  {
    std::uint64_t selected = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      selected |= std::uint64_t(dist2[i] <= limit ? 1 : 0) << i;
    }
    return selected;
  }
  static std::size_t CopySelected(
    const PointIndex* ids, std::size_t, std::uint64_t selected, PointIndex* to)
  {
    std::size_t size = 0;
    for (; selected != 0; selected &= selected - 1)
    {
      to[size++] = ids[__builtin_ctzll(selected)];
    }
    return size;
  }
};

#if defined(__x86_64__)
/** Ids of 32 bits, eight at a time. */
struct Avx2Ids
{
  // No loop over the bits: how often it runs is hard for the machine to foresee.
  HASHEDOCTREE_WITH_AVX2 static std::size_t CopySelected(
    const PointIndex* ids, std::size_t count, std::uint64_t selected, PointIndex* to)
  {
    PointIndex* end = to;
    const std::size_t last = (count - 1) / 8 * 8;
    for (std::size_t i = 0; i < last; i += 8)
    {
      const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(ids + i));
      end += StoreSelected(eight, static_cast<std::uint8_t>(selected >> i), end);
    }
    const __m256i places = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const __m256i left = _mm256_set1_epi32(static_cast<int>(count - last));
    const __m256i some = _mm256_maskload_epi32(
      reinterpret_cast<const int*>(ids + last), _mm256_cmpgt_epi32(left, places));
    end += StoreSelected(some, static_cast<std::uint8_t>(selected >> last), end);
    return static_cast<std::size_t>(end - to);
  }

private:
  /** Stores eight ids, those whose bits are set first, and returns how many these are. */
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static int StoreSelected(
    __m256i ids, std::uint8_t selected, PointIndex* to)
  {
    const __m256i places = _mm256_cvtepu8_epi32(_mm_loadu_si64(BitPlaces.Places[selected]));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(ids, places));
    return __builtin_popcount(selected);
  }
};

template <int Dim, typename Real>
struct Avx2Points
{
  // Not left to the compiler: GCC 12 converts floats in halves, and loads x anew for all four.
  HASHEDOCTREE_WITH_AVX2 static double MeasurePoints(
    const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2)
  {
    __m256d center[Dim];
    Spread(x, center);
    __m256d least = _mm256_set1_pd(Infinity);
    const std::size_t last = (count - 1) / 4 * 4;
    for (std::size_t i = 0; i < last; i += 4)
    {
      const __m256d sum = Sum(coordinates + i, stride, center);
      least = _mm256_min_pd(sum, least);
      _mm256_storeu_pd(dist2 + i, sum);
    }
    const __m256d sum = SumOfFirst(count - last, coordinates + last, stride, center);
    _mm256_storeu_pd(dist2 + last, sum);
    least = _mm256_min_pd(sum, least);
    const __m128d half = _mm_min_pd(_mm256_castpd256_pd128(least), _mm256_extractf128_pd(least, 1));
    return _mm_cvtsd_f64(_mm_min_sd(half, _mm_unpackhi_pd(half, half)));
  }
  // Eight at a time: how often a loop runs is hard for the machine to foresee.
  HASHEDOCTREE_WITH_AVX2 static std::uint64_t MeasurePointsWithin(const Real* coordinates,
    std::size_t stride, std::size_t count, const double* x, double limit, double* dist2)
  {
    __m256d center[Dim];
    Spread(x, center);
    const __m256d limits = _mm256_set1_pd(limit);
    std::uint64_t within = 0;
    const std::size_t last = (count - 1) / 8 * 8;
    for (std::size_t i = 0; i < last; i += 8)
    {
      const __m256d sums[] = { Sum(coordinates + i, stride, center),
        Sum(coordinates + i + 4, stride, center) };
      within |= StoreEight(sums, limits, dist2 + i) << i;
    }
    const std::size_t left = count - last;
    const __m256d sums[] = { SumOfFirst(left, coordinates + last, stride, center),
      SumOfFirst(left < 4 ? 0 : left - 4, coordinates + last + 4, stride, center) };
    within |= StoreEight(sums, limits, dist2 + last) << last;
    return within & GetFirstBits(count);
  }
  HASHEDOCTREE_WITH_AVX2 static std::uint64_t Select(
    const double* dist2, std::size_t count, double limit)
  {
    const __m256d limits = _mm256_set1_pd(limit);
    std::uint64_t selected = 0;
    for (std::size_t i = 0; i < count; i += 4)
    {
      const __m256d isWithin = _mm256_cmp_pd(_mm256_loadu_pd(dist2 + i), limits, _CMP_LE_OQ);
      selected |= static_cast<std::uint64_t>(_mm256_movemask_pd(isWithin)) << i;
    }
    return selected & GetFirstBits(count);
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  static std::uint64_t GetFirstBits(std::size_t count) { return ~std::uint64_t(0) >> (64 - count); }
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static void Spread(const double* x, __m256d* center)
  {
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      center[axis] = _mm256_set1_pd(x[axis]);
    }
  }
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static __m256d Load(const float* x)
  {
    return _mm256_cvtps_pd(_mm_loadu_ps(x));
  }
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static __m256d Load(const double* x)
  {
    return _mm256_loadu_pd(x);
  }
  /** Squared distances to four points. */
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static __m256d Sum(
    const Real* coordinates, std::size_t stride, const __m256d* center)
  {
    __m256d difference = _mm256_sub_pd(Load(coordinates), center[0]);
    __m256d sum = _mm256_mul_pd(difference, difference);
    for (std::size_t axis = 1; axis < Dim; ++axis)
    {
      difference = _mm256_sub_pd(Load(coordinates + axis * stride), center[axis]);
      sum = _mm256_add_pd(sum, _mm256_mul_pd(difference, difference));
    }
    return sum;
  }
  /** The same of the first few of them, infinity for the others. */
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static __m256d SumOfFirst(
    std::size_t count, const Real* coordinates, std::size_t stride, const __m256d* center)
  {
    const __m256d places = _mm256_setr_pd(0.0, 1.0, 2.0, 3.0);
    const __m256d isPoint =
      _mm256_cmp_pd(places, _mm256_set1_pd(static_cast<double>(count)), _CMP_LT_OQ);
    return _mm256_blendv_pd(_mm256_set1_pd(Infinity), Sum(coordinates, stride, center), isPoint);
  }
  /** Stores eight distances; bit i: whether the one in place i is not greater than a limit. */
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static std::uint64_t StoreEight(
    const __m256d* sums, __m256d limits, double* dist2)
  {
    _mm256_storeu_pd(dist2, sums[0]);
    _mm256_storeu_pd(dist2 + 4, sums[1]);
    const int low = _mm256_movemask_pd(_mm256_cmp_pd(sums[0], limits, _CMP_LE_OQ));
    const int high = _mm256_movemask_pd(_mm256_cmp_pd(sums[1], limits, _CMP_LE_OQ));
    return static_cast<std::uint64_t>(low | high << 4);
  }
};
#endif

template <int Dim, typename Real>
constexpr PointKernels<Dim, Real> PlainPointKernels = { PlainPoints<Dim, Real>::MeasurePoints,
  PlainPoints<Dim, Real>::MeasurePointsWithin, PlainPoints<Dim, Real>::Select,
  PlainPoints<Dim, Real>::CopySelected };

template <int Dim, typename Real>
PointKernels<Dim, Real> ChoosePointKernels()
{
#if defined(__x86_64__)
  if (HasAvx2())
  {
    PointKernels<Dim, Real> kernels = { Avx2Points<Dim, Real>::MeasurePoints,
      Avx2Points<Dim, Real>::MeasurePointsWithin, Avx2Points<Dim, Real>::Select,
      PlainPoints<Dim, Real>::CopySelected };
    if constexpr (sizeof(PointIndex) == sizeof(std::uint32_t))
    {
      kernels.CopySelected = Avx2Ids::CopySelected;
    }
    return kernels;
  }
#endif
  return PlainPointKernels<Dim, Real>;
}
}

template <int Dim, typename Real>
const PointKernels<Dim, Real>& GetPointKernels()
{
  static const PointKernels<Dim, Real> kernels = ChoosePointKernels<Dim, Real>();
  return kernels;
}

template <int Dim, typename Real>
const PointKernels<Dim, Real>& GetPlainPointKernels()
{
  return PlainPointKernels<Dim, Real>;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template const PointKernels<Dim, float>& GetPointKernels();                                      \
  template const PointKernels<Dim, double>& GetPointKernels();                                     \
  template const PointKernels<Dim, float>& GetPlainPointKernels();                                 \
  template const PointKernels<Dim, double>& GetPlainPointKernels();
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
