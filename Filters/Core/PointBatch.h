// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_PointBatch_h
#define hashedoctree_PointBatch_h

#include "BatchOrder.h"
#include "PointSearch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hashedoctree
{
/**
 * Many searches at once, shared out among the threads of an execution, with progress. Each search
 * finds what PointSearch finds, whatever the number of threads. Positions are taken in a
 * BatchOrder. Members throw Interrupted; a sign to stop is heeded between two searches, and where
 * what they found is copied.
 */
template <int Dim, typename Real>
class PointBatch
{
public:
  /** The tree must outlive the batch. */
  PointBatch(const PointTree<Dim, Real>& tree, Execution execution)
    : Tree(tree)
    , Search(tree)
    , Threads(std::move(execution))
  {
  }

  /**
   * The `count` points closest to each position, in order: `count` ids and squared distances for
   * each, position after position. Where there are fewer points, and where a position is not
   * finite, the rest is -1 and infinity.
   */
  template <typename QueryReal, typename Id>
  void FindClosest(
    PointSpan<Dim, QueryReal> positions, std::size_t count, Id* ids, double* dist2) const
  {
    this->ForOrders(positions, this->Threads,
      [&](const BatchOrder<Dim>& order, const Execution& execution)
      {
        execution.For(order.GetCount(), Grain,
          [&](std::size_t first, std::size_t last)
          {
            std::vector<FoundPoint> found;
            for (std::size_t place = first; place < last; ++place)
            {
              execution.HeedStop();
              const std::size_t i = order[place];
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
      });
  }

  /** The points within a radius of each position, as parts of one list. */
  class Lists
  {
  public:
    std::size_t GetNumberOfPoints() const { return this->Offsets.back(); }

    /** Writes where the part of each position begins, and at last where the last one ends:
     * positions + 1 values; and the ids and squared distances of all parts. On the threads of the
     * batch, with the rest of its progress. */
    template <typename Id>
    void CopyTo(Id* offsets, Id* ids, double* dist2) const
    {
      std::copy(this->Offsets.begin(), this->Offsets.end(), offsets);
      const auto all = static_cast<double>(this->Offsets.size() - 1);
      double done = 0.0;
      for (const Slice& slice : this->Slices)
      {
        const double begin = done;
        done += static_cast<double>(slice.Order.GetCount()) / all;
        this->Copying.Part(begin, done)
          .ForChunks(slice.Order.GetCount(), Grain,
            [&](std::size_t chunk, std::size_t first, std::size_t last)
            { this->CopyPlaces(slice, slice.Chunks[chunk].data(), first, last, ids, dist2); });
      }
    }

  private:
    friend class PointBatch;
    struct Slice
    {
      BatchOrder<Dim> Order;
      std::vector<std::vector<FoundPoint>> Chunks; ///< Of Grain positions each, in that order.
    };
    Lists(std::size_t numberOfPositions, Execution copying)
      : Offsets(numberOfPositions + 1, 0)
      , Copying(std::move(copying))
    {
    }

    /** Writes what was found for the positions at some places of an order, `found` on. */
    template <typename Id>
    void CopyPlaces(const Slice& slice, const FoundPoint* found, std::size_t first,
      std::size_t last, Id* ids, double* dist2) const
    {
      for (std::size_t place = first; place < last; ++place)
      {
        this->Copying.HeedStop();
        const std::size_t i = slice.Order[place];
        for (std::size_t at = this->Offsets[i]; at < this->Offsets[i + 1]; ++at, ++found)
        {
          ids[at] = static_cast<Id>(found->Id);
          dist2[at] = found->Dist2;
        }
      }
    }

    std::vector<std::size_t> Offsets;
    std::vector<Slice> Slices;
    Execution Copying;
  };

  /** The points within a radius of each position, those at it included, by distance, then by id.
   * These take 16 bytes each until they are copied. */
  template <typename QueryReal>
  Lists FindWithin(PointSpan<Dim, QueryReal> positions, double radius) const
  {
    constexpr double findingShare = 0.7; // Of the progress; the rest is for copying.
    Lists lists(positions.Count, this->Threads.Part(findingShare, 1.0));
    this->ForOrders(positions, this->Threads.Part(0.0, findingShare),
      [&](BatchOrder<Dim>& order, const Execution& execution)
      {
        std::vector<std::vector<FoundPoint>> chunks(
          Execution::GetNumberOfChunks(order.GetCount(), Grain));
        execution.ForChunks(order.GetCount(), Grain,
          [&](std::size_t chunk, std::size_t first, std::size_t last)
          {
            std::vector<FoundPoint> found;
            for (std::size_t place = first; place < last; ++place)
            {
              execution.HeedStop();
              const std::size_t i = order[place];
              this->Search.FindWithin(GetPosition<Dim>(positions, i), radius, found);
              std::sort(found.begin(), found.end());
              lists.Offsets[i + 1] = found.size();
              chunks[chunk].insert(chunks[chunk].end(), found.begin(), found.end());
            }
          });
        lists.Slices.push_back({ std::move(order), std::move(chunks) });
      });
    std::partial_sum(lists.Offsets.begin(), lists.Offsets.end(), lists.Offsets.begin());
    return lists;
  }

private:
  static constexpr std::size_t Grain = 512; ///< Positions that a thread does at a time.

  /** Calls function(order, execution) for the positions, a slice that can be ordered at a time. */
  template <typename Positions, typename Function>
  void ForOrders(
    const Positions& positions, const Execution& execution, const Function& function) const
  {
    constexpr std::size_t most = BatchOrder<Dim>::MostPositions;
    for (std::size_t first = 0; first < positions.Count; first += most)
    {
      const std::size_t last = std::min(positions.Count, first + most);
      const auto all = static_cast<double>(positions.Count);
      const Execution part =
        execution.Part(static_cast<double>(first) / all, static_cast<double>(last) / all);
      BatchOrder<Dim> order(this->Tree, positions, first, last, part.Part(0.0, 0.2));
      function(order, part.Part(0.2, 1.0));
    }
  }

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

  const PointTree<Dim, Real>& Tree;
  PointSearch<Dim, Real> Search;
  Execution Threads;
};
}

#endif
