// SPDX-License-Identifier: BSD-3-Clause
#include "NodeList.h"

#include "ForEachDimension.h"

#include <utility>
#include <vector>

namespace hashedoctree
{
template <int Dim>
Buffer<typename Octree<Dim>::Node> ListNodes(const Octree<Dim>& tree, NodeListOptions options,
  const Execution& execution, const CurveRange<Dim>& range)
{
  using Node = typename Octree<Dim>::Node;
  constexpr std::size_t chunkSize = 2048; // Blocks that a thread does at a time.
  const std::size_t numberOfBlocks = tree.GetNumberOfInternalNodes();
  const auto isListed = [options, range](const Node& node)
  {
    const bool isOfDepth = options.Depth < 0 || node.NodeKey.GetDepth() == options.Depth;
    return isOfDepth && range.Has(node.NodeKey) &&
      (node.Internal ? options.InternalNodes : options.EmptyLeaves || !node.IsEmpty());
  };
  // Calls function(chunk, node) for the listed children of all blocks, a chunk on one thread.
  const auto forChildren = [&](double from, double to, const auto& function)
  {
    const auto body = [&](std::size_t chunk, std::size_t first, std::size_t last)
    {
      tree.ForEachChild(first, last,
        [&](const Node& child)
        {
          if (isListed(child))
          {
            function(chunk, child);
          }
        });
    };
    execution.Part(from, to).ForChunks(numberOfBlocks, chunkSize, body);
  };

  std::vector<std::size_t> counts(Execution::GetNumberOfChunks(numberOfBlocks, chunkSize), 0);
  forChildren(0.0, 0.5, [&](std::size_t chunk, const Node&) { ++counts[chunk]; });

  const bool rootIsListed = isListed(tree.GetRoot());
  std::size_t total = rootIsListed ? 1 : 0;
  for (std::size_t& count : counts)
  {
    total += std::exchange(count, total);
  }

  Buffer<Node> nodes(total);
  if (rootIsListed)
  {
    nodes[0] = tree.GetRoot();
  }
  forChildren(
    0.5, 1.0, [&](std::size_t chunk, const Node& child) { nodes[counts[chunk]++] = child; });
  return nodes;
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template Buffer<Octree<Dim>::Node> ListNodes(                                                    \
    const Octree<Dim>&, NodeListOptions, const Execution&, const CurveRange<Dim>&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
