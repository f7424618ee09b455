// SPDX-License-Identifier: BSD-3-Clause
#include "MortonOrder.h"

#include "FirstTouch.h"
#include "ForEachDimension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace hashedoctree
{
namespace
{
constexpr int MostDigitBits = 9; // 512 counters stay in the first cache.
constexpr std::size_t MostDigits = std::size_t(1) << MostDigitBits;
constexpr int MostSparseDigitBits = 12;        // Where points have no more than 512 of them.
constexpr std::size_t SampleSize = 1024;       // Points that tell whether it is so.
constexpr std::size_t InsertionLimit = 32;     // Up to here insertion beats counting digits.
constexpr std::size_t SerialLimit = 32768;     // Up to here one thread sorts a node on its own,
constexpr std::size_t SerialShare = 16;        // and up to this part of all points,
constexpr std::size_t MostSerial = 262144;     // but not more: a stop would have to wait.
constexpr std::size_t ChunkSize = 16384;       // Points that a thread partitions at a time,
constexpr std::size_t LeastOfDigit = 8;        // but at least so many for each counter.
constexpr PointIndex PlacesAhead = 8;          // Places of a digit that are on the way,
constexpr std::size_t MostInFirstCache = 1024; // with more points than these.

using DigitCounts = std::array<PointIndex, MostDigits>;

/** The octants that lead from a node to one of its descendants, as one number. */
template <int Dim>
class Digit
{
public:
  static constexpr int MostDepths = MostDigitBits / Dim;
  static constexpr int MostSparseDepths = MostSparseDigitBits / Dim;

  /** Of the nodes `depths` below a node at `depth`. */
  Digit(int depth, int depths)
    : Shift(Dim * (MortonKey<Dim>::MaxDepth - depth - depths))
    , Count(std::size_t(1) << (Dim * depths))
  {
  }

  std::size_t GetCount() const { return this->Count; }
  std::size_t Of(const KeyedPoint<Dim>& point) const
  {
    return point.GetKey().GetValue() >> this->Shift & (this->Count - 1);
  }

private:
  int Shift;
  std::size_t Count;
};

template <int Dim>
class Sorter
{
public:
  Sorter(Buffer<KeyedPoint<Dim>>& points, std::size_t maxPointsPerLeaf, int maxDepth,
    const Execution& execution, SpareMemory spare)
    : Points(points)
    , Scratch(FindRoom(points.GetSize(), spare, this->OwnScratch))
    , MaxPointsPerLeaf(maxPointsPerLeaf)
    , MaxDepth(maxDepth)
    , Threads(execution)
  {
  }

  void Sort()
  {
    if (this->AreInOrder())
    {
      this->Threads.Tell(1.0);
      return;
    }
    TouchPages(this->Scratch, this->Points.GetSize(), this->Threads);
    const std::size_t limit =
      std::clamp(this->Points.GetSize() / SerialShare, SerialLimit, MostSerial);
    std::vector<Range> large{ Range{ 0, this->Points.GetSize(), 0, false, Dim } };
    std::vector<Range> small;
    while (!large.empty())
    {
      const Range range = large.back();
      large.pop_back();
      if (range.Last - range.First <= limit || this->IsLeaf(range.Last - range.First, range.Depth))
      {
        small.push_back(range);
      }
      else
      {
        this->Partition(range, large);
      }
    }
    this->SortSerially(small);
  }

private:
  using Point = KeyedPoint<Dim>;

  /** One number for each digit of the points in each half of a range. Of points in rows many after
   * each other have the same digit, and each count waits for the one before; so they are taken by
   * twos, one of each half. */
  struct Counters
  {
    PointIndex* FirstHalf;
    PointIndex* SecondHalf;
  };

  /** The points [First, Last) of a node at Depth, in Scratch or in Points; Branching as far as it
   * is known from above. */
  struct Range
  {
    std::size_t First;
    std::size_t Last;
    int Depth;
    bool InScratch;
    double Branching;
  };

  /** Whether all points come sorted. Compares them up to the first that does not. */
  bool AreInOrder() const
  {
    const auto isBefore = [](const Point& a, const Point& b) { return a.GetKey() < b.GetKey(); };
    const Point* points = this->Points.GetData();
    bool areInOrder = true;
    this->Threads.Part(0.0, 0.0).OnOneThread().ForChunks(this->Points.GetSize(), ChunkSize,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        const std::size_t before = first == 0 ? 0 : first - 1;
        areInOrder = areInOrder && std::is_sorted(points + before, points + last, isBefore);
      });
    return areInOrder;
  }

  bool IsLeaf(std::size_t count, int depth) const
  {
    return count <= this->MaxPointsPerLeaf || depth >= this->MaxDepth;
  }

  /** How many depths, up to a number, to part the points of a node by at once: as many as would
   * make leaves of points that are spread evenly over 2^branching children at each depth. */
  int GetDepths(std::size_t count, int depth, double branching, int most) const
  {
    most = std::min(most, this->MaxDepth - depth);
    int depths = 1;
    while (depths < most && count >> static_cast<int>(branching * depths) > this->MaxPointsPerLeaf)
    {
      ++depths;
    }
    return depths;
  }

  /** The branching of the points of a large node below it, measured on some of them. */
  static double EstimateBranching(const Point* points, std::size_t count, int depth)
  {
    const int depths = std::min(Digit<Dim>::MostSparseDepths, MortonKey<Dim>::MaxDepth - depth);
    const Digit<Dim> digit(depth, depths);
    std::array<std::size_t, SampleSize> digits;
    for (std::size_t i = 0; i < SampleSize; ++i)
    {
      digits[i] = digit.Of(points[count / SampleSize * i]);
    }
    std::sort(digits.begin(), digits.end());
    const auto end = std::unique(digits.begin(), digits.end());
    return GetBranching(static_cast<std::size_t>(end - digits.begin()), depths);
  }

  /** Of points that have so many descendants of a node, `depths` below it. */
  static double GetBranching(std::size_t occupied, int depths)
  {
    return std::max(1.0, std::log2(occupied) / depths);
  }

  Point* Data(bool scratch) { return scratch ? this->Scratch : this->Points.GetData(); }

  /** By how many depths to part the points of a large node at once, all threads together: counters
   * in the first cache, as all are or, where points branch little, as those in use are. */
  int GetSharedDepths(const Point* points, std::size_t count, int depth) const
  {
    const double branching = EstimateBranching(points, count, depth);
    const int most = std::clamp(static_cast<int>(MostDigitBits / branching), Digit<Dim>::MostDepths,
      Digit<Dim>::MostSparseDepths);
    return this->GetDepths(count, depth, branching, most);
  }

  /** Splits a range by one digit, all threads together, and appends what has to be sorted yet, the
   * last first: ranges are taken from the end, and sorted in the order in which they lie (by the
   * thread that wrote them, in a ThreadTeam). */
  void Partition(const Range& range, std::vector<Range>& rest)
  {
    const Point* from = this->Data(range.InScratch) + range.First;
    const std::size_t count = range.Last - range.First;
    const int depths = this->GetSharedDepths(from, count, range.Depth);
    const Digit<Dim> digit(range.Depth, depths);
    const std::size_t digits = digit.GetCount();
    const std::size_t chunkSize = std::max(ChunkSize, LeastOfDigit * digits);

    std::vector<PointIndex> counts(2 * digits * Execution::GetNumberOfChunks(count, chunkSize));
    const auto getCounters = [&](std::size_t chunk) {
      return Counters{ &counts[2 * chunk * digits], &counts[(2 * chunk + 1) * digits] };
    };
    this->ForChunks(count, chunkSize,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      { CountDigits(from + first, last - first, digit, getCounters(chunk)); });
    const std::vector<std::size_t> starts = FindPlaces(counts, digits);

    const std::size_t firstDigit = digit.Of(from[0]);
    if (starts[firstDigit + 1] - starts[firstDigit] == count)
    {
      rest.push_back(
        Range{ range.First, range.Last, this->FindCommonDepth(from, count), range.InScratch, Dim });
      return;
    }

    Point* to = this->Data(!range.InScratch) + range.First;
    this->ForChunks(count, chunkSize,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      { Scatter(from + first, last - first, digit, getCounters(chunk), to); });
    std::size_t occupied = 0;
    for (std::size_t i = 0; i < digits; ++i)
    {
      occupied += starts[i] != starts[i + 1] ? 1 : 0;
    }
    const double branching = GetBranching(occupied, depths);
    for (std::size_t i = digits; i-- > 0;)
    {
      if (starts[i] != starts[i + 1])
      {
        rest.push_back(Range{ range.First + starts[i], range.First + starts[i + 1],
          range.Depth + depths, !range.InScratch, branching });
      }
    }
  }

  static void CountDigits(
    const Point* from, std::size_t count, const Digit<Dim>& digit, const Counters& counts)
  {
    const std::size_t half = count / 2;
    for (std::size_t i = 0; i < half; ++i)
    {
      ++counts.FirstHalf[digit.Of(from[i])];
      ++counts.SecondHalf[digit.Of(from[half + i])];
    }
    if (count % 2 != 0)
    {
      ++counts.SecondHalf[digit.Of(from[count - 1])];
    }
  }

  /** Of each digit the place of its first point, and one past the last; `counts` of half after half
   * of the chunks become the places where each of them puts its first one. */
  static std::vector<std::size_t> FindPlaces(std::vector<PointIndex>& counts, std::size_t digits)
  {
    const auto step = static_cast<std::ptrdiff_t>(digits);
    std::vector<PointIndex> next(digits);
    for (auto chunk = counts.begin(); chunk != counts.end(); chunk += step)
    {
      std::transform(chunk, chunk + step, next.begin(), next.begin(), std::plus<>());
    }
    std::vector<std::size_t> starts(1 + digits);
    PointIndex sum = 0;
    for (std::size_t digit = 0; digit < digits; ++digit)
    {
      starts[digit] = sum;
      sum += std::exchange(next[digit], sum);
    }
    starts[digits] = sum;
    for (auto chunk = counts.begin(); chunk != counts.end(); chunk += step)
    {
      for (std::size_t digit = 0; digit < digits; ++digit)
      {
        next[digit] += std::exchange(chunk[static_cast<std::ptrdiff_t>(digit)], next[digit]);
      }
    }
    return starts;
  }

  /** The depth of the deepest node that holds all of some points. */
  int FindCommonDepth(const Point* points, std::size_t count)
  {
    const MortonKey<Dim> key = points[0].GetKey();
    const auto differences = this->Threads.Part(0.0, 0.0).MapChunks(count, ChunkSize,
      [&](std::size_t first, std::size_t last)
      {
        std::uint64_t here = 0;
        for (std::size_t i = first; i < last; ++i)
        {
          here |= points[i].GetKey().GetValue() ^ key.GetValue();
        }
        return here;
      });
    std::uint64_t all = 0;
    for (const std::uint64_t difference : differences)
    {
      all |= difference;
    }
    return MortonKey<Dim>::GetCommonDepth(key, MortonKey<Dim>(key.GetValue() ^ all));
  }

  /** Copies points to the places of their digits, which move on. */
  static void Scatter(const Point* from, std::size_t count, const Digit<Dim>& digit,
    const Counters& places, Point* to)
  {
    const bool asksAhead = count > MostInFirstCache;
    const std::size_t half = count / 2;
    for (std::size_t i = 0; i < half; ++i)
    {
      const PointIndex first = places.FirstHalf[digit.Of(from[i])]++;
      const PointIndex second = places.SecondHalf[digit.Of(from[half + i])]++;
      to[first] = from[i];
      to[second] = from[half + i];
      if (asksAhead)
      {
        __builtin_prefetch(&to[first + PlacesAhead], 1);
        __builtin_prefetch(&to[second + PlacesAhead], 1);
      }
    }
    if (count % 2 != 0)
    {
      to[places.SecondHalf[digit.Of(from[count - 1])]++] = from[count - 1];
    }
  }

  template <typename Function>
  void ForChunks(std::size_t count, std::size_t chunkSize, const Function& function)
  {
    // Progress stands still here: how many partitions follow is known only after them.
    this->Threads.Part(0.0, 0.0).ForChunks(count, chunkSize, function);
  }

  /** Sorts ranges into Points, each on one thread; short ones share a task. */
  void SortSerially(const std::vector<Range>& ranges)
  {
    std::vector<std::size_t> tasks(1, 0);
    std::size_t pending = 0;
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      pending += ranges[i].Last - ranges[i].First;
      if (pending >= ChunkSize)
      {
        tasks.push_back(i + 1);
        pending = 0;
      }
    }
    tasks.push_back(ranges.size());
    this->Threads.For(tasks.size() - 1, 1,
      [&](std::size_t firstTask, std::size_t lastTask)
      {
        for (std::size_t i = tasks[firstTask]; i < tasks[lastTask]; ++i)
        {
          const Range& range = ranges[i];
          this->SortOne(this->Data(range.InScratch) + range.First,
            this->Data(!range.InScratch) + range.First, range.Last - range.First, range.Depth,
            range.InScratch, range.Branching);
        }
      });
  }

  /** Sorts the points `from` of a node, with `other` as scratch of the same length; the result ends
   * in `other` when asked for, else in `from`. `branching` as far as it is known from above: Dim
   * for points that fill the space, 2 on surfaces, 1 along curves. */
  void SortOne(
    Point* from, Point* other, std::size_t count, int depth, bool intoOther, double branching) const
  {
    DigitCounts first;
    DigitCounts second;
    const Counters counts{ first.data(), second.data() };
    int depths = 0;
    do
    {
      depth += depths;
      const bool isLeaf = this->IsLeaf(count, depth);
      if (isLeaf || count <= InsertionLimit)
      {
        if (!isLeaf)
        {
          SortByInsertion(from, count);
        }
        if (intoOther)
        {
          std::copy(from, from + count, other);
        }
        return;
      }
      depths = this->GetDepths(count, depth, branching, Digit<Dim>::MostDepths);
    } while (!IsDivided(from, count, Digit<Dim>(depth, depths), counts));

    const Digit<Dim> digit(depth, depths);
    const double below = GetBranching(CountsToPlaces(counts, digit.GetCount()), depths);
    Scatter(from, count, digit, counts, other);
    PointIndex begin = 0;
    for (std::size_t i = 0; i < digit.GetCount(); ++i)
    {
      const PointIndex end = second[i]; // Those of the second half come last.
      if (end != begin)
      {
        this->SortOne(other + begin, from + begin, end - begin, depth + depths, !intoOther, below);
      }
      begin = end;
    }
  }

  /** Whether points have more than one digit; counts them. */
  static bool IsDivided(
    const Point* points, std::size_t count, const Digit<Dim>& digit, const Counters& counts)
  {
    std::fill_n(counts.FirstHalf, digit.GetCount(), 0);
    std::fill_n(counts.SecondHalf, digit.GetCount(), 0);
    CountDigits(points, count, digit, counts);
    const std::size_t first = digit.Of(points[0]);
    return counts.FirstHalf[first] + counts.SecondHalf[first] != count;
  }

  /** Replaces the counts of each digit by the places where each half puts its first point of it;
   * returns how many digits have points. */
  static std::size_t CountsToPlaces(const Counters& counts, std::size_t digits)
  {
    PointIndex sum = 0;
    std::size_t occupied = 0;
    for (std::size_t digit = 0; digit < digits; ++digit)
    {
      const PointIndex before = sum;
      sum += std::exchange(counts.FirstHalf[digit], sum);
      sum += std::exchange(counts.SecondHalf[digit], sum);
      occupied += sum != before ? 1 : 0;
    }
    return occupied;
  }

  static void SortByInsertion(Point* points, std::size_t count)
  {
    for (std::size_t i = 1; i < count; ++i)
    {
      const Point point = points[i];
      std::size_t place = i;
      for (; place > 0 && point.GetKey() < points[place - 1].GetKey(); --place)
      {
        points[place] = points[place - 1];
      }
      points[place] = point;
    }
  }

  Buffer<Point> OwnScratch; // Before Scratch, which may stand in it.
  Buffer<Point>& Points;
  Point* Scratch;
  std::size_t MaxPointsPerLeaf;
  int MaxDepth;
  const Execution& Threads;
};
}

template <int Dim>
void SortAlongMortonCurve(Buffer<KeyedPoint<Dim>>& points, std::size_t maxPointsPerLeaf,
  int maxDepth, const Execution& execution, SpareMemory spare)
{
  Sorter<Dim>(points, maxPointsPerLeaf, maxDepth, execution, spare).Sort();
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void SortAlongMortonCurve(                                                              \
    Buffer<KeyedPoint<Dim>>&, std::size_t, int, const Execution&, SpareMemory);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
