// SPDX-License-Identifier: BSD-3-Clause
#include "ClosestFew.h"

#include "PointKernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace hashedoctree;

namespace
{
constexpr std::size_t MostAtOnce = PointKernels<3, float>::MostPoints;

/** Points of one leaf, with infinity behind the distances until their number is a multiple of 4. */
struct Leaf
{
  std::vector<double> Dist2;
  std::vector<PointIndex> Ids;
};

/** Leaves of all sizes. `values` is the number of different distances; one of them is infinite. */
std::vector<Leaf> MakeLeaves(std::mt19937& random, std::size_t numberOfLeaves, unsigned values)
{
  std::vector<PointIndex> ids(numberOfLeaves * MostAtOnce);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<PointIndex>(i);
  }
  std::shuffle(ids.begin(), ids.end(), random);
  std::vector<Leaf> leaves(numberOfLeaves);
  for (Leaf& leaf : leaves)
  {
    const std::size_t size = random() % MostAtOnce + 1;
    leaf.Dist2.assign((size + 3) / 4 * 4, std::numeric_limits<double>::infinity());
    leaf.Ids.assign(ids.end() - static_cast<std::ptrdiff_t>(size), ids.end());
    ids.resize(ids.size() - size);
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto value = static_cast<double>(random() % values);
      leaf.Dist2[i] = value + 1.0 == values ? std::numeric_limits<double>::infinity() : value;
    }
  }
  return leaves;
}

std::vector<FoundPoint> FindClosest(
  const std::vector<Leaf>& leaves, std::size_t wanted, bool useVectors)
{
  const auto select = GetPointKernels<3, float>().Select;
  ClosestFew closest(wanted, select, useVectors);
  for (const Leaf& leaf : leaves)
  {
    const std::uint64_t within = select(leaf.Dist2.data(), leaf.Ids.size(), closest.GetBound2());
    if (within != 0)
    {
      closest.Add(leaf.Dist2.data(), within, leaf.Ids.data(), leaf.Ids.size());
    }
  }
  std::vector<FoundPoint> found;
  closest.CopyTo(found);
  EXPECT_EQ(closest.GetBound2(),
    found.size() < wanted ? std::numeric_limits<double>::infinity() : found.back().Dist2);
  return found;
}

/** Against sorting all points. */
void Check(bool useVectors)
{
  std::mt19937 random(921);
  for (int trial = 0; trial < 300; ++trial)
  {
    const std::vector<Leaf> leaves =
      MakeLeaves(random, random() % 13, trial % 2 == 0 ? 20 : 1000000000);
    std::vector<FoundPoint> all;
    for (const Leaf& leaf : leaves)
    {
      for (std::size_t i = 0; i < leaf.Ids.size(); ++i)
      {
        all.push_back({ leaf.Dist2[i], leaf.Ids[i] });
      }
    }
    std::sort(all.begin(), all.end());
    for (std::size_t wanted = 1; wanted <= ClosestFew::MostWanted; wanted += wanted < 64 ? 1 : 24)
    {
      const std::vector<FoundPoint> found = FindClosest(leaves, wanted, useVectors);
      ASSERT_EQ(found.size(), std::min(wanted, all.size()));
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        ASSERT_EQ(found[i].Id, all[i].Id) << wanted << " wanted, place " << i;
        ASSERT_EQ(found[i].Dist2, all[i].Dist2);
      }
    }
  }
}
}

TEST(TestClosestFew, EqualsSorting)
{
  Check(false);
}

TEST(TestClosestFew, EqualsSortingWithVectors)
{
  if (!ClosestFew::HasVectors())
  {
    GTEST_SKIP() << "this machine has no AVX2 instructions, so there are no vectors to test";
  }
  Check(true);
}
