// SPDX-License-Identifier: BSD-3-Clause
#include "StartDepths.h"

#include "ForEachDimension.h"

#include <algorithm>
#include <cstdlib>

namespace hashedoctree
{
namespace
{
/** Calls function(leaf, weight) for each leaf in the part of a tree whose root is internal, with
 * the weight that the leaf has in a frequency model. */
template <int Dim, typename Function>
void ForEachLeaf(const TreePart<Dim>& part, FrequencyModel frequency, const Function& function)
{
  const Octree<Dim>& tree = part.GetTree();
  tree.ForEachChild(0, tree.GetNumberOfInternalNodes(),
    [&](const typename Octree<Dim>::Node& child)
    {
      if (!child.Internal && part.Has(child.NodeKey))
      {
        const int height = part.GetDeepestDepth() - child.NodeKey.GetDepth();
        function(child,
          frequency == FrequencyModel::Leaves   ? 1
            : frequency == FrequencyModel::Grid ? std::uint64_t(1) << (Dim * height)
                                                : child.GetNumberOfPoints());
      }
    });
}
}

template <int Dim>
StartDepths<Dim>::StartDepths(const TreePart<Dim>& part, const StartDepthOptions& options)
  : Everywhere(GetStartDepth(part.GetDepthCounts(), options, Dim))
{
  if (options.Model == StartDepthModel::Local)
  {
    this->ChooseLocal(part, options.Frequency);
  }
}

template <int Dim>
void StartDepths<Dim>::ChooseLocal(const TreePart<Dim>& part, FrequencyModel frequency)
{
  this->CellDepth = std::min(LocalDepth, part.GetDeepestDepth());
  const std::size_t numberOfCells = std::size_t(1) << (Dim * this->CellDepth);
  const auto numberOfDepths = static_cast<std::size_t>(part.GetDeepestDepth()) + 1;
  std::vector<std::uint64_t> weights(numberOfCells * numberOfDepths);
  std::vector<std::uint64_t> leaves(numberOfCells * numberOfDepths);
  ForEachLeaf(part, frequency,
    [&](const typename Octree<Dim>::Node& leaf, std::uint64_t weight)
    {
      const auto depth = static_cast<std::size_t>(leaf.NodeKey.GetDepth());
      const std::size_t last = this->GetCoarseCell(leaf.NodeKey.GetLastAtMaxDepth());
      for (auto cell = this->GetCoarseCell(leaf.NodeKey.GetFirstAtMaxDepth()); cell <= last; ++cell)
      {
        weights[cell * numberOfDepths + depth] += weight;
        ++leaves[cell * numberOfDepths + depth];
      }
    });
  part.AddUp(weights);
  part.AddUp(leaves);
  this->Local.resize(numberOfCells);
  DepthHistogram histogram;
  const auto read = [&](const std::vector<std::uint64_t>& ofCells, std::size_t cell)
  {
    const std::uint64_t* first = &ofCells[cell * numberOfDepths];
    histogram.assign(first, first + numberOfDepths);
  };
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    read(weights, cell);
    if (GetTotal(histogram) == 0)
    {
      read(leaves, cell); // Places without points have a depth, too.
    }
    this->Local[cell] = static_cast<std::uint8_t>(GetMedianDepth(histogram));
  }
}

template <int Dim>
double StartDepths<Dim>::GetMeanCost(const TreePart<Dim>& part, FrequencyModel frequency) const
{
  if (this->Local.empty() || !part.GetTree().IsRootInternal())
  {
    return hashedoctree::GetMeanCost(
      GetDepthHistogram(part.GetDepthCounts(), frequency, Dim), this->Everywhere);
  }
  DepthHistogram distances(MortonKey<Dim>::MaxDepth + 1, 0);
  ForEachLeaf(part, frequency,
    [this, &distances](const typename Octree<Dim>::Node& leaf, std::uint64_t weight)
    {
      // All coarse cells in one leaf have one start depth.
      const int startDepth = this->Get(leaf.NodeKey.GetFirstAtMaxDepth());
      distances[static_cast<std::size_t>(std::abs(leaf.NodeKey.GetDepth() - startDepth))] += weight;
    });
  part.AddUp(distances);
  return hashedoctree::GetMeanCost(distances, 0);
}

#define HASHEDOCTREE_INSTANTIATE(Dim) template class StartDepths<Dim>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
