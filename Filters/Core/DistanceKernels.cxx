// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceKernels.h"

#include <cmath>

#if defined(__x86_64__)
#define HASHEDOCTREE_AVX2
#endif

namespace hashedoctree
{
namespace
{
// Always inlined, so that each caller compiles them for its own machine.
#define HASHEDOCTREE_INLINE __attribute__((always_inline)) inline

template <int Dim, typename Real>
HASHEDOCTREE_INLINE void ComputeToPoints(
  const Real* coordinates, std::size_t count, const double* x, double* __restrict dist2)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      const double difference = static_cast<double>(coordinates[axis * count + i]) - x[axis];
      sum += difference * difference;
    }
    dist2[i] = sum;
  }
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
  for (int octant = 0; octant < MortonKey<Dim>::NumberOfOctants; ++octant)
  {
    dist2[octant] = sum[octant];
  }
}

template <int Dim, typename Real>
struct Plain
{
  static void ToPoints(const Real* coordinates, std::size_t count, const double* x, double* dist2)
  {
    ComputeToPoints<Dim>(coordinates, count, x, dist2);
  }
  static void ToBoxes(const ChildBoxes<Dim>& boxes, const double* steps, float* dist2)
  {
    ComputeToBoxes<Dim>(boxes, steps, dist2);
  }
};

#ifdef HASHEDOCTREE_AVX2
template <int Dim, typename Real>
struct Avx2
{
  __attribute__((target("avx2"))) static void ToPoints(
    const Real* coordinates, std::size_t count, const double* x, double* dist2)
  {
    ComputeToPoints<Dim>(coordinates, count, x, dist2);
  }
  __attribute__((target("avx2"))) static void ToBoxes(
    const ChildBoxes<Dim>& boxes, const double* steps, float* dist2)
  {
    ComputeToBoxes<Dim>(boxes, steps, dist2);
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
