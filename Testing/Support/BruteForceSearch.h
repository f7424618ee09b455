// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_BruteForceSearch_h
#define Testing_Support_BruteForceSearch_h

#include "PointSpan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

/** A point that the oracle found. */
struct OracleFound
{
  double Dist2;
  std::int64_t Id;
};

/** Of a list in order of distance, how many are within a radius. */
inline std::size_t CountWithin(const std::vector<OracleFound>& all, double radius)
{
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(),
    [radius](const OracleFound& found)
    { return radius >= 0.0 && found.Dist2 <= radius * radius; }));
}

/** The ids of the first `count`, or of all where there are fewer. */
inline std::vector<std::int64_t> GetIds(const std::vector<OracleFound>& all, std::size_t count)
{
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i)
  {
    ids.push_back(all[i].Id);
  }
  return ids;
}

/** The oracle for searches: looks at every point, and knows nothing of trees. */
template <int Dim, typename Real>
class BruteForceSearch
{
public:
  /** The points must outlive the search. */
  explicit BruteForceSearch(hashedoctree::PointSpan<Dim, Real> points)
    : Points(points)
  {
  }

  /** All points that can be found from x, by distance, then by id. */
  std::vector<OracleFound> FindAll(const hashedoctree::Position<Dim>& x) const
  {
    std::vector<OracleFound> found;
    for (std::size_t i = 0; i < this->Points.Count && IsWithin(x.data(), Most); ++i)
    {
      if (IsWithin(this->Points[i], MostOfPoints))
      {
        double dist2 = 0.0;
        for (int axis = 0; axis < Dim; ++axis)
        {
          const double difference = static_cast<double>(this->Points[i][axis]) - x[axis];
          dist2 += difference * difference;
        }
        found.push_back({ dist2, static_cast<std::int64_t>(i) });
      }
    }
    std::sort(found.begin(), found.end(),
      [](const OracleFound& a, const OracleFound& b)
      { return a.Dist2 != b.Dist2 ? a.Dist2 < b.Dist2 : a.Id < b.Id; });
    return found;
  }

  /** The ids of the points in a box that can be found, in order. */
  std::vector<std::int64_t> FindWithin(const hashedoctree::Box<Dim>& box) const
  {
    std::vector<std::int64_t> found;
    for (std::size_t i = 0; i < this->Points.Count; ++i)
    {
      bool inside = IsWithin(this->Points[i], MostOfPoints);
      for (int axis = 0; axis < Dim; ++axis)
      {
        const auto x = static_cast<double>(this->Points[i][axis]);
        inside = inside && x >= box.Lower[axis] && x <= box.Upper[axis];
      }
      if (inside)
      {
        found.push_back(static_cast<std::int64_t>(i));
      }
    }
    return found;
  }

  /** The box around the points that can be found; Box's default when there are none. */
  hashedoctree::Box<Dim> GetBox() const
  {
    hashedoctree::Box<Dim> box;
    for (std::size_t i = 0; i < this->Points.Count; ++i)
    {
      hashedoctree::Position<Dim> x{};
      std::copy(this->Points[i], this->Points[i] + Dim, x.begin());
      if (IsWithin(x.data(), MostOfPoints))
      {
        box.Add({ x, x });
      }
    }
    return box;
  }

private:
  static constexpr double Most = std::numeric_limits<double>::max();
  static constexpr double MostOfPoints = Most / 4; ///< Points beyond cannot be found.

  template <typename Coordinate>
  static bool IsWithin(const Coordinate* x, double most)
  {
    return std::all_of(x, x + Dim,
      [most](Coordinate coordinate) { return std::abs(static_cast<double>(coordinate)) <= most; });
  }

  hashedoctree::PointSpan<Dim, Real> Points;
};

#endif
