// SPDX-License-Identifier: BSD-3-Clause
#include "Invariants.h"

#include "PointSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace hashedoctree;

/** A sound tree, to be broken in one place. */
class TestInvariants : public ::testing::Test
{
protected:
  PointSample<3, double> Sample{ "clusters", MakeClusteredPoints<3, double>(500, 111) };
  PointSelection<3> Selection{ Sample.GetSpan(), {}, Execution() };
  Octree<3> Tree{ Sample.GetSpan(), Selection, {}, Execution() };

  void MakeTree(const std::vector<double>& coordinates)
  {
    this->Sample = { "made", coordinates };
    this->Selection = PointSelection<3>(this->Sample.GetSpan(), {}, Execution());
    this->Tree = Octree<3>(this->Sample.GetSpan(), this->Selection, {}, Execution());
    ASSERT_TRUE(FindBrokenLaws(this->Tree, this->Sample.GetSpan(), this->Selection).empty());
  }

  // A tree is immutable to its users; a test that breaks one must reach behind that.
  Octree<3>::Block& GetBlock(std::size_t block)
  {
    return const_cast<Octree<3>::Block&>(this->Tree.GetBlock(block));
  }
  Octree<3>::Octants& GetOctants(std::size_t block)
  {
    return const_cast<Octree<3>::Octants&>(this->Tree.GetOctants(block));
  }
  MortonKey<3>& GetKey(std::size_t block)
  {
    return const_cast<MortonKey<3>&>(this->Tree.GetBlockKey(block));
  }
  Octree<3>::Entry& GetEntry(std::size_t block)
  {
    return const_cast<Octree<3>::Entry&>(
      *this->Tree.GetTable().Find(this->GetKey(block).GetValue()));
  }
  PointIndex* GetIds() { return const_cast<PointIndex*>(this->Tree.GetPointIds()); }
  NodeTable<Octree<3>::Entry>& GetTable()
  {
    return const_cast<NodeTable<Octree<3>::Entry>&>(this->Tree.GetTable());
  }
  DepthCounts& GetCounts() { return const_cast<DepthCounts&>(this->Tree.GetDepthCounts()); }

  void ExpectBroken(const std::string& law)
  {
    const std::vector<std::string> laws =
      FindBrokenLaws(this->Tree, this->Sample.GetSpan(), this->Selection);
    bool named = false;
    for (const std::string& broken : laws)
    {
      named = named || broken.find(law) == 0;
    }
    EXPECT_TRUE(named) << law << " is not among " << ::testing::PrintToString(laws);
  }
};

TEST_F(TestInvariants, SoundTreeBreaksNone)
{
  EXPECT_EQ(FindBrokenLaws(this->Tree, this->Sample.GetSpan(), this->Selection),
    std::vector<std::string>());
}

TEST(TestInvariantsFacts, SoundTreeOfFewDepthsBreaksNone)
{
  const PointSample<3, double> sample{ "uniform", MakeUniformPoints<3, double>(50, 112) };
  const PointSelection<3> selection(sample.GetSpan(), {}, Execution());
  const Octree<3> tree(sample.GetSpan(), selection, { 1, 3 }, Execution());
  ASSERT_EQ(tree.GetDeepestDepth(), 3);
  EXPECT_EQ(FindBrokenLaws(tree, sample.GetSpan(), selection), std::vector<std::string>());
}

TEST_F(TestInvariants, MovedPoint)
{
  this->Sample.Coordinates[3 * 77] += 0.1;
  this->ExpectBroken("each point lies in the cell of its leaf");
}

TEST_F(TestInvariants, LostPoint)
{
  this->Sample.Coordinates.insert(this->Sample.Coordinates.end(), { 0.3, 0.3, 0.3 });
  this->ExpectBroken("just the selected points take part");
}

TEST_F(TestInvariants, TreeOfFewerPoints)
{
  this->Sample.Coordinates.insert(this->Sample.Coordinates.end(), { 0.3, 0.3, 0.3 });
  this->Selection = PointSelection<3>(this->Sample.GetSpan(), {}, Execution());
  this->ExpectBroken("the root's range is all points");
}

TEST_F(TestInvariants, DoubledId)
{
  this->GetIds()[3] = this->GetIds()[4];
  this->ExpectBroken("each point stands in the order once");
}

TEST_F(TestInvariants, IdOfNoPoint)
{
  this->GetIds()[3] = static_cast<PointIndex>(this->Sample.GetSpan().Count);
  const std::vector<std::string> laws =
    FindBrokenLaws(this->Tree, this->Sample.GetSpan(), this->Selection);
  ASSERT_EQ(laws.size(), 1U) << ::testing::PrintToString(laws);
  EXPECT_EQ(laws[0].find("each point stands in the order once"), 0U) << laws[0];
}

TEST_F(TestInvariants, SwappedIds)
{
  std::swap(this->GetIds()[10], this->GetIds()[200]);
  this->ExpectBroken("each point lies in the cell of its leaf");
}

TEST_F(TestInvariants, SwappedIdsOfCoincidentPoints)
{
  this->MakeTree({ 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1 });
  for (const std::size_t place : { 1U, 2U })
  {
    std::swap(this->GetIds()[place], this->GetIds()[place + 1]);
    this->ExpectBroken("points of equal keys stand by id");
    std::swap(this->GetIds()[place], this->GetIds()[place + 1]);
  }
}

