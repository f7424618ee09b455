// SPDX-License-Identifier: BSD-3-Clause
#include "BoxKernels.h"

#include "ForEachDimension.h"
#include "Lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hashedoctree
{
namespace
{
/** How many octants are done at a time: all, or as many as fill a vector. */
template <int Dim, typename T>
constexpr std::size_t SomeOctants = std::min<std::size_t>(
  MortonKey<Dim>::NumberOfOctants, 32 / sizeof(T));
/** A number for each of them. */
template <int Dim, typename T>
using OfOctants = Lanes<T, SomeOctants<Dim, T>>;

/** More than rounding adds up to on one axis: of a float at the farthest place. */
HASHEDOCTREE_INLINE float GetSlack(float)
{
  return 0.01F;
}
HASHEDOCTREE_INLINE double GetSlack(double t)
{
  return 1e-3 + 4e-15 * std::abs(t);
}

/** Squared distances to boxes from `lower` to `upper`. */
template <int Dim, typename T>
HASHEDOCTREE_INLINE void ComputeBoxes(const OfOctants<Dim, T>* lower,
  const OfOctants<Dim, T>* upper, const double* steps, OfOctants<Dim, T>& dist2)
{
  const OfOctants<Dim, T> zero = {};
  dist2 = zero;
  for (int axis = 0; axis < Dim; ++axis)
  {
    const auto t = static_cast<T>(steps[axis]);
    const T slack = GetSlack(t);
    const OfOctants<Dim, T> toLower = lower[axis] - (t + slack);
    const OfOctants<Dim, T> toUpper = (t - (slack + T(1))) - upper[axis];
    OfOctants<Dim, T> distance = toLower > toUpper ? toLower : toUpper;
    distance = distance > zero ? distance : zero;
    dist2 += distance * distance;
  }
}

/** Squared distances to the farthest corners of boxes from `lower` to `upper`. */
template <int Dim, typename T>
HASHEDOCTREE_INLINE void ComputeToFarthest(const OfOctants<Dim, T>* lower,
  const OfOctants<Dim, T>* upper, const double* steps, OfOctants<Dim, T>& dist2)
{
  dist2 = OfOctants<Dim, T>{};
  for (int axis = 0; axis < Dim; ++axis)
  {
    const auto t = static_cast<T>(steps[axis]);
    const T slack = GetSlack(t);
    const OfOctants<Dim, T> fromLower = (t + slack) - lower[axis];
    const OfOctants<Dim, T> fromUpper = upper[axis] - (t - (slack + T(1)));
    const OfOctants<Dim, T> distance = fromLower > fromUpper ? fromLower : fromUpper;
    dist2 += distance * distance;
  }
}

/** What measures the boxes of some octants: one of these. */
template <int Dim, typename T>
using ComputeOf = void (*)(
  const OfOctants<Dim, T>*, const OfOctants<Dim, T>*, const double*, OfOctants<Dim, T>&);

template <int Dim>
struct PlainBoxes
{
  template <typename T>
  static unsigned MeasureBoxes(const ChildBoxes<Dim>& boxes, const double* steps, T limit, T* dist2)
  {
    unsigned mask = 0;
    ForOctants<T, ComputeBoxes<Dim, T>>(boxes, steps,
      [&](unsigned octant, T here)
      {
        dist2[octant] = here;
        mask |= (here > limit ? 0U : 1U) << octant;
      });
    return mask;
  }
  template <typename T>
  static unsigned SelectWholeBoxes(const ChildBoxes<Dim>& boxes, const double* steps, T limit)
  {
    unsigned mask = 0;
    ForOctants<T, ComputeToFarthest<Dim, T>>(
      boxes, steps, [&](unsigned octant, T here) { mask |= (here < limit ? 1U : 0U) << octant; });
    return mask;
  }
  static float MeasureFarthestCorner(
    const ChildBoxes<Dim>& boxes, const double* steps, unsigned octants)
  {
    float least = std::numeric_limits<float>::infinity();
    ForOctants<float, ComputeToFarthest<Dim, float>>(boxes, steps,
      [&](unsigned octant, float here)
      {
        const bool counts = (octants >> octant & 1U) != 0;
        least = counts && here < least ? here : least;
      });
    return least;
  }

private:
  template <typename T>
  HASHEDOCTREE_INLINE static void Load(const std::uint8_t* steps, OfOctants<Dim, T>& loaded)
  {
    // GCC warns of a vector without a value, though each of its numbers gets one.
    OfOctants<Dim, T> some = {};
    for (std::size_t i = 0; i < SomeOctants<Dim, T>; ++i)
    {
      some[i] = steps[i];
    }
    loaded = some;
  }

  /** Calls function(octant, dist2) for the box of each octant. */
  template <typename T, ComputeOf<Dim, T> Measure, typename Function>
  static void ForOctants(
    const ChildBoxes<Dim>& boxes, const double* steps, const Function& function)
  {
    constexpr std::size_t width = SomeOctants<Dim, T>;
    for (std::size_t first = 0; first < MortonKey<Dim>::NumberOfOctants; first += width)
    {
      OfOctants<Dim, T> lower[Dim];
      OfOctants<Dim, T> upper[Dim];
      for (int axis = 0; axis < Dim; ++axis)
      {
        Load<T>(boxes.Lower[axis] + first, lower[axis]);
        Load<T>(boxes.Upper[axis] + first, upper[axis]);
      }
      OfOctants<Dim, T> some;
      Measure(lower, upper, steps, some);
      for (std::size_t i = 0; i < width; ++i)
      {
        function(static_cast<unsigned>(first + i), some[i]);
      }
    }
  }
};

#if defined(__x86_64__)
/** In three dimensions, where the octants fill vectors. */
struct Avx2Boxes
{
  HASHEDOCTREE_WITH_AVX2 static unsigned MeasureBoxes(
    const ChildBoxes<3>& boxes, const double* steps, float limit, float* dist2)
  {
    OfOctants<3, float> lower[3];
    OfOctants<3, float> upper[3];
    Convert(boxes, lower, upper);
    OfOctants<3, float> all;
    ComputeBoxes<3, float>(lower, upper, steps, all);
    _mm256_storeu_ps(dist2, all);
    const __m256 isWithin = _mm256_cmp_ps(all, _mm256_set1_ps(limit), _CMP_NGT_UQ);
    return static_cast<unsigned>(_mm256_movemask_ps(isWithin));
  }
  HASHEDOCTREE_WITH_AVX2 static unsigned MeasureBoxesFromAfar(
    const ChildBoxes<3>& boxes, const double* steps, double limit, double* dist2)
  {
    OfOctants<3, double> all[2];
    MeasureFromAfar<ComputeBoxes<3, double>>(boxes, steps, all);
    _mm256_storeu_pd(dist2, all[0]);
    _mm256_storeu_pd(dist2 + 4, all[1]);
    const __m256d limits = _mm256_set1_pd(limit);
    return GetMask(
      _mm256_cmp_pd(all[0], limits, _CMP_NGT_UQ), _mm256_cmp_pd(all[1], limits, _CMP_NGT_UQ));
  }
  HASHEDOCTREE_WITH_AVX2 static unsigned SelectWholeBoxesFromAfar(
    const ChildBoxes<3>& boxes, const double* steps, double limit)
  {
    OfOctants<3, double> all[2];
    MeasureFromAfar<ComputeToFarthest<3, double>>(boxes, steps, all);
    const __m256d limits = _mm256_set1_pd(limit);
    return GetMask(
      _mm256_cmp_pd(all[0], limits, _CMP_LT_OQ), _mm256_cmp_pd(all[1], limits, _CMP_LT_OQ));
  }
  HASHEDOCTREE_WITH_AVX2 static unsigned SelectWholeBoxes(
    const ChildBoxes<3>& boxes, const double* steps, float limit)
  {
    const __m256 isWhole =
      _mm256_cmp_ps(MeasureFarthest(boxes, steps), _mm256_set1_ps(limit), _CMP_LT_OQ);
    return static_cast<unsigned>(_mm256_movemask_ps(isWhole));
  }
  HASHEDOCTREE_WITH_AVX2 static float MeasureFarthestCorner(
    const ChildBoxes<3>& boxes, const double* steps, unsigned octants)
  {
    __m256 all = MeasureFarthest(boxes, steps);
    const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i chosen = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(octants)), bits);
    all = _mm256_blendv_ps(_mm256_set1_ps(std::numeric_limits<float>::infinity()), all,
      _mm256_castsi256_ps(_mm256_cmpeq_epi32(chosen, bits)));
    const __m128 four = _mm_min_ps(_mm256_castps256_ps128(all), _mm256_extractf128_ps(all, 1));
    const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)));
  }

