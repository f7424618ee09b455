// SPDX-License-Identifier: BSD-3-Clause
#include "MortonOrder.h"

#include <algorithm>
#include <array>
#include <vector>

namespace hashedoctree
{
namespace
{
constexpr int DigitBits = 9; // Three depths of an octree; 512 counters stay in the first cache.
constexpr std::size_t NumberOfDigits = std::size_t(1) << DigitBits;
constexpr std::size_t InsertionLimit = 32; // Up to here insertion beats counting digits.
constexpr std::size_t SerialLimit = 32768; // Up to here one thread sorts a range on its own,
constexpr std::size_t SerialShare = 16;    // and up to this part of all points.
constexpr std::size_t ChunkSize = 16384;   // Points that a thread partitions at a time.

using DigitCounts = std::array<PointIndex, NumberOfDigits>;

template <int Dim>
class Sorter
{
public:
  Sorter(Buffer<CodedPoint<Dim>>& points, const Execution& execution)
    : Points(points)
    , Scratch(points.GetSize())
    , Threads(execution)
  {
  }

  void Sort()
  {
    const std::size_t limit = std::max(SerialLimit, this->Points.GetSize() / SerialShare);
    std::vector<Range> large{ Range{ 0, this->Points.GetSize(), TopShift, false } };
    std::vector<Range> small;
    while (!large.empty())
    {
      const Range range = large.back();
      large.pop_back();
      if (range.Last - range.First <= limit || range.Shift == NoDigit)
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
  using Point = CodedPoint<Dim>;

  /** Points [First, Last), alike above the digit at Shift, in Scratch or in Points. */
  struct Range
  {
    std::size_t First;
    std::size_t Last;
    int Shift;
    bool InScratch;
  };

  static constexpr int KeyBits = Dim * MortonKey<Dim>::MaxDepth;
  static constexpr int TopShift = KeyBits > DigitBits ? KeyBits - DigitBits : 0;
  static constexpr int NoDigit = -1;

  /** Shift of the next digit; the last one may overlap its forerunner, which does no harm. */
  static int Next(int shift)
  {
    return shift > DigitBits ? shift - DigitBits : shift > 0 ? 0 : NoDigit;
  }
  static std::size_t Digit(const Point& point, int shift)
  {
    return point.Key.GetValue() >> shift & (NumberOfDigits - 1);
  }

  Point* Data(bool scratch) { return (scratch ? this->Scratch : this->Points).GetData(); }

  /** Splits a range by one digit, all threads together, and appends what has to be sorted yet. */
  void Partition(const Range& range, std::vector<Range>& rest)
  {
    const Point* from = this->Data(range.InScratch) + range.First;
    const std::size_t count = range.Last - range.First;
    const std::size_t numberOfChunks = (count + ChunkSize - 1) / ChunkSize;

    std::vector<DigitCounts> offsets(numberOfChunks);
    this->ForChunks(count,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      {
        offsets[chunk].fill(0);
        for (std::size_t i = first; i < last; ++i)
        {
          ++offsets[chunk][Digit(from[i], range.Shift)];
        }
      });

    std::array<std::size_t, NumberOfDigits + 1> starts;
    PointIndex sum = 0;
    for (std::size_t digit = 0; digit < NumberOfDigits; ++digit)
    {
      starts[digit] = sum;
      for (DigitCounts& chunk : offsets)
      {
        const PointIndex here = chunk[digit];
        chunk[digit] = sum;
        sum += here;
      }
    }
    starts[NumberOfDigits] = count;

    const std::size_t firstDigit = Digit(from[0], range.Shift);
    if (starts[firstDigit + 1] - starts[firstDigit] == count)
    {
      rest.push_back(Range{ range.First, range.Last, Next(range.Shift), range.InScratch });
      return;
    }

    Point* to = this->Data(!range.InScratch) + range.First;
    this->ForChunks(count,
      [&](std::size_t chunk, std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          to[offsets[chunk][Digit(from[i], range.Shift)]++] = from[i];
        }
      });
    for (std::size_t digit = 0; digit < NumberOfDigits; ++digit)
    {
      if (starts[digit] != starts[digit + 1])
      {
        rest.push_back(Range{ range.First + starts[digit], range.First + starts[digit + 1],
          Next(range.Shift), !range.InScratch });
      }
    }
  }

  template <typename Function>
  void ForChunks(std::size_t count, const Function& function)
  {
    // Progress stands still here: how many partitions follow is known only after them.
    this->Threads.For((count + ChunkSize - 1) / ChunkSize, 1,
      [&](std::size_t firstChunk, std::size_t lastChunk)
      {
        for (std::size_t chunk = firstChunk; chunk < lastChunk; ++chunk)
        {
          function(chunk, chunk * ChunkSize, std::min(count, (chunk + 1) * ChunkSize));
        }
      },
      0.0, 0.0);
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
          SortOne(this->Data(range.InScratch) + range.First,
            this->Data(!range.InScratch) + range.First, range.Last - range.First, range.Shift,
            range.InScratch);
        }
      });
  }

  /** Sorts `from`, with `other` as scratch of the same length; the result ends in `other` when
   * asked for, else in `from`. */
  static void SortOne(Point* from, Point* other, std::size_t count, int shift, bool intoOther)
  {
    DigitCounts offsets;
    for (;; shift = Next(shift))
    {
      if (count <= InsertionLimit || shift == NoDigit)
      {
        if (shift != NoDigit)
        {
          SortByInsertion(from, count);
        }
        if (intoOther)
        {
          std::copy(from, from + count, other);
        }
        return;
      }
      offsets.fill(0);
      for (std::size_t i = 0; i < count; ++i)
      {
        ++offsets[Digit(from[i], shift)];
      }
      if (offsets[Digit(from[0], shift)] != count)
      {
        break;
      }
    }

    PointIndex sum = 0;
    for (PointIndex& offset : offsets)
    {
      const PointIndex here = offset;
      offset = sum;
      sum += here;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      other[offsets[Digit(from[i], shift)]++] = from[i];
    }
    PointIndex first = 0;
    for (const PointIndex last : offsets)
    {
      if (last != first)
      {
        SortOne(other + first, from + first, last - first, Next(shift), !intoOther);
      }
      first = last;
    }
  }

  static void SortByInsertion(Point* points, std::size_t count)
  {
    for (std::size_t i = 1; i < count; ++i)
    {
      const Point point = points[i];
      std::size_t place = i;
      for (; place > 0 && point.Key < points[place - 1].Key; --place)
      {
        points[place] = points[place - 1];
      }
      points[place] = point;
    }
  }

  Buffer<Point>& Points;
  Buffer<Point> Scratch;
  const Execution& Threads;
};
}

template <int Dim>
void SortAlongMortonCurve(Buffer<CodedPoint<Dim>>& points, const Execution& execution)
{
  Sorter<Dim>(points, execution).Sort();
}

template void SortAlongMortonCurve(Buffer<CodedPoint<1>>&, const Execution&);
template void SortAlongMortonCurve(Buffer<CodedPoint<2>>&, const Execution&);
template void SortAlongMortonCurve(Buffer<CodedPoint<3>>&, const Execution&);
template void SortAlongMortonCurve(Buffer<CodedPoint<4>>&, const Execution&);
}
