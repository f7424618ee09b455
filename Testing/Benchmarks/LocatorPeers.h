// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorPeers_h
#define Testing_Benchmarks_LocatorPeers_h

#include "LocatorData.h"

#include "vtkIdList.h"
#include "vtkNew.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace locator_benchmark
{
/** What a peer writes its answers to; one for each thread, used again and again. */
struct Answer
{
  vtkIdType Closest = -1;
  vtkNew<vtkIdList> List;
  std::vector<std::uint32_t> Ids;
  std::vector<double> Distances2;
  std::vector<std::pair<std::uint32_t, double>> IdsAndDistances2;
};

/** A point locator behind one interface, at the cost of a virtual call for all alike. Searches are
 * thread safe after Build(). */
class LocatorPeer
{
public:
  virtual ~LocatorPeer() = default;

  /** The data must outlive the peer. */
  virtual void Build(const LocatorData& data) = 0;
  virtual vtkIdType FindClosest(const Position& x) = 0;
  virtual void FindClosest(int count, const Position& x, Answer& answer) = 0;
  virtual void FindWithin(double radius, const Position& x, Answer& answer) = 0;

  /** Ids of the last answer with a list. */
  virtual std::vector<vtkIdType> GetIds(const Answer& answer) const = 0;

  /** Bytes of the index, 0 when the peer does not tell. */
  virtual std::size_t GetIndexBytes() { return 0; }
};

struct PeerKind
{
  std::string Name;
  std::string Description;
  /** Its distances must be those of ours; else differences are only counted. */
  bool Exact;
  std::function<std::unique_ptr<LocatorPeer>()> Make;
};

/** All kinds of peers. The first is the one that the others are compared with. */
const std::vector<PeerKind>& GetPeerKinds();

/** The kind of a name that is known. */
const PeerKind& GetPeerKind(const std::string& name);

/** nanoflann's k-d tree with leaves of at most 10 points, its default. */
std::unique_ptr<LocatorPeer> MakeNanoflannPeer();
}

#endif