private:
  /** Squared distances to the farthest corners. */
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static __m256 MeasureFarthest(
    const ChildBoxes<3>& boxes, const double* steps)
  {
    OfOctants<3, float> lower[3];
    OfOctants<3, float> upper[3];
    Convert(boxes, lower, upper);
    OfOctants<3, float> all;
    ComputeToFarthest<3, float>(lower, upper, steps, all);
    return all;
  }
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static void Convert(
    const ChildBoxes<3>& boxes, OfOctants<3, float>* lower, OfOctants<3, float>* upper)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadu_si64(boxes.Lower[axis])));
      upper[axis] = _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadu_si64(boxes.Upper[axis])));
    }
  }
  /** Squared distances of the boxes of all octants, four at a time. */
  template <ComputeOf<3, double> Measure>
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static void MeasureFromAfar(
    const ChildBoxes<3>& boxes, const double* steps, OfOctants<3, double>* all)
  {
    for (unsigned first = 0; first < MortonKey<3>::NumberOfOctants; first += 4)
    {
      OfOctants<3, double> lower[3];
      OfOctants<3, double> upper[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        lower[axis] =
          _mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_loadu_si32(boxes.Lower[axis] + first)));
        upper[axis] =
          _mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_loadu_si32(boxes.Upper[axis] + first)));
      }
      Measure(lower, upper, steps, all[first / 4]);
    }
  }
  HASHEDOCTREE_WITH_AVX2 HASHEDOCTREE_INLINE static unsigned GetMask(__m256d low, __m256d high)
  {
    return static_cast<unsigned>(_mm256_movemask_pd(low) | _mm256_movemask_pd(high) << 4);
  }
};
#endif

