// SPDX-License-Identifier: BSD-3-Clause
#include "NodeIndex.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

TEST(TestNodeIndex, MoreNodesThanAreNumberedAreAnError)
{
  EXPECT_NO_THROW(RequireNodeIndices(0));
  EXPECT_NO_THROW(RequireNodeIndices(4294967295));
  EXPECT_THROW(RequireNodeIndices(4294967296), std::length_error);
}
