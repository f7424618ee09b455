// SPDX-License-Identifier: BSD-3-Clause
#include "DepthDecisionTree.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hashedoctree
{
/** The cheapest tree over each range of depths [first, last), from those of shorter ranges. */
class DepthDecisionTree::CheapestTrees
{
public:
  explicit CheapestTrees(const DepthHistogram& histogram)
    : Ends(histogram.size() + 1)
    , Trees(this->Ends * this->Ends)
  {
    const int end = static_cast<int>(histogram.size());
    for (int last = 1; last <= end; ++last)
    {
      WeightSum weight = 0;
      for (int first = last - 1; first >= 0; --first)
      {
        weight += histogram[static_cast<std::size_t>(first)];
        this->Trees[this->GetPlace(first, last)] = this->Join(first, last, weight);
      }
    }
  }

  struct Tree
  {
    WeightSum Weight = 0; ///< Of all depths of the range.
    WeightSum Cost = 0;   ///< Looks, times their weights.
    int Root = 0;
  };
  const Tree& Get(int first, int last) const { return this->Trees[this->GetPlace(first, last)]; }

private:
  std::size_t GetPlace(int first, int last) const
  {
    return static_cast<std::size_t>(first) * this->Ends + static_cast<std::size_t>(last);
  }

  /** All of the weight looks at the root, and each side goes on in its own tree. */
  Tree Join(int first, int last, WeightSum weight) const
  {
    Tree best;
    for (int root = first; root < last; ++root)
    {
      const WeightSum cost = weight + this->Get(first, root).Cost + this->Get(root + 1, last).Cost;
      const auto distance = [first, last](int depth)
      { return std::abs(2 * depth + 1 - first - last); };
      if (root == first || cost < best.Cost ||
        (cost == best.Cost && distance(root) < distance(best.Root)))
      {
        best = { weight, cost, root };
      }
    }
    return best;
  }

  std::size_t Ends;
  std::vector<Tree> Trees;
};

DepthDecisionTree::DepthDecisionTree(const DepthHistogram& histogram)
{
  const CheapestTrees trees(histogram.empty() ? DepthHistogram{ 0 } : histogram);
  this->Depths.resize(std::max<std::size_t>(histogram.size(), 1));
  const int end = static_cast<int>(this->Depths.size());
  const CheapestTrees::Tree& all = trees.Get(0, end);
  this->Root = all.Root;
  this->MeanCost =
    all.Weight > 0 ? static_cast<double>(all.Cost) / static_cast<double>(all.Weight) : 0.0;
  this->Place(trees, 0, end, 1);
}

void DepthDecisionTree::Place(const CheapestTrees& trees, int first, int last, int cost)
{
  if (first == last)
  {
    return;
  }
  const int root = trees.Get(first, last).Root;
  this->Depths[static_cast<std::size_t>(root)] = { first < root ? trees.Get(first, root).Root
                                                                : root - 1,
    root + 1 < last ? trees.Get(root + 1, last).Root : root + 1, cost };
  this->Place(trees, first, root, cost + 1);
  this->Place(trees, root + 1, last, cost + 1);
}

double GetEntropyBound(const DepthHistogram& histogram)
{
  const auto total = static_cast<double>(GetTotal(histogram));
  double entropy = 0.0;
  for (const std::uint64_t weight : histogram)
  {
    if (weight > 0)
    {
      const double share = static_cast<double>(weight) / total;
      entropy -= share * std::log(share);
    }
  }
  return entropy / std::log(3.0);
}
}
