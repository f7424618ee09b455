// SPDX-License-Identifier: BSD-3-Clause
#include "StopSign.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

TEST(TestStopSign, IsUpForThoseMadeBefore)
{
  StopSign::Count stops{ 3 };
  const StopSign never;
  const StopSign before(stops);
  EXPECT_FALSE(before.IsUp());
  ++stops;
  const StopSign between(stops);
  EXPECT_TRUE(before.IsUp());
  EXPECT_FALSE(between.IsUp());
  ++stops;
  EXPECT_TRUE(before.IsUp()) << "and stays up";
  EXPECT_TRUE(between.IsUp());
  EXPECT_FALSE(never.IsUp());
}
