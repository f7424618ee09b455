// SPDX-License-Identifier: BSD-3-Clause
#include "RankedPoints.h"

#include "ClosestFew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace hashedoctree;

class TestRankedPoints : public ::testing::TestWithParam<bool>
{
protected:
  static constexpr std::size_t MostAdded = RankedPoints::MostAdded;

  void SetUp() override
  {
    if (GetParam() && !ClosestFew::HasVectors())
    {
      GTEST_SKIP() << "this machine has no AVX2 instructions, so there are no vectors to test";
    }
  }

  static void Merge(RankedPoints& ranked, const std::vector<FoundPoint>& leaf,
    std::vector<PointIndex>& ids, std::uint64_t chosen, std::size_t most)
  {
    std::vector<double> dist2;
    for (const FoundPoint& point : leaf)
    {
      dist2.push_back(point.Dist2);
      ids.push_back(point.Id);
    }
    const PointIndex* first = ids.data() + ids.size() - leaf.size();
    if (GetParam())
    {
      ranked.MergeWithVectors(dist2.data(), first, chosen, most);
    }
    else
    {
      ranked.Merge(dist2.data(), first, chosen, most);
    }
  }

  /** Leaves of all sizes with some of their points, against sorting these; ids in no order, and, as
   * of points at one place, growing in each leaf. */
  static void ExpectSorted(const std::function<double(unsigned)>& makeDist2)
  {
    ExpectSorted(makeDist2, [](unsigned random, unsigned) { return random; });
    ExpectSorted(makeDist2, [](unsigned, unsigned number) { return number; });
  }
  static void ExpectSorted(const std::function<double(unsigned)>& makeDist2,
    const std::function<PointIndex(unsigned, unsigned)>& makeId)
  {
    std::mt19937 random(711);
    for (std::size_t most = 1; most <= RankedPoints::MostKept; most += most < MostAdded ? 1 : 24)
    {
      RankedPoints ranked;
      std::vector<FoundPoint> all;
      std::vector<PointIndex> ids;
      constexpr std::size_t numberOfLeaves = 16;
      ids.reserve(numberOfLeaves * MostAdded); // Their addresses are kept.
      for (std::size_t leafNumber = 0; leafNumber < numberOfLeaves; ++leafNumber)
      {
        std::vector<FoundPoint> leaf(random() % MostAdded + 1);
        std::uint64_t chosen = 0;
        for (std::size_t i = 0; i < leaf.size(); ++i)
        {
          leaf[i] = { makeDist2(static_cast<unsigned>(random())),
            makeId(static_cast<unsigned>(random()), static_cast<unsigned>(ids.size() + i)) };
          if (random() % 3 != 0)
          {
            chosen |= std::uint64_t(1) << i;
            all.push_back(leaf[i]);
          }
        }
        Merge(ranked, leaf, ids, chosen, most);
        std::sort(all.begin(), all.end());
        all.resize(std::min(all.size(), most));
        ASSERT_EQ(ranked.Size, all.size());
        for (std::size_t i = 0; i < all.size(); ++i)
        {
          ASSERT_EQ(ranked.Dist2[i], all[i].Dist2) << most << " kept, place " << i;
          ASSERT_EQ(*ranked.Ids[i], all[i].Id) << most << " kept, place " << i;
        }
      }
    }
  }
};

TEST_P(TestRankedPoints, OfAnyDistance)
{
  ExpectSorted(
    [](unsigned random) { return std::ldexp(random, static_cast<int>(random % 2000) - 1000); });
}

TEST_P(TestRankedPoints, WhoseUpperHalvesAreEqual)
{
  ExpectSorted([](unsigned random) { return 1.0 + 1e-15 * random; });
  ExpectSorted([](unsigned random) { return 1e-320 * random; });
  ExpectSorted([](unsigned random) { return 1.0 + 1e-15 * (random % 9); });
}

TEST_P(TestRankedPoints, AtTheSameDistance)
{
  ExpectSorted([](unsigned) { return 0.0; });
  ExpectSorted([](unsigned) { return std::numeric_limits<double>::infinity(); });
  ExpectSorted([](unsigned random) { return 0.1 * (random % 7); });
}

INSTANTIATE_TEST_SUITE_P(PlainAndWithVectors, TestRankedPoints, ::testing::Bool());
