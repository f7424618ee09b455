// SPDX-License-Identifier: BSD-3-Clause
#include "DepthTally.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

namespace
{
using Tally = DepthTally<2>;
using Octants = Octree<2>::Octants;

Octants MakeOctants(OctantMask<2> occupied, OctantMask<2> internal)
{
  return { 0, internal, occupied };
}
}

TEST(TestDepthTally, ChildrenThatAreNotInternalAreLeaves)
{
  Tally tally;
  tally.AddChildren(1, MakeOctants(0b0111, 0b0001), 5);
  tally.AddChildren(2, MakeOctants(0b1000, 0b0000), 3);
  const DepthCounts counts = tally.GetCounts();
  EXPECT_EQ(counts.Leaves, (DepthHistogram{ 0, 3, 4 }));
  EXPECT_EQ(counts.EmptyLeaves, (DepthHistogram{ 0, 1, 3 }));
  EXPECT_EQ(counts.Points, (DepthHistogram{ 0, 5, 3 }));
}

TEST(TestDepthTally, PartsAddUp)
{
  Tally sum;
  sum.AddChildren(1, MakeOctants(0b1111, 0b0011), 2);
  Tally part;
  part.AddChildren(1, MakeOctants(0b0011, 0b0001), 1);
  part.AddChildren(3, MakeOctants(0b0001, 0b0000), 7);
  sum.Add(part);
  const DepthCounts counts = sum.GetCounts();
  EXPECT_EQ(counts.Leaves, (DepthHistogram{ 0, 5, 0, 4 }));
  EXPECT_EQ(counts.EmptyLeaves, (DepthHistogram{ 0, 2, 0, 3 }));
  EXPECT_EQ(counts.Points, (DepthHistogram{ 0, 3, 0, 7 }));
}

TEST(TestDepthTally, HistogramsEndWithTheDeepestLeaf)
{
  EXPECT_TRUE(Tally().GetCounts().Leaves.empty());
  Tally tally;
  tally.AddChildren(MortonKey<2>::MaxDepth, MakeOctants(0b0001, 0b0000), 1);
  EXPECT_EQ(tally.GetCounts().Leaves.size(), static_cast<std::size_t>(MortonKey<2>::MaxDepth) + 1);
  EXPECT_EQ(tally.GetCounts().Points.back(), 1U);
}
