// SPDX-License-Identifier: BSD-3-Clause
#include "StartDepths.h"

#include <algorithm>

namespace hashedoctree
{
template <int Dim>
StartDepths<Dim>::StartDepths(const Octree<Dim>& tree, const StartDepthOptions& options)
  : Everywhere(
      GetStartDepth(GetDepthHistogram(tree.GetDepthCounts(), options.Frequency, Dim), options))
{
  if (options.Model == StartDepthModel::Local)
  {
    this->ChooseLocal(tree, options.Frequency);
  }
}

template <int Dim>
void StartDepths<Dim>::ChooseLocal(const Octree<Dim>& tree, FrequencyModel frequency)
{
  constexpr std::size_t numberOfCells = std::size_t(1) << (Dim * LocalDepth);
  const int deepest = tree.GetDeepestDepth();
  const auto numberOfDepths = static_cast<std::size_t>(deepest) + 1;
  std::vector<std::uint64_t> weights(numberOfCells * numberOfDepths);
  for (std::size_t block = 0; block < tree.GetNumberOfInternalNodes(); ++block)
  {
    for (unsigned octant = 0; octant < Octree<Dim>::NumberOfOctants; ++octant)
    {
      const auto child = tree.GetChild(block, octant);
      if (child.Internal)
      {
        continue;
      }
      const int depth = child.NodeKey.GetDepth();
      // Places without points have a depth, too.
      const std::uint64_t weight = frequency == FrequencyModel::Leaves ? 1
        : frequency == FrequencyModel::Points
        ? std::max<std::uint64_t>(child.GetNumberOfPoints(), 1)
        : std::uint64_t(1) << (Dim * (deepest - depth));
      const std::size_t last = GetCoarseCell(child.NodeKey.GetLastAtMaxDepth());
      for (auto cell = GetCoarseCell(child.NodeKey.GetFirstAtMaxDepth()); cell <= last; ++cell)
      {
        weights[cell * numberOfDepths + static_cast<std::size_t>(depth)] += weight;
      }
    }
  }
  this->Local.resize(numberOfCells);
  DepthHistogram histogram;
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    const std::uint64_t* first = &weights[cell * numberOfDepths];
    histogram.assign(first, first + numberOfDepths);
    this->Local[cell] = static_cast<std::uint8_t>(GetMedianDepth(histogram));
  }
}

template class StartDepths<1>;
template class StartDepths<2>;
template class StartDepths<3>;
template class StartDepths<4>;
}
