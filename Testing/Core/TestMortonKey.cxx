// SPDX-License-Identifier: BSD-3-Clause
#include "MortonKey.h"

#include "Dimensions.h"

#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestMortonKey : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** A cell of the grid at `depth`. */
  Cell<Dim> MakeCell(int depth)
  {
    Cell<Dim> cell;
    for (std::uint32_t& coordinate : cell)
    {
      coordinate = static_cast<std::uint32_t>(this->Random() & ((std::uint64_t(1) << depth) - 1));
    }
    return cell;
  }

  std::mt19937_64 Random{ 7 };
};
TYPED_TEST_SUITE(TestMortonKey, Dimensions);

TEST(TestMortonKeyFacts, MaxDepth)
{
  EXPECT_EQ(MortonKey<1>::MaxDepth, 31);
  EXPECT_EQ(MortonKey<2>::MaxDepth, 31);
  EXPECT_EQ(MortonKey<3>::MaxDepth, 21);
  EXPECT_EQ(MortonKey<4>::MaxDepth, 15);
}

TEST(TestMortonKeyFacts, GoldenKeys)
{
  // x is the high bit of an octant (paper Figs. 2 and 4): bottom-left, top-left, bottom-right,
  // top-right.
  EXPECT_EQ((MortonKey<2>::FromCell({ 0, 0 }, 1).GetValue()), 0b100U);
  EXPECT_EQ((MortonKey<2>::FromCell({ 0, 1 }, 1).GetValue()), 0b101U);
  EXPECT_EQ((MortonKey<2>::FromCell({ 1, 0 }, 1).GetValue()), 0b110U);
  EXPECT_EQ((MortonKey<2>::FromCell({ 1, 1 }, 1).GetValue()), 0b111U);
  EXPECT_EQ((MortonKey<3>::FromCell({ 1, 0, 0 }, 1).GetValue()), 0b1100U);
  EXPECT_EQ((MortonKey<3>::FromCell({ 0, 1, 0 }, 1).GetValue()), 0b1010U);
  EXPECT_EQ((MortonKey<3>::FromCell({ 0, 0, 1 }, 1).GetValue()), 0b1001U);
  // x = 5 = 101, y = 3 = 011, z = 6 = 110: octants xyz = 101, 011, 110.
  EXPECT_EQ((MortonKey<3>::FromCell({ 5, 3, 6 }, 3).GetValue()), 0b1101011110U);
  EXPECT_EQ(
    (MortonKey<3>::FromCell({ 0x1fffff, 0x1fffff, 0x1fffff }, 21).GetValue()), 0xffffffffffffffffU);
}

TYPED_TEST(TestMortonKey, RootHasKeyOneAndDepthZero)
{
  using Key = MortonKey<TestFixture::Dim>;
  EXPECT_EQ(Key::Root().GetValue(), 1U);
  EXPECT_EQ(Key::Root().GetDepth(), 0);
  EXPECT_EQ(Key::FromCell({}, 0), Key::Root());
}

TYPED_TEST(TestMortonKey, ChildrenAppendTheirOctant)
{
  using Key = MortonKey<TestFixture::Dim>;
  Key key = Key::Root();
  for (int depth = 1; depth <= Key::MaxDepth; ++depth)
  {
    const Key parent = key;
    for (unsigned octant = 0; octant < static_cast<unsigned>(Key::NumberOfOctants); ++octant)
    {
      const Key child = parent.GetChild(octant);
      EXPECT_EQ(child.GetValue(), parent.GetValue() * Key::NumberOfOctants + octant);
      EXPECT_EQ(child.GetParent(), parent);
      EXPECT_EQ(child.GetOctant(), octant);
      EXPECT_EQ(child.GetDepth(), depth);
    }
    key = parent.GetChild(static_cast<unsigned>(this->Random() % Key::NumberOfOctants));
  }
}

TYPED_TEST(TestMortonKey, KeyFromPositionEqualsKeyFromDescent)
{
  using Key = MortonKey<TestFixture::Dim>;
  constexpr int dim = TestFixture::Dim;
  for (int depth = 0; depth <= Key::MaxDepth; ++depth)
  {
    for (int trial = 0; trial < 50; ++trial)
    {
      const Cell<dim> cell = this->MakeCell(depth);
      Key descended = Key::Root();
      for (int bit = depth - 1; bit >= 0; --bit)
      {
        unsigned octant = 0;
        for (int axis = 0; axis < dim; ++axis)
        {
          octant = octant << 1 | (cell[axis] >> bit & 1U);
        }
        descended = descended.GetChild(octant);
      }
      ASSERT_EQ(Key::FromCell(cell, depth), descended);
      ASSERT_EQ(descended.GetCell(), cell);
      ASSERT_EQ(descended.GetDepth(), depth);
    }
  }
}

TYPED_TEST(TestMortonKey, AncestorsOfAKeyAtMaxDepth)
{
  using Key = MortonKey<TestFixture::Dim>;
  for (int trial = 0; trial < 100; ++trial)
  {
    const Key key = Key::FromCell(this->MakeCell(Key::MaxDepth), Key::MaxDepth);
    Key ancestor = key;
    for (int depth = Key::MaxDepth; depth >= 0; --depth)
    {
      ASSERT_EQ(key.AtDepth(depth), ancestor);
      ASSERT_TRUE(ancestor.GetFirstAtMaxDepth() <= key);
      ASSERT_TRUE(key <= ancestor.GetLastAtMaxDepth());
      ASSERT_EQ(ancestor.GetFirstAtMaxDepth().AtDepth(depth), ancestor);
      ASSERT_EQ(ancestor.GetLastAtMaxDepth().AtDepth(depth), ancestor);
      ancestor = ancestor.GetParent();
    }
  }
}

TYPED_TEST(TestMortonKey, SiblingsTileTheirParent)
{
  using Key = MortonKey<TestFixture::Dim>;
  const Key parent = Key::FromCell(this->MakeCell(Key::MaxDepth / 2), Key::MaxDepth / 2);
  std::uint64_t next = parent.GetFirstAtMaxDepth().GetValue();
  for (unsigned octant = 0; octant < static_cast<unsigned>(Key::NumberOfOctants); ++octant)
  {
    EXPECT_EQ(parent.GetChild(octant).GetFirstAtMaxDepth().GetValue(), next);
    next = parent.GetChild(octant).GetLastAtMaxDepth().GetValue() + 1;
  }
  EXPECT_EQ(next - 1, parent.GetLastAtMaxDepth().GetValue());
}

TYPED_TEST(TestMortonKey, CommonDepth)
{
  using Key = MortonKey<TestFixture::Dim>;
  for (int depth = 0; depth <= Key::MaxDepth; ++depth)
  {
    const Key a = Key::FromCell(this->MakeCell(Key::MaxDepth), Key::MaxDepth);
    // Another octant right below `depth`, and anything further down.
    const std::uint64_t scramble = depth == Key::MaxDepth
      ? 0
      : (std::uint64_t(1) << (TestFixture::Dim * (Key::MaxDepth - depth - 1))) |
        (this->Random() &
          ((std::uint64_t(1) << (TestFixture::Dim * (Key::MaxDepth - depth - 1))) - 1));
    const Key b(a.GetValue() ^ scramble);
    EXPECT_EQ(Key::GetCommonDepth(a, b), depth);
    EXPECT_EQ(Key::GetCommonDepth(b, a), depth);
  }
}
