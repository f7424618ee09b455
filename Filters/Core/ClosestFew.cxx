// SPDX-License-Identifier: BSD-3-Clause
#include "ClosestFew.h"

#include "Lanes.h"
#include "PointKernels.h"

#include <algorithm>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hashedoctree
{
static_assert(PointKernels<3, float>::MostPoints <= RankedPoints::MostAdded,
  "the points that are measured at a time are added at a time");

bool ClosestFew::HasVectors()
{
  return HasAvx2();
}

ClosestFew::ClosestFew(std::size_t wanted, SelectPoints select, bool useVectors)
  : Wanted(wanted)
  , Select(select)
  , UseVectors(useVectors)
{
  if (this->UsesRegisters())
  {
    std::fill_n(this->Kept.Dist2, MostInRegisters, std::numeric_limits<double>::infinity());
    std::fill_n(this->Kept.Ids, MostInRegisters, nullptr);
  }
}

void ClosestFew::Add(
  const double* dist2, std::uint64_t within, const PointIndex* ids, std::size_t count)
{
  if (this->UsesRegisters())
  {
    this->AddInRegisters(dist2, within, ids, count);
    return;
  }
  if (this->UseVectors)
  {
    this->Kept.MergeWithVectors(dist2, ids, within, this->Wanted);
  }
  else
  {
    this->Kept.Merge(dist2, ids, within, this->Wanted);
  }
  this->SetBound();
}

void ClosestFew::CopyTo(std::vector<FoundPoint>& found) const
{
  found.resize(std::min(this->Kept.Size, this->Wanted));
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    found[i] = { this->Kept.Dist2[i], *this->Kept.Ids[i] };
  }
}

#if defined(__x86_64__)
namespace
{
/** No less than the eighth of the distances, infinity where there are fewer: the greatest of the
 * least of eight parts. Behind the last stands infinity until their number is a multiple of 4. */
HASHEDOCTREE_WITH_AVX2 double GetBoundOfEight(const double* dist2, std::size_t count)
{
  __m256d a = _mm256_set1_pd(std::numeric_limits<double>::infinity());
  __m256d b = a;
  for (std::size_t i = 0; i < count; i += 8)
  {
    a = _mm256_min_pd(a, _mm256_loadu_pd(dist2 + i));
    b = i + 4 < count ? _mm256_min_pd(b, _mm256_loadu_pd(dist2 + i + 4)) : b;
  }
  const __m256d four = _mm256_max_pd(a, b);
  const __m128d two = _mm_max_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
  return std::max(_mm_cvtsd_f64(two), _mm_cvtsd_f64(_mm_unpackhi_pd(two, two)));
}

/** Eight distances and, as bits of a double, the addresses of the ids. */
struct Row
{
  __m256d Dist2[2];
  __m256d Ids[2];

