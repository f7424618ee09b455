// SPDX-License-Identifier: BSD-3-Clause
#include "NeighborBuffer.h"

#include "Dimensions.h"

#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestNeighborBuffer : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  template <typename Machine>
  static void ExpectLeavesInOrder(Machine machine)
  {
    using Key = MortonKey<Dim>;
    std::mt19937 random(71);
    const Neighbor<Dim> first{ Key(5), 6 };
    std::vector<Neighbor<Dim>> found(1, first);
    std::vector<Neighbor<Dim>> expected(1, first);
    NeighborBuffer<Dim> buffer(found);
    for (std::uint32_t block = 0; block < 1000; ++block) // Far more than it holds.
    {
      // All children every now and then, and none.
      const auto octants =
        static_cast<std::uint32_t>(block % 100 < 30 ? (1U << Key::NumberOfOctants) - 1U
                                                    : random() % (1U << Key::NumberOfOctants));
      const Key node(1 + random() % 1000);
      if (block % 100 > 90)
      {
        buffer.Add({ node, block });
        expected.push_back({ node, block });
      }
      buffer.AddChildren(machine, node, octants, block);
      for (unsigned octant = 0; octant < Key::NumberOfOctants; ++octant)
      {
        if ((octants >> octant & 1U) != 0)
        {
          expected.push_back({ node.GetChild(octant), block });
        }
      }
    }
    buffer.Flush();
    buffer.Flush(); // There is nothing left.
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_EQ(found[i].Key, expected[i].Key) << i;
      ASSERT_EQ(found[i].ParentBlock, expected[i].ParentBlock) << i;
    }
  }
};
TYPED_TEST_SUITE(TestNeighborBuffer, Dimensions);

TYPED_TEST(TestNeighborBuffer, AppendsLeavesInOrder)
{
  this->ExpectLeavesInOrder(PlainMachine());
}

#if defined(__x86_64__)
TYPED_TEST(TestNeighborBuffer, AppendsLeavesInOrderByAvx2)
{
  if (!HasAvx2())
  {
    GTEST_SKIP() << "this machine has no AVX2 instructions, so there are no vectors to test";
  }
  this->ExpectLeavesInOrder(Avx2Machine());
}
#endif

TYPED_TEST(TestNeighborBuffer, TakesAnyNumberOfLeavesOneByOne)
{
  constexpr int dim = TypeParam::value;
  std::vector<Neighbor<dim>> found;
  NeighborBuffer<dim> buffer(found);
  for (std::uint32_t block = 0; block < 1000; ++block)
  {
    buffer.Add({ MortonKey<dim>(1 + block), block });
  }
  buffer.Flush();
  ASSERT_EQ(found.size(), 1000U);
  for (std::uint32_t block = 0; block < 1000; ++block)
  {
    ASSERT_EQ(found[block].Key, MortonKey<dim>(1 + block));
    ASSERT_EQ(found[block].ParentBlock, block);
  }
}
