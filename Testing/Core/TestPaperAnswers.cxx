// SPDX-License-Identifier: BSD-3-Clause
#include "PaperAnswers.h"

#include <gtest/gtest.h>

using namespace paper_benchmark;

namespace
{
/** Answers from what it is asked for, but for one answer of each kind that may be another. */
class InventedPeer : public PaperPeer
{
public:
  std::size_t OtherLeafOf = SIZE_MAX;
  std::size_t OtherAdjacentOf = SIZE_MAX;
  std::size_t OtherInRadiusOf = SIZE_MAX;

  std::uint64_t FindLeaves(const std::vector<float>&) override { return 0; }
  void SetLeaves(const std::vector<Key>&) override {}
  std::uint64_t FindAdjacent() override { return 0; }
  std::uint64_t FindInRadius(double) override { return 0; }
  std::uint64_t GetLeaf(const float* point) override
  {
    const auto leaf = static_cast<std::size_t>(*point);
    return leaf == this->OtherLeafOf ? 0 : 1 + leaf;
  }
  Keys GetAdjacent(std::size_t leaf) override
  {
    return leaf == this->OtherAdjacentOf ? Keys{ leaf } : Keys{ leaf, leaf + 1 };
  }
  Keys GetInRadius(std::size_t leaf, double radius) override
  {
    return leaf == this->OtherInRadiusOf ? Keys{} : Keys{ leaf + static_cast<std::size_t>(radius) };
  }
};

constexpr std::size_t NumberOfPoints = 2 * CheckedLeaves; // Every other one is searched for.

/** The results of comparing peers of which one has these answers of its own. */
PaperResults Compare(std::size_t leaf, std::size_t adjacent, std::size_t inRadius)
{
  PaperPeers peers;
  for (std::size_t i = 0; i < NumberOfPeers; ++i)
  {
    auto peer = std::make_unique<InventedPeer>();
    if (i == PaperStart)
    {
      peer->OtherLeafOf = leaf;
      peer->OtherAdjacentOf = adjacent;
      peer->OtherInRadiusOf = inRadius;
    }
    peers.push_back(std::move(peer));
  }
  std::vector<float> points(3 * NumberOfPoints);
  for (std::size_t i = 0; i < NumberOfPoints; ++i)
  {
    points[3 * i] = static_cast<float>(i);
  }
  PaperResults results;
  results.Points = NumberOfPoints;
  CheckAnswers(peers, points, 7.0, results);
  return results;
}
}

TEST(TestPaperAnswers, AnswersOfAllPeersAreCompared)
{
  const PaperResults results = Compare(SIZE_MAX, SIZE_MAX, SIZE_MAX);
  EXPECT_EQ(results.CheckedAnswers, NumberOfPeers * (CheckedLeaves + 2 * CheckedNeighborhoods));
  EXPECT_EQ(results.DifferentAnswers, 0U);
}

TEST(TestPaperAnswers, EachThatDiffersIsCounted)
{
  EXPECT_EQ(Compare(500, SIZE_MAX, SIZE_MAX).DifferentAnswers, 1U);
  EXPECT_EQ(Compare(SIZE_MAX, 0, SIZE_MAX).DifferentAnswers, 1U);
  EXPECT_EQ(Compare(SIZE_MAX, SIZE_MAX, CheckedNeighborhoods - 1).DifferentAnswers, 1U);
  EXPECT_EQ(Compare(0, 1, 2).DifferentAnswers, 3U);
}
