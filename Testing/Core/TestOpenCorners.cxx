// SPDX-License-Identifier: BSD-3-Clause
#include "OpenCorners.h"

#include "NodeList.h"
#include "NodeWalk.h"
#include "OnThisThread.h"
#include "SampleTree.h"

#include <map>

using namespace hashedoctree;

TEST(TestOpenCorners, KeepsTheNumbersOfTheOpenOnesAndForgetsMostOthers)
{
  const SampleTree<2, double> made({ "many", MakeUniformPoints<2, double>(100000, 128) });
  const auto nodes = ListNodes(made.Tree, NodeListOptions{ true, false }, Execution());
  NodeWalk<2> walk(nodes, 0, Execution());
  OpenCorners<2> open;
  std::map<std::uint64_t, std::uint64_t> expected;
  std::size_t mostBytes = 0;
  std::size_t looks = 0;
  const Execution execution(OnThisThread,
    [&looks](double done)
    {
      EXPECT_EQ(done, 0.5);
      ++looks;
      return true;
    });
  for (std::size_t i = 0; i < nodes.GetSize(); ++i)
  {
    const MortonKey<2> key = nodes[walk.Next()].NodeKey;
    const Cell<2> cell = key.GetCell();
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      const int shift = MortonKey<2>::MaxDepth - key.GetDepth();
      const std::uint64_t code = EncodeCorner<2>(
        { (cell[0] + (corner & 1U)) << shift, (cell[1] + (corner >> 1U)) << shift });
      const auto [place, isNew] = expected.emplace(code, expected.size());
      ASSERT_EQ(open.FindOrInsert(code, expected.size() - (isNew ? 1 : 0), key.GetFirstAtMaxDepth(),
                  execution, 0.5),
        place->second);
    }
    mostBytes = std::max(mostBytes, open.GetBytes());
  }
  EXPECT_LT(mostBytes, NodeTable<std::uint64_t>(expected.size()).GetBytes() / 4);
  // Each shard was full at times, with a report for each.
  EXPECT_GT(looks, 1000U);
}

TEST(TestOpenCorners, IsClearedWithReportsInBetween)
{
  OpenCorners<3> open;
  EXPECT_GT(open.GetBytes(), 0U);
  std::size_t looks = 0;
  open.Clear(Execution(OnThisThread,
    [&looks](double done)
    {
      EXPECT_EQ(done, 1.0);
      ++looks;
      return true;
    }));
  EXPECT_EQ(open.GetBytes(), 0U);
  EXPECT_GT(looks, 10U);
}
