// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorPeers.h"

#include "vtkHashedOctreePointLocator.h"
#include "vtkKdTreePointLocator.h"
#include "vtkOctreePointLocator.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>

namespace locator_benchmark
{
namespace
{
/** Any locator of VTK, as it is by default. */
template <typename Locator>
class VTKPeer : public LocatorPeer
{
public:
  void Build(const LocatorData& data) override
  {
    this->Index->SetDataSet(data.MakePolyData());
    this->Index->BuildLocator();
  }

  vtkIdType FindClosest(const Position& x) override
  {
    return this->Index->FindClosestPoint(x.data());
  }

  void FindClosest(int count, const Position& x, Answer& answer) override
  {
    this->Index->FindClosestNPoints(count, x.data(), answer.List);
  }

  void FindWithin(double radius, const Position& x, Answer& answer) override
  {
    this->Index->FindPointsWithinRadius(radius, x.data(), answer.List);
  }

  std::vector<vtkIdType> GetIds(const Answer& answer) const override
  {
    const vtkIdType* ids = answer.List->GetPointer(0);
    return { ids, ids + answer.List->GetNumberOfIds() };
  }

protected:
  vtkNew<Locator> Index;
};

class HashedOctreePeer : public VTKPeer<vtkHashedOctreePointLocator>
{
public:
  explicit HashedOctreePeer(int startDepthModel)
  {
    this->Index->SetStartDepthModel(startDepthModel);
  }

  std::size_t GetIndexBytes() override
  {
    return static_cast<std::size_t>(this->Index->GetIndexBytes());
  }
};

template <int StartDepthModel>
std::unique_ptr<LocatorPeer> MakeHashedOctreePeer()
{
  return std::make_unique<HashedOctreePeer>(StartDepthModel);
}

template <typename Locator>
std::unique_ptr<LocatorPeer> MakeVTKPeer()
{
  return std::make_unique<VTKPeer<Locator>>();
}
}

const std::vector<PeerKind>& GetPeerKinds()
{
  using Ours = vtkHashedOctreePointLocator;
  static const std::vector<PeerKind> kinds{
    { "median", "ours, from the median of the depths", true, MakeHashedOctreePeer<Ours::Median> },
    { "root", "ours, from the root", true, MakeHashedOctreePeer<Ours::Root> },
    { "local", "ours, from the depth of the leaves around", true,
      MakeHashedOctreePeer<Ours::Local> },
    { "static", "vtkStaticPointLocator", true, MakeVTKPeer<vtkStaticPointLocator> },
    { "octree", "vtkOctreePointLocator", false, MakeVTKPeer<vtkOctreePointLocator> },
    { "kdtree", "vtkKdTreePointLocator", false, MakeVTKPeer<vtkKdTreePointLocator> },
    { "nanoflann", "nanoflann's k-d tree, leaves of at most 10 points", true, MakeNanoflannPeer },
  };
  return kinds;
}

const PeerKind& GetPeerKind(const std::string& name)
{
  const std::vector<PeerKind>& kinds = GetPeerKinds();
  return *std::find_if(
    kinds.begin(), kinds.end(), [&name](const PeerKind& kind) { return kind.Name == name; });
}
}
