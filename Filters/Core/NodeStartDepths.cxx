// SPDX-License-Identifier: BSD-3-Clause
#include "NodeStartDepths.h"

#include "AdjacentSearch.h"
#include "ForEachDimension.h"

namespace hashedoctree
{
template <int Dim>
NodeStartDepths<Dim>::NodeStartDepths(const Octree<Dim>& tree, const Execution& execution)
  : Depths(tree.GetNumberOfInternalNodes() << Dim)
{
  constexpr std::size_t grain = 32; // Blocks, with 2^Dim searches each.
  const auto numberOfDepths = static_cast<std::size_t>(tree.GetDeepestDepth()) + 1;
  execution.For(tree.GetNumberOfInternalNodes(), grain,
    [&](std::size_t firstBlock, std::size_t lastBlock)
    {
      std::vector<Neighbor<Dim>> found;
      DepthHistogram above;
      for (std::size_t block = firstBlock; block < lastBlock; ++block)
      {
        for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
        {
          const MortonKey<Dim> node = tree.GetBlockKey(block).GetChild(octant);
          // Case 3 looks for leaves just above more often than not.
          FindAdjacentLeaves(tree, node, MortonKey<Dim>::MaxDepth, found);
          above.assign(numberOfDepths, 0);
          for (const Neighbor<Dim>& neighbor : found)
          {
            if (neighbor.Key.GetDepth() < node.GetDepth())
            {
              ++above[static_cast<std::size_t>(neighbor.Key.GetDepth())];
            }
          }
          this->Depths[block << Dim | octant] = static_cast<std::uint8_t>(GetMedianDepth(above));
        }
      }
    });
}

#define HASHEDOCTREE_INSTANTIATE(Dim) template class NodeStartDepths<Dim>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
