// SPDX-License-Identifier: BSD-3-Clause
#include "PointSearch.h"

#include "BruteForceSearch.h"
#include "PointQuery.h"
#include "PointSearchInput.h"
#include "TreeProperties.h"

#include <cstdlib>
#include <iostream>

using namespace hashedoctree;

namespace
{
using Points = std::vector<FoundPoint>;

/** A tree and the searches in it: all that is called of what is tested. */
template <typename Real>
class TestedSearch
{
public:
  TestedSearch(PointSpan<3, Real> points, const TreeProperties& properties)
    : Tree(points, PointSelection<3>(points, {}, Execution()), properties.Options, Execution())
    , Search(this->Tree)
  {
    this->Tree.SetStartDepths(properties.StartDepths);
  }

  Points FindClosest(const Position<3>& x, double radius2) const
  {
    FoundPoint found{};
    return this->Search.FindClosest(x, found, radius2) ? Points{ found } : Points{};
  }
  Points FindClosestFew(const Position<3>& x, std::size_t count) const
  {
    Points found{ {} };
    this->Search.FindClosest(x, count, found);
    return found;
  }
  std::vector<PointIndex> FindWithin(const Position<3>& x, double radius) const
  {
    std::vector<PointIndex> found{ 0 };
    this->Search.FindWithin(x, radius, found);
    return found;
  }
  Points FindWithinByDistance(const Position<3>& x, double radius) const
  {
    Points found{ {} };
    this->Search.FindWithin(x, radius, found);
    std::sort(found.begin(), found.end());
    return found;
  }
  std::vector<PointIndex> FindWithin(const Box<3>& box) const
  {
    std::vector<PointIndex> found{ 0 };
    this->Search.FindWithin(box, found);
    return found;
  }

private:
  PointTree<3, Real> Tree;
  PointSearch<3, Real> Search;
};

/** A query, the oracle's list of points for it, and what to say when the answer differs. */
class Question
{
public:
  Question(const PointQuery& query, std::vector<OracleFound> all)
    : Query(query)
    , All(std::move(all))
  {
  }

  template <typename Real>
  void Ask(const TestedSearch<Real>& search) const
  {
    switch (this->Query.Kind)
    {
      case PointQuery::Closest:
        this->Expect(search.FindClosest(this->Query.X, Infinity), 1, "closest point");
        break;
      case PointQuery::ClosestWithin:
      {
        const double radius2 = this->GetRadius(true);
        const bool within = !this->All.empty() && this->All[0].Dist2 <= radius2 && radius2 >= 0.0;
        this->Expect(search.FindClosest(this->Query.X, radius2), within ? 1 : 0,
          "closest point within squared radius", radius2);
        break;
      }
      case PointQuery::ClosestFew:
        this->Expect(search.FindClosestFew(this->Query.X, this->Query.Count), this->Query.Count,
          "closest few,", static_cast<double>(this->Query.Count));
        break;
      case PointQuery::Within:
      {
        const double radius = this->GetRadius(false);
        this->Expect(this->PutInOrder(search.FindWithin(this->Query.X, radius)),
          CountWithin(this->All, radius), "points within radius", radius);
        this->Expect(search.FindWithinByDistance(this->Query.X, radius),
          CountWithin(this->All, radius), "points and distances within radius", radius);
        break;
      }
      case PointQuery::InBox:
        this->Expect(this->PutInOrder(search.FindWithin({ this->Query.X, this->Query.Upper })),
          this->All.size(), "points in a box");
        break;
    }
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  double GetRadius(bool squared) const
  {
    if (this->Query.RadiusKind == PointQuery::Given || this->All.empty())
    {
      return this->Query.Radius;
    }
    const double dist2 = this->All[this->Query.Neighbor % this->All.size()].Dist2;
    const double radius = squared ? dist2 : std::sqrt(dist2);
    return this->Query.RadiusKind == PointQuery::OfNeighbor ? radius
      : this->Query.RadiusKind == PointQuery::BelowNeighbor ? std::nextafter(radius, -Infinity)
                                                            : std::nextafter(radius, Infinity);
  }

  /** Points in no order, in the oracle's order; those that it has not, or only once, come last. */
  Points PutInOrder(std::vector<PointIndex> ids) const
  {
    Points points;
    for (const OracleFound& point : this->All)
    {
      const auto id = std::find(ids.begin(), ids.end(), static_cast<PointIndex>(point.Id));
      if (id != ids.end())
      {
        points.push_back({ point.Dist2, *id });
        ids.erase(id);
      }
    }
    for (const PointIndex id : ids)
    {
      points.push_back({ -1.0, id });
    }
    return points;
  }

  /** The oracle's first `count` points, and nothing else, must have been found. */
  void Expect(const Points& found, std::size_t count, const char* what, double bound = 0.0) const
  {
    count = std::min(count, this->All.size());
    std::size_t same = 0;
    while (same < std::min(found.size(), count) &&
      static_cast<std::int64_t>(found[same].Id) == this->All[same].Id &&
      found[same].Dist2 == this->All[same].Dist2)
    {
      ++same;
    }
    if (same == found.size() && same == count)
    {
      return;
    }
    std::cerr.precision(std::numeric_limits<double>::max_digits10);
    std::cerr << what << ' ' << bound << " at (" << this->Query.X[0] << ", " << this->Query.X[1]
              << ", " << this->Query.X[2] << "), place " << same << ": expected ";
    same < count ? Print(this->All[same]) : Print();
    std::cerr << ", found ";
    same < found.size() ? Print(found[same]) : Print();
    std::cerr << std::endl;
    std::abort();
  }

  template <typename Found>
  static void Print(const Found& point)
  {
    std::cerr << "point " << point.Id << " at squared distance " << point.Dist2;
  }
  static void Print() { std::cerr << "nothing"; }

  const PointQuery& Query;
  std::vector<OracleFound> All;
};

/** All points for the position of a query, or those in its box, none of which has a distance. */
template <typename Real>
std::vector<OracleFound> AskOracle(const BruteForceSearch<3, Real>& oracle, const PointQuery& query)
{
  if (query.Kind != PointQuery::InBox)
  {
    return oracle.FindAll(query.X);
  }
  std::vector<OracleFound> all;
  for (const std::int64_t id : oracle.FindWithin({ query.X, query.Upper }))
  {
    all.push_back({ 0.0, id });
  }
  return all;
}

template <typename Real>
void Run(FuzzBytes& bytes)
{
  const TreeProperties properties(bytes);
  const PointSearchInput<Real> input(bytes);
  const TestedSearch<Real> search(input.GetPoints(), properties);
  const BruteForceSearch<3, Real> oracle(input.GetPoints());
  for (const PointQuery& query : input.GetQueries())
  {
    Question(query, AskOracle(oracle, query)).Ask(search);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  if (bytes.ReadByte() % 2 == 0)
  {
    Run<float>(bytes);
  }
  else
  {
    Run<double>(bytes);
  }
  return 0;
}
