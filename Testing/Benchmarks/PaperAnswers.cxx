// SPDX-License-Identifier: BSD-3-Clause
#include "PaperAnswers.h"

namespace paper_benchmark
{
void CheckAnswers(
  const PaperPeers& peers, const std::vector<float>& points, double radius, PaperResults& results)
{
  PaperPeer& ours = *peers[OursMedian];
  const auto check = [&results](const auto& answer, const auto& expected)
  {
    ++results.CheckedAnswers;
    results.DifferentAnswers += answer == expected ? 0 : 1;
  };
  const std::size_t step = (results.Points - 1) / CheckedLeaves + 1;
  for (std::size_t i = 0; i < results.Points; i += step)
  {
    const std::uint64_t leaf = ours.GetLeaf(&points[3 * i]);
    for (const auto& peer : peers)
    {
      check(peer->GetLeaf(&points[3 * i]), leaf);
    }
  }
  for (std::size_t i = 0; i < CheckedNeighborhoods; ++i)
  {
    const auto adjacent = ours.GetAdjacent(i);
    const auto inRadius = ours.GetInRadius(i, radius);
    for (const auto& peer : peers)
    {
      check(peer->GetAdjacent(i), adjacent);
      check(peer->GetInRadius(i, radius), inRadius);
    }
  }
}
}
