// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorPeers.h"

#include <nanoflann.hpp>

namespace locator_benchmark
{
namespace
{
/** nanoflann's view of the points. They are kept as float but handed out as double, since nanoflann
 * subtracts in the type that it is given, and takes positions in it. */
class Cloud
{
public:
  explicit Cloud(const LocatorData& data)
    : Data(data)
  {
  }

  // The names are nanoflann's.
  // NOLINTBEGIN(readability-identifier-naming)
  std::size_t kdtree_get_point_count() const { return this->Data.GetNumberOfPoints(); }
  double kdtree_get_pt(std::size_t id, std::size_t axis) const
  {
    return static_cast<double>(this->Data.GetPoint(id)[axis]);
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
  // NOLINTEND(readability-identifier-naming)

private:
  const LocatorData& Data;
};

/** Does what nanoflann's RadiusResultSet does. That one's items have another type since
 * nanoflann 1.5, and so have the parameters by which they are left unsorted. */
class PointsWithin
{
public:
  using DistanceType = double;
  using Items = std::vector<std::pair<std::uint32_t, double>>;

  PointsWithin(double radius2, Items& items)
    : Radius2(radius2)
    , Found(items)
  {
    this->Found.clear();
  }

  // The names are nanoflann's.
  // NOLINTBEGIN(readability-identifier-naming)
  bool addPoint(double distance2, std::uint32_t id)
  {
    if (distance2 < this->Radius2)
    {
      this->Found.emplace_back(id, distance2);
    }
    return true;
  }
  double worstDist() const { return this->Radius2; }
  std::size_t size() const { return this->Found.size(); }
  bool full() const { return true; }
  void sort() {}
  // NOLINTEND(readability-identifier-naming)

private:
  const double Radius2;
  Items& Found;
};

class NanoflannPeer : public LocatorPeer
{
public:
  void Build(const LocatorData& data) override
  {
    this->Points = std::make_unique<Cloud>(data);
    this->Index = std::make_unique<Tree>(
      3, *this->Points, nanoflann::KDTreeSingleIndexAdaptorParams(/*leaf_max_size=*/10));
  }

  vtkIdType FindClosest(const Position& x) override
  {
    std::uint32_t id = 0;
    double distance2 = 0.0;
    this->Index->knnSearch(x.data(), 1, &id, &distance2);
    return id;
  }

  void FindClosest(int count, const Position& x, Answer& answer) override
  {
    const auto wanted = static_cast<std::size_t>(count);
    answer.Ids.resize(wanted);
    answer.Distances2.resize(wanted);
    answer.IdsAndDistances2.clear();
    answer.Ids.resize(
      this->Index->knnSearch(x.data(), wanted, answer.Ids.data(), answer.Distances2.data()));
  }

  void FindWithin(double radius, const Position& x, Answer& answer) override
  {
    answer.Ids.clear();
    PointsWithin within(radius * radius, answer.IdsAndDistances2);
    this->Index->findNeighbors(within, x.data(), {});
  }

  std::vector<vtkIdType> GetIds(const Answer& answer) const override
  {
    std::vector<vtkIdType> ids(answer.Ids.begin(), answer.Ids.end());
    for (const auto& found : answer.IdsAndDistances2)
    {
      ids.push_back(found.first);
    }
    return ids;
  }

  std::size_t GetIndexBytes() override { return this->Index->usedMemory(*this->Index); }

private:
  using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud, double>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 3>;

  std::unique_ptr<Cloud> Points;
  std::unique_ptr<Tree> Index;
};
}

std::unique_ptr<LocatorPeer> MakeNanoflannPeer()
{
  return std::make_unique<NanoflannPeer>();
}
}
