// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_ToldProgress_h
#define Testing_Support_ToldProgress_h

#include "OnThisThread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

/** What a computation on one thread tells of its progress. */
class ToldProgress
{
public:
  hashedoctree::Execution MakeExecution()
  {
    return hashedoctree::Execution(OnThisThread,
      [this](double fraction)
      {
        this->Fractions.push_back(fraction);
        return true;
      });
  }

  /** Within 0 and 1, and told so many times at least. */
  void ExpectToRise(std::size_t times) const
  {
    ASSERT_GE(this->Fractions.size(), times);
    EXPECT_TRUE(std::is_sorted(this->Fractions.begin(), this->Fractions.end()))
      << ::testing::PrintToString(this->Fractions);
    EXPECT_GE(this->Fractions.front(), 0.0);
    EXPECT_LE(this->Fractions.back(), 1.0);
  }

  const std::vector<double>& GetFractions() const { return this->Fractions; }

private:
  std::vector<double> Fractions;
};

#endif
