// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceKernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#define HASHEDOCTREE_AVX2
#endif

namespace hashedoctree
{
namespace
{
// Always inlined, so that each caller compiles them for its own machine.
#define HASHEDOCTREE_INLINE __attribute__((always_inline)) inline

/** Four of a kind, in a vector register where the machine has one of that size. */
template <typename Real>
using Four __attribute__((vector_size(4 * sizeof(Real)))) = Real;

template <int Dim, typename Real>
HASHEDOCTREE_INLINE double ComputeToPoints(
  const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Four<double> least = { infinity, infinity, infinity, infinity };
  for (std::size_t i = 0; i < count; i += 4)
  {
    Four<double> sum = {};
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      Four<Real> loaded;
      std::memcpy(&loaded, coordinates + axis * stride + i, sizeof(loaded));
      const Four<double> difference = __builtin_convertvector(loaded, Four<double>) - x[axis];
      sum += difference * difference;
    }
    for (std::size_t lane = count - i; lane < 4; ++lane)
    {
      sum[lane] = infinity;
    }
    least = sum < least ? sum : least;
    std::memcpy(dist2 + i, &sum, sizeof(sum));
  }
  const double a = least[0] < least[1] ? least[0] : least[1];
  const double b = least[2] < least[3] ? least[2] : least[3];
  return a < b ? a : b;
}

template <int Dim>
HASHEDOCTREE_INLINE void ComputeToBoxes(
  const ChildBoxes<Dim>& boxes, const double* steps, float* __restrict dist2)
{
  constexpr float farthest = 1e15F; // The sum of its squares is still a float.
  constexpr float error = 1e-6F;
  float sum[MortonKey<Dim>::NumberOfOctants] = {};
  for (int axis = 0; axis < Dim; ++axis)
  {
    float t = static_cast<float>(steps[axis]);
    t = t > -farthest ? t : -farthest;
    t = t < farthest ? t : farthest;
    const float slack = 1e-3F + error * std::abs(t);
    const float below = t + slack;
    const float above = t - slack - 1.0F;
    for (int octant = 0; octant < MortonKey<Dim>::NumberOfOctants; ++octant)
    {
      const float toLower = static_cast<float>(boxes.Lower[axis][octant]) - below;
      const float toUpper = above - static_cast<float>(boxes.Upper[axis][octant]);
      float distance = toLower > toUpper ? toLower : toUpper;
      distance = distance > 0.0F ? distance : 0.0F;
      sum[octant] += distance * distance;
    }
  }
  std::copy_n(sum, MortonKey<Dim>::NumberOfOctants, dist2);
}

template <int Dim>
HASHEDOCTREE_INLINE unsigned GetMaskWithin(const float* dist2, float limit)
{
  unsigned mask = 0;
  for (unsigned octant = 0; octant < MortonKey<Dim>::NumberOfOctants; ++octant)
  {
    mask |= (dist2[octant] > limit ? 0U : 1U) << octant;
  }
  return mask;
}

template <int Dim, typename Real>
struct Plain
{
  static double ToPoints(
    const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2)
  {
    return ComputeToPoints<Dim>(coordinates, stride, count, x, dist2);
  }
  static unsigned ToBoxes(
    const ChildBoxes<Dim>& boxes, const double* steps, float limit, float* dist2)
  {
    ComputeToBoxes<Dim>(boxes, steps, dist2);
    return GetMaskWithin<Dim>(dist2, limit);
  }
};

#ifdef HASHEDOCTREE_AVX2
template <int Dim, typename Real>
struct Avx2
{
  __attribute__((target("avx2"))) static double ToPoints(
    const Real* coordinates, std::size_t stride, std::size_t count, const double* x, double* dist2)
  {
    return ComputeToPoints<Dim>(coordinates, stride, count, x, dist2);
  }
  __attribute__((target("avx2"))) static unsigned ToBoxes(
    const ChildBoxes<Dim>& boxes, const double* steps, float limit, float* dist2)
  {
    ComputeToBoxes<Dim>(boxes, steps, dist2);
    if constexpr (Dim == 3)
    {
      const __m256 isWithin =
        _mm256_cmp_ps(_mm256_loadu_ps(dist2), _mm256_set1_ps(limit), _CMP_NGT_UQ);
      return static_cast<unsigned>(_mm256_movemask_ps(isWithin));
    }
    return GetMaskWithin<Dim>(dist2, limit);
  }
};
#endif

template <int Dim, typename Real>
DistanceKernels<Dim, Real> ChooseKernels()
{
#ifdef HASHEDOCTREE_AVX2
  if (__builtin_cpu_supports("avx2"))
  {
    return { Avx2<Dim, Real>::ToPoints, Avx2<Dim, Real>::ToBoxes };
  }
#endif
  return { Plain<Dim, Real>::ToPoints, Plain<Dim, Real>::ToBoxes };
}
}

template <int Dim, typename Real>
const DistanceKernels<Dim, Real>& GetDistanceKernels()
{
  static const DistanceKernels<Dim, Real> kernels = ChooseKernels<Dim, Real>();
  return kernels;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template const DistanceKernels<Dim, float>& GetDistanceKernels();                                \
  template const DistanceKernels<Dim, double>& GetDistanceKernels();
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
