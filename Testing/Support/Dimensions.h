// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_Dimensions_h
#define Testing_Support_Dimensions_h

#include <gtest/gtest.h>

#include <type_traits>

/** The dimensions that the core is tested in, for typed tests: TypeParam::value. */
using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
  std::integral_constant<int, 3>, std::integral_constant<int, 4>>;

#endif