template <int Dim>
constexpr BoxKernels<Dim> PlainBoxKernels = { PlainBoxes<Dim>::template MeasureBoxes<float>,
  PlainBoxes<Dim>::template MeasureBoxes<double>, PlainBoxes<Dim>::template SelectWholeBoxes<float>,
  PlainBoxes<Dim>::template SelectWholeBoxes<double>, PlainBoxes<Dim>::MeasureFarthestCorner };

template <int Dim>
BoxKernels<Dim> ChooseBoxKernels()
{
#if defined(__x86_64__)
  if constexpr (Dim == 3)
  {
    if (HasAvx2())
    {
      return { Avx2Boxes::MeasureBoxes, Avx2Boxes::MeasureBoxesFromAfar,
        Avx2Boxes::SelectWholeBoxes, Avx2Boxes::SelectWholeBoxesFromAfar,
        Avx2Boxes::MeasureFarthestCorner };
    }
  }
#endif
  return PlainBoxKernels<Dim>;
}
}

template <int Dim>
const BoxKernels<Dim>& GetBoxKernels()
{
  static const BoxKernels<Dim> kernels = ChooseBoxKernels<Dim>();
  return kernels;
}

template <int Dim>
const BoxKernels<Dim>& GetPlainBoxKernels()
{
  return PlainBoxKernels<Dim>;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template const BoxKernels<Dim>& GetBoxKernels();                                                 \
  template const BoxKernels<Dim>& GetPlainBoxKernels();
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
