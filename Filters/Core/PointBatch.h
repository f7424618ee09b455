// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointBatch_h
#define hashedoctree_PointBatch_h

#include "Execution.h"
#include "PointSearch.h"

#include <algorithm>

namespace hashedoctree
{
/**
 * Many searches at once, shared out among the threads of an execution, with progress. Each search
 * finds what PointSearch finds, whatever the number of threads. Members throw Interrupted.
 */
template <int Dim, typename Real>
class PointBatch
{
public:
  /** The tree must outlive the batch. */
  PointBatch(const PointTree<Dim, Real>& tree, const Execution& execution)
    : Search(tree)
    , Threads(execution)
  {
  }

  /**
   * The `count` points closest to each position, in order: `count` ids and squared distances for
   * each, position after position. Where there are fewer points, and where a position is not
   * finite, the rest is -1 and infinity.
   */
  template <typename Real2, typename Id>
  void FindClosest(PointSpan<Dim, Real2> positions, std::size_t count, Id* ids, double* dist2) const
  {
    this->Threads.For(positions.Count, Grain,
      [&](std::size_t first, std::size_t last)
      {
        std::vector<FoundPoint> found;
        for (std::size_t i = first; i < last; ++i)
        {
          this->FindClosestTo(GetPosition<Dim>(positions, i), count, found);
          for (std::size_t j = 0; j < count; ++j)
          {
            const bool exists = j < found.size();
            ids[i * count + j] = exists ? static_cast<Id>(found[j].Id) : Id(-1);
            dist2[i * count + j] =
              exists ? found[j].Dist2 : std::numeric_limits<double>::infinity();
          }
        }
      });
  }

  /** The points within a radius of each position, as parts of one list. */
  class Lists
  {
  public:
    std::size_t GetNumberOfPoints() const { return this->Offsets.back(); }

    /** Writes where the part of each position begins, and at last where the last one ends:
     * positions + 1 values; and the ids and squared distances of all parts. */
    template <typename Id>
    void CopyTo(Id* offsets, Id* ids, double* dist2) const
    {
      std::copy(this->Offsets.begin(), this->Offsets.end(), offsets);
      for (const std::vector<FoundPoint>& chunk : this->Chunks)
      {
        for (const FoundPoint& point : chunk)
        {
          *ids++ = static_cast<Id>(point.Id);
          *dist2++ = point.Dist2;
        }
      }
    }

  private:
    friend class PointBatch;
    std::vector<std::size_t> Offsets;
    std::vector<std::vector<FoundPoint>> Chunks; ///< Of Grain positions each.
  };

  /** The points within a radius of each position, those at it included, by distance, then by id. */
  template <typename Real2>
  Lists FindWithin(PointSpan<Dim, Real2> positions, double radius) const
  {
    Lists lists;
    lists.Offsets.assign(positions.Count + 1, 0);
    lists.Chunks.resize((positions.Count + Grain - 1) / Grain);
    this->Threads.For(lists.Chunks.size(), 1,
      [&](std::size_t firstChunk, std::size_t lastChunk)
      {
        std::vector<FoundPoint> found;
        for (std::size_t chunk = firstChunk; chunk < lastChunk; ++chunk)
        {
          const std::size_t last = std::min(positions.Count, (chunk + 1) * Grain);
          for (std::size_t i = chunk * Grain; i < last; ++i)
          {
            this->Search.FindWithin(GetPosition<Dim>(positions, i), radius, found);
            std::sort(found.begin(), found.end());
            lists.Offsets[i + 1] = found.size();
            lists.Chunks[chunk].insert(lists.Chunks[chunk].end(), found.begin(), found.end());
          }
        }
      });
    std::size_t sum = 0;
    for (std::size_t& offset : lists.Offsets)
    {
      sum += offset;
      offset = sum;
    }
    return lists;
  }

private:
  static constexpr std::size_t Grain = 512; ///< Positions that a thread does at a time.

  void FindClosestTo(
    const Position<Dim>& x, std::size_t count, std::vector<FoundPoint>& found) const
  {
    if (count == 1)
    {
      found.resize(1);
      found.resize(this->Search.FindClosest(x, found[0]) ? 1 : 0);
    }
    else
    {
      this->Search.FindClosest(x, count, found);
    }
  }

  PointSearch<Dim, Real> Search;
  const Execution& Threads;
};
}

#endif
