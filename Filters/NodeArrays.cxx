// SPDX-License-Identifier: BSD-3-Clause
#include "NodeArrays.h"

#include "DirectSearch.h"
#include "ResizeArray.h"

#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"

namespace hashedoctree
{
namespace
{
constexpr const char* KeysName = "MortonKey";
}

template <int Dim>
void AddNodeArrays(const Octree<Dim>& tree, int startDepth,
  const Buffer<typename Octree<Dim>::Node>& nodes, vtkCellData* cellData,
  const Execution& execution)
{
  const std::size_t size = nodes.GetSize();
  const auto depths = MakeArray<vtkIntArray>("Depth", size);
  const auto hitCosts = MakeArray<vtkIntArray>("HitCost", size);
  const auto rootCosts = MakeArray<vtkIntArray>("RootCost", size);
  const auto pointCounts = MakeArray<vtkTypeInt64Array>("PointCount", size);
  const auto keys = MakeArray<vtkTypeUInt64Array>(KeysName, size);
  constexpr std::size_t grain = 512; // Nodes that a thread describes at a time.
  execution.ForEach(size, grain,
    [&](std::size_t i)
    {
      const typename Octree<Dim>::Node& node = nodes[i];
      const MortonKey<Dim> key = node.NodeKey.GetFirstAtMaxDepth();
      const auto cost = [&](int from)
      { return node.Internal ? 0 : static_cast<int>(CountExaminedNodes(tree, key, from)); };
      const auto id = static_cast<vtkIdType>(i);
      depths->SetValue(id, node.NodeKey.GetDepth());
      hitCosts->SetValue(id, cost(startDepth));
      rootCosts->SetValue(id, cost(0));
      pointCounts->SetValue(id, static_cast<vtkTypeInt64>(node.GetNumberOfPoints()));
      keys->SetValue(id, node.NodeKey.GetValue());
    });
  cellData->AddArray(depths);
  cellData->AddArray(hitCosts);
  cellData->AddArray(rootCosts);
  cellData->AddArray(pointCounts);
  cellData->AddArray(keys);
  cellData->SetActiveScalars("Depth");
}

bool HaveNodeArrays(vtkCellData* cellData)
{
  return vtkTypeUInt64Array::FastDownCast(cellData->GetAbstractArray(KeysName)) != nullptr;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template void AddNodeArrays(                                                                     \
    const Octree<Dim>&, int, const Buffer<Octree<Dim>::Node>&, vtkCellData*, const Execution&);
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
#undef HASHEDOCTREE_INSTANTIATE
}
