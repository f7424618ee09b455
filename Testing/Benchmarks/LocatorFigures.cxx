// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorFigures.h"

#include "LocatorFormat.h"

#include <algorithm>
#include <ostream>

namespace locator_benchmark
{
namespace
{
constexpr std::size_t BuildSize = 1000000;

class Figures
{
public:
  Figures(std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
    : Out(out)
    , Options(options)
    , Results(results)
    , Ours(options.Peers[0])
    , Largest(options.Sizes.back())
  {
  }

  void WriteGrowth()
  {
    const std::size_t smallest = this->Options.Sizes.front();
    if (smallest == this->Largest)
    {
      return;
    }
    for (const std::string& peer : this->Options.Peers)
    {
      this->WriteRatio("closest, near, cube: from " + std::to_string(smallest) + " to " +
          std::to_string(this->Largest) + " points a query of " + peer + " takes",
        { "cube", this->Largest, "near", Operation::Closest, 1, peer },
        { "cube", smallest, "near", Operation::Closest, 1, peer });
    }
  }

  void WriteBuilds()
  {
    for (const std::string& data : this->Options.Data)
    {
      const LocatorCase one{ data, BuildSize, "-", Operation::Build, 1, this->Ours };
      LocatorCase two = one;
      two.Threads = 2;
      const std::string title = data + ": build of " + std::to_string(BuildSize) + " points";
      for (const char* peer : { "static", "nanoflann" })
      {
        this->WriteRatio(title + ", 1 thread: " + peer + " takes", one.WithPeer(peer), one);
        this->WriteRatio(title + ", 2 threads: " + peer + " takes", two.WithPeer(peer), two);
      }
      this->WriteRatio(title + ": ours on 1 thread takes", one, two);
    }
  }

  void WriteStartDepths()
  {
    for (const std::string& data : this->Options.Data)
    {
      for (const std::string& peer : this->Options.Peers)
      {
        const LocatorCase median{ data, this->Largest, "near", Operation::Closest, 1, this->Ours };
        if (peer == "root" || peer == "local")
        {
          this->WriteRatio(data + ": closest, near, " + std::to_string(this->Largest) +
              " points: from the " + this->Ours + " is one; " + peer + " takes",
            median.WithPeer(peer), median);
        }
      }
    }
  }

  void WriteOutlier()
  {
    for (const std::string& queries : this->Options.Queries)
    {
      const LocatorCase outlier{ "outlier", this->Largest, queries, Operation::Closest, 1,
        this->Ours };
      LocatorCase cube = outlier;
      cube.Data = "cube";
      for (const std::string& peer : this->Options.Peers)
      {
        this->WriteRatio("closest, " + queries + ", " + std::to_string(this->Largest) +
            " points: with an outlier a query of " + peer + " takes, of the cube's",
          outlier.WithPeer(peer), cube.WithPeer(peer));
      }
    }
  }

  void WriteMemory()
  {
    for (const std::string& data : this->Options.Data)
    {
      for (const std::string& peer : { this->Ours, std::string("nanoflann") })
      {
        const double bytes = this->GetIndexBytes(data, peer);
        if (bytes > 0.0)
        {
          this->Out << "- " << data << ": index of " << peer << ": " << FormatNumber(bytes)
                    << " bytes per point (" << this->Largest << " points)\n";
        }
      }
    }
  }

private:
  void WriteRatio(const std::string& title, const LocatorCase& which, const LocatorCase& base)
  {
    const double ratio = GetRatio(this->Results, which, base);
    if (!std::isnan(ratio))
    {
      this->Out << "- " << title << " x " << FormatNumber(ratio) << " ("
                << FormatTime(this->Results.GetSeconds(which)) << ")\n";
    }
  }

  /** Every benchmark of a locator tells its size; any that ran will do. */
  double GetIndexBytes(const std::string& data, const std::string& peer) const
  {
    for (const LocatorCase& which : this->Options.MakeCases(data, this->Largest))
    {
      const double bytes = this->Results.GetCounter(which.WithPeer(peer), "index_bytes_per_point");
      if (!std::isnan(bytes))
      {
        return bytes;
      }
    }
    return 0.0;
  }

  std::ostream& Out;
  const LocatorOptions& Options;
  const LocatorResults& Results;
  std::string Ours;
  std::size_t Largest;
};
}

void WriteFigures(std::ostream& out, const LocatorOptions& options, const LocatorResults& results)
{
  Figures figures(out, options, results);
  out << "\n## Figures\n\nx is how many times as long something takes.\n\n";
  figures.WriteGrowth();
  figures.WriteBuilds();
  figures.WriteStartDepths();
  figures.WriteOutlier();
  figures.WriteMemory();
}
}
