// SPDX-License-Identifier: BSD-3-Clause
#include "PaperStartDepthTables.h"

#include "PaperFormat.h"

#include <ostream>

namespace paper_benchmark
{
void WriteModels(std::ostream& out, const std::vector<PaperResults>& sets)
{
  out << "\n## Start-depth models\n\nMean number of nodes that a direct search examines when every "
         "leaf is searched for once. The decision tree goes from depth to depth by decisions "
         "instead of child by child; no search through single depths can go below the entropy "
         "bound.\n\n";
  WriteHead(out,
    { "set", "depth +-", "root", "median", "mean", "local", "decision tree", "entropy bound" });
  for (const PaperResults& set : sets)
  {
    WriteRow(out,
      { set.Set.Name, Format(set.DepthDeviation), Format(set.Costs.Root), Format(set.Costs.Median),
        Format(set.Costs.Mean), Format(set.Costs.Local), Format(set.Costs.Decisions),
        Format(set.Costs.Bound) });
  }
}
}