  HASHEDOCTREE_WITH_AVX2 void Load(const double* dist2, const PointIndex* const* ids)
  {
    for (int half = 0; half < 2; ++half)
    {
      this->Dist2[half] = _mm256_loadu_pd(dist2 + 4 * half);
      this->Ids[half] = _mm256_loadu_pd(reinterpret_cast<const double*>(ids + 4 * half));
    }
  }
  HASHEDOCTREE_WITH_AVX2 void Store(double* dist2, const PointIndex** ids) const
  {
    for (int half = 0; half < 2; ++half)
    {
      _mm256_storeu_pd(dist2 + 4 * half, this->Dist2[half]);
      _mm256_storeu_pd(reinterpret_cast<double*>(ids + 4 * half), this->Ids[half]);
    }
  }
  /** Bit i: whether the distance in place i is equal to this one. */
  HASHEDOCTREE_WITH_AVX2 unsigned GetEqual(__m256d dist2) const
  {
    const int low = _mm256_movemask_pd(_mm256_cmp_pd(this->Dist2[0], dist2, _CMP_EQ_OQ));
    const int high = _mm256_movemask_pd(_mm256_cmp_pd(this->Dist2[1], dist2, _CMP_EQ_OQ));
    return static_cast<unsigned>(low | high << 4);
  }
  /** Whether the last of some places, one at least, has a smaller id; not where it has none. */
  HASHEDOCTREE_WITH_AVX2 bool IsLastBefore(unsigned places, PointIndex id) const
  {
    double dist2[ClosestFew::MostInRegisters];
    const PointIndex* ids[ClosestFew::MostInRegisters];
    this->Store(dist2, ids);
    const PointIndex* last = ids[HighestBit(places)];
    return last != nullptr && *last < id;
  }
  /** The one before each: `first`, and then all but the last. */
  HASHEDOCTREE_WITH_AVX2 static void Shift(const __m256d* values, __m256d first, __m256d* before)
  {
    constexpr int up = 0x90;     // 0, 0, 1, 2
    constexpr int turned = 0x93; // 3, 0, 1, 2
    before[0] = _mm256_blend_pd(_mm256_permute4x64_pd(values[0], up), first, 1);
    before[1] = _mm256_blend_pd(
      _mm256_permute4x64_pd(values[1], up), _mm256_permute4x64_pd(values[0], turned), 1);
  }
  /** Behind all that are as near. What is farther moves on by one place, the last is lost. */
  HASHEDOCTREE_WITH_AVX2 void Insert(__m256d dist2, __m256d id)
  {
    __m256d dist2Before[2];
    __m256d idsBefore[2];
    Shift(this->Dist2, _mm256_set1_pd(-1.0), dist2Before);
    Shift(this->Ids, id, idsBefore);
    for (int half = 0; half < 2; ++half)
    {
      const __m256d moves = _mm256_cmp_pd(this->Dist2[half], dist2, _CMP_GT_OQ);
      const __m256d isPassed = _mm256_cmp_pd(dist2Before[half], dist2, _CMP_GT_OQ);
      this->Ids[half] =
        _mm256_blendv_pd(this->Ids[half], _mm256_blendv_pd(id, idsBefore[half], isPassed), moves);
      this->Dist2[half] = _mm256_min_pd(this->Dist2[half], _mm256_max_pd(dist2Before[half], dist2));
    }
  }
};
}

HASHEDOCTREE_WITH_AVX2 void ClosestFew::AddInRegisters(
  const double* dist2, std::uint64_t within, const PointIndex* ids, std::size_t count)
{
  if (this->Kept.Size < this->Wanted)
  {
    within = this->Select(dist2, count, GetBoundOfEight(dist2, count));
  }
  Row row;
  row.Load(this->Kept.Dist2, this->Kept.Ids);
  for (; within != 0; within &= within - 1)
  {
    const auto place = static_cast<unsigned>(__builtin_ctzll(within));
    const __m256d here = _mm256_broadcast_sd(dist2 + place);
    const unsigned equal = row.GetEqual(here);
    if (equal != 0 && !row.IsLastBefore(equal, ids[place]))
    {
      row.Store(this->Kept.Dist2, this->Kept.Ids);
      this->Kept.MergeWithVectors(dist2, ids, within, MostInRegisters);
      std::fill(this->Kept.Dist2 + this->Kept.Size, this->Kept.Dist2 + MostInRegisters,
        std::numeric_limits<double>::infinity());
      std::fill(this->Kept.Ids + this->Kept.Size, this->Kept.Ids + MostInRegisters, nullptr);
      this->SetBound();
      return;
    }
    const auto id = reinterpret_cast<std::intptr_t>(ids + place);
    row.Insert(here, _mm256_castsi256_pd(_mm256_set1_epi64x(id)));
    this->Kept.Size += this->Kept.Size < MostInRegisters ? 1 : 0;
  }
  row.Store(this->Kept.Dist2, this->Kept.Ids);
  this->SetBound();
}
#else
void ClosestFew::AddInRegisters(const double*, std::uint64_t, const PointIndex*, std::size_t) {}
#endif
}
