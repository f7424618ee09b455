// SPDX-License-Identifier: BSD-3-Clause
#include "PointIndex.h"
#include "PointSamples.h"
#include "Sanitized.h"
#include "TestedFilter.h"

// The sizes of the paper's Table 1. Points are random, so numbers of nodes are known to about one
// part in a thousand.

namespace
{
/** With 32-bit ids; the ranges of points in the blocks are twice as long with 64 bits. */
constexpr double MostBytesPerNode = sizeof(hashedoctree::PointIndex) == 4 ? 10.3 : 15.1;

/** Bytes of the tree for each of its nodes, as the paper counts them. */
double GetBytesPerNode(TestedFilter& filter)
{
  return filter.GetFieldValue("TreeBytes") / filter.GetFieldValue("NumberOfNodes");
}

/** Large trees run the same code as small ones, so sanitizers need not see them. */
class TestHashedOctreeFilterScaleLarge : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (Sanitized)
    {
      GTEST_SKIP() << "too slow under a sanitizer";
    }
  }
};
}

TEST_F(TestHashedOctreeFilterScaleLarge, HalfAMillionPointsOnASphere)
{
  TestedFilter filter(MakeSpherePoints<3, double>(500000, 77));
  filter.Update();
  EXPECT_NEAR(filter.GetFieldValue("NumberOfNodes"), 2.88e6, 0.02e6);
  // The closest pair of points tells how deep the tree is.
  EXPECT_GE(filter.GetFieldValue("DeepestDepth"), 18);
  EXPECT_LE(filter.GetFieldValue("DeepestDepth"), 19);
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), 9);
  EXPECT_LE(GetBytesPerNode(filter), MostBytesPerNode);
}

TEST_F(TestHashedOctreeFilterScaleLarge, FourMillionPointsInACube)
{
  TestedFilter filter(MakeUniformPoints<3, double>(4000000, 71));
  filter.Update();
  EXPECT_NEAR(filter.GetFieldValue("NumberOfNodes"), 15.7e6, 0.1e6);
  EXPECT_EQ(filter.GetFieldValue("StartDepth"), 8);
  EXPECT_LE(GetBytesPerNode(filter), MostBytesPerNode);
}

TEST(TestHashedOctreeFilterScale, TreesHaveFewBytesPerNode)
{
  std::vector<double> line = MakeUniformPoints<3, double>(20000, 72);
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    line[i] = line[i / 3 * 3];
  }
  const std::vector<double> samples[] = { line, MakeClusteredPoints<3, double>(2000, 73),
    MakeUniformPoints<3, double>(300, 74), MakeUniformPoints<3, double>(70000, 75),
    MakeSpherePoints<3, double>(30000, 76) };
  for (const std::vector<double>& coordinates : samples)
  {
    for (const int maxPointsPerLeaf : { 1, 2, 16 })
    {
      TestedFilter filter(coordinates);
      filter->SetMaxPointsPerLeaf(maxPointsPerLeaf);
      filter.Update();
      if (filter.GetFieldValue("NumberOfNodes") >= 1000)
      {
        EXPECT_LE(GetBytesPerNode(filter), MostBytesPerNode)
          << coordinates.size() / 3 << " points, " << maxPointsPerLeaf << " per leaf";
      }
    }
  }
}
