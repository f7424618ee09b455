// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorCase_h
#define Testing_Benchmarks_LocatorCase_h

#include <cstddef>
#include <string>
#include <vector>

namespace locator_benchmark
{
enum class Operation
{
  Build,
  Closest,
  Closest8,
  Closest32,
  Closest100,
  Radius
};

/** Names in the order of the enumeration. */
inline const std::vector<std::string>& GetOperationNames()
{
  static const std::vector<std::string> names{ "build", "closest", "closest8", "closest32",
    "closest100", "radius" };
  return names;
}

/** How many points an operation asks for; 0 where it does not. */
inline int GetNumberOfClosest(Operation operation)
{
  switch (operation)
  {
    case Operation::Closest:
      return 1;
    case Operation::Closest8:
      return 8;
    case Operation::Closest32:
      return 32;
    case Operation::Closest100:
      return 100;
    case Operation::Build:
    case Operation::Radius:
      break;
  }
  return 0;
}

inline const std::vector<std::string>& GetQueryNames()
{
  static const std::vector<std::string> names{ "near", "uniform", "ordered", "points", "above" };
  return names;
}

/** What one benchmark measures. */
struct LocatorCase
{
  std::string Data;
  std::size_t NumberOfPoints;
  std::string Queries; // "-" for builds
  Operation What;
  int Threads;
  std::string Peer;

  /** The name of the benchmark; plot_locator.py takes it apart. */
  std::string GetName() const
  {
    return this->Data + "/" + std::to_string(this->NumberOfPoints) + "/" + this->Queries + "/" +
      GetOperationNames()[static_cast<std::size_t>(this->What)] + "/" +
      std::to_string(this->Threads) + "/" + this->Peer;
  }

  LocatorCase WithPeer(const std::string& peer) const
  {
    LocatorCase other = *this;
    other.Peer = peer;
    return other;
  }
};
}

#endif
