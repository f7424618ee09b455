// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorFigures.h"

#include "LocatorFormat.h"

#include <ostream>

namespace locator_benchmark
{
namespace
{
constexpr std::size_t BuildSize = 1000000;

/** A table with a figure in each row for each peer. Rows that were not measured are left out. */
class Figures
{
public:
  Figures(std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
    : Out(out)
    , Options(options)
    , Results(results)
    , Largest(options.Sizes.back())
  {
  }

  void WritePeers()
  {
    std::vector<std::string> cells{ "figure" };
    cells.insert(cells.end(), this->Options.Peers.begin(), this->Options.Peers.end());
    WriteHead(this->Out, cells);
  }

  void WriteGrowth()
  {
    const std::size_t smallest = this->Options.Sizes.front();
    const LocatorCase base{ "cube", smallest, "near", Operation::Closest, 1, "" };
    LocatorCase grown = base;
    grown.NumberOfPoints = this->Largest;
    this->WriteRatios("closest near, cube: time with " + std::to_string(this->Largest) +
        " points / with " + std::to_string(smallest),
      grown, base);
  }

  void WriteBuilds(const std::string& data)
  {
    const std::string title = "build of " + std::to_string(BuildSize) + ", " + data + ": time on ";
    const LocatorCase one{ data, BuildSize, "-", Operation::Build, 1, "" };
    LocatorCase two = one;
    two.Threads = 2;
    this->WriteComparison(title + "1 thread / ours", one);
    this->WriteComparison(title + "2 threads / ours", two);
    this->WriteRatios(title + "1 thread / on 2 threads", one, two);
    this->WriteFigure(title + "1 thread / on 2 threads, of arithmetic alone after each",
      [&](const std::string& peer)
      { return this->Results.GetCounter(two.WithPeer(peer), "gain_of_threads"); });
  }

  void WriteStartDepths(const std::string& data)
  {
    const LocatorCase which{ data, this->Largest, "near", Operation::Closest, 1, "" };
    this->WriteComparison("closest near, " + data + ", " + std::to_string(this->Largest) +
        " points: time / from the median",
      which);
  }

  void WriteOutlier(const std::string& queries)
  {
    const LocatorCase outlier{ "outlier", this->Largest, queries, Operation::Closest, 1, "" };
    LocatorCase cube = outlier;
    cube.Data = "cube";
    this->WriteRatios("closest " + queries + ", " + std::to_string(this->Largest) +
        " points: time with an outlier / cube",
      outlier, cube);
  }

  void WriteMemory(const std::string& data)
  {
    this->WriteFigure(
      "bytes of the index per point, " + data + ", " + std::to_string(this->Largest) + " points",
      [&](const std::string& peer) { return this->GetIndexBytes(data, peer); });
  }

private:
  template <typename Figure>
  void WriteFigure(const std::string& title, const Figure& figure)
  {
    bool isMeasured = false;
    std::vector<std::string> cells{ title };
    for (const std::string& peer : this->Options.Peers)
    {
      const double number = figure(peer);
      isMeasured = isMeasured || !std::isnan(number);
      cells.push_back(FormatNumber(number));
    }
    if (isMeasured)
    {
      WriteRow(this->Out, cells);
    }
  }

  /** Of each peer its time by that of the first. */
  void WriteComparison(const std::string& title, const LocatorCase& which)
  {
    const LocatorCase first = which.WithPeer(this->Options.Peers[0]);
    this->WriteFigure(title,
      [&](const std::string& peer)
      { return GetRatio(this->Results, which.WithPeer(peer), first); });
  }

  /** Of each peer one of its times by another. */
  void WriteRatios(const std::string& title, const LocatorCase& which, const LocatorCase& base)
  {
    this->WriteFigure(title,
      [&](const std::string& peer)
      { return GetRatio(this->Results, which.WithPeer(peer), base.WithPeer(peer)); });
  }

  /** Every benchmark of a locator tells its size; any that ran will do. */
  double GetIndexBytes(const std::string& data, const std::string& peer) const
  {
    for (const LocatorCase& which : this->Options.MakeCases(data, this->Largest))
    {
      const double bytes = this->Results.GetCounter(which.WithPeer(peer), "index_bytes_per_point");
      if (bytes > 0.0)
      {
        return bytes;
      }
    }
    return NAN;
  }

  std::ostream& Out;
  const LocatorOptions& Options;
  const LocatorResults& Results;
  std::size_t Largest;
};
}

void WriteFigures(std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
{
  Figures figures(out, options, results);
  out
    << "\n## Figures\n\nThe bytes of ours hold a copy of the coordinates, 12 per point; nanoflann "
       "has none. VTK's others do not tell theirs.\n\n";
  figures.WritePeers();
  figures.WriteGrowth();
  for (const std::string& data : options.Data)
  {
    figures.WriteBuilds(data);
  }
  for (const std::string& data : options.Data)
  {
    figures.WriteStartDepths(data);
  }
  for (const std::string& queries : options.Queries)
  {
    figures.WriteOutlier(queries);
  }
  for (const std::string& data : options.Data)
  {
    figures.WriteMemory(data);
  }
}
}