TEST_F(TestInvariants, ShiftedRange)
{
  this->GetBlock(5).FirstPoint[3] += 1;
  this->ExpectBroken("ranges partition the points");
}

TEST_F(TestInvariants, RangeBeyondThePoints)
{
  for (std::size_t block = 0; block < this->Tree.GetNumberOfInternalNodes(); ++block)
  {
    PointIndex& end = this->GetBlock(block).FirstPoint.back();
    const PointIndex sound = end;
    end += 1000000; // What stands there must not be looked at.
    this->ExpectBroken("ranges partition the points");
    end = sound;
  }
}

TEST_F(TestInvariants, FlippedInternalBit)
{
  this->GetOctants(5).Internal ^= 1U;
  this->ExpectBroken(
    "a node is internal just when it holds more than MaxPointsPerLeaf points above MaxDepth");
}

TEST_F(TestInvariants, BlockThatIsNotReached)
{
  const unsigned internal = this->GetOctants(0).Internal;
  this->GetOctants(0).Internal = static_cast<OctantMask<3>>(internal & (internal - 1U));
  this->ExpectBroken("every block is reached from the root");
}

TEST_F(TestInvariants, FlippedOccupiedBit)
{
  this->GetOctants(5).Occupied ^= 1U;
  this->ExpectBroken("keys and masks agree");
}

TEST_F(TestInvariants, WrongFirstChild)
{
  this->GetOctants(0).FirstChild += 1;
  this->ExpectBroken("keys and masks agree");
}

TEST_F(TestInvariants, BlocksThatAreNotFollowed)
{
  // What is beyond the last one must not be looked at, and a circle must end.
  for (const std::uint32_t wrong : { 1U << 30, 0U })
  {
    Octree<3>::Octants& octants = this->GetOctants(0);
    const std::uint32_t sound = octants.FirstChild;
    octants.FirstChild = wrong;
    this->ExpectBroken("keys and masks agree");
    octants.FirstChild = sound;
  }
}

TEST_F(TestInvariants, CellsOfNoLeaf)
{
  // Two points below the root's first child, or its last, which is not followed.
  for (const double place : { 0.0, 1.0 })
  {
    const double x = std::abs(place - 0.1);
    this->MakeTree({ 0, 0, 0, 1, 1, 1, x, x, x });
    this->GetOctants(0).FirstChild = 1U << 30;
    this->ExpectBroken("the leaves tile the root");
  }
}

TEST_F(TestInvariants, SwappedBlocks)
{
  // The root has two internal children, and each of these has one.
  this->MakeTree({ 0, 0, 0, 0.2, 0.2, 0.2, 0.8, 0.8, 0.8, 1, 1, 1 });
  ASSERT_EQ(this->Tree.GetNumberOfInternalNodes(), 5U);
  std::swap(this->GetEntry(3).Block, this->GetEntry(4).Block);
  std::swap(this->GetBlock(3), this->GetBlock(4));
  std::swap(this->GetOctants(3), this->GetOctants(4));
  std::swap(this->GetKey(3), this->GetKey(4));
  this->GetOctants(1).FirstChild = 4;
  this->GetOctants(2).FirstChild = 3;
  this->ExpectBroken("blocks are ordered by depth, then by key");
}

TEST_F(TestInvariants, WrongTableEntry)
{
  this->GetEntry(7).Block += 1;
  this->ExpectBroken("the table finds every node");
}

TEST_F(TestInvariants, WrongTableMask)
{
  this->GetEntry(7).Occupied ^= 4U;
  this->ExpectBroken("keys and masks agree");
}

TEST_F(TestInvariants, ForeignKeyInTheTable)
{
  this->GetTable().Insert(0xabcdef, Octree<3>::Entry{ 0, 0, 0 });
  this->ExpectBroken("the table holds nothing else");
}

TEST_F(TestInvariants, LeafInTheTable)
{
  std::size_t block = 0;
  while (this->Tree.GetOctants(block).Internal == 0xff)
  {
    ++block;
  }
  unsigned leaf = 0;
  while (this->Tree.GetChild(block, leaf).Internal)
  {
    ++leaf;
  }
  this->GetTable().Insert(
    this->Tree.GetChild(block, leaf).NodeKey.GetValue(), Octree<3>::Entry{ 0, 0, 0 });
  this->ExpectBroken("the table finds nothing else");
}

TEST_F(TestInvariants, CountsOfADepthWithoutLeaves)
{
  // Above the last depth that a tree may have.
  Octree<3>::Options options;
  options.MaxDepth = 10;
  this->Tree = Octree<3>(this->Sample.GetSpan(), this->Selection, options, Execution());
  DepthCounts& counts = this->GetCounts();
  for (auto* numbers : { &counts.Leaves, &counts.EmptyLeaves, &counts.Points })
  {
    numbers->push_back(0);
  }
  this->ExpectBroken("the counts end at the deepest leaf");
}

TEST_F(TestInvariants, CountsOfTooFewDepths)
{
  this->GetCounts().Points.pop_back();
  this->ExpectBroken("the counts end at the deepest leaf");
}

TEST_F(TestInvariants, WrongCounts)
{
  this->GetCounts().EmptyLeaves[3] += 1;
  this->ExpectBroken("the counts per depth are those of the leaves");
}
