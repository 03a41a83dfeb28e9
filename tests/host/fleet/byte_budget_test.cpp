// SPDX-License-Identifier: MIT
#include "host/fleet/byte_budget.hpp"

#include <cstddef>

#include <gtest/gtest.h>

namespace echomap::fleet {
namespace {

TEST(ByteBudget, GivesABurstAndThenItsRate) {
  ByteBudget budget(100.0, 1000.0);
  std::size_t spent = 0;
  for (int tenth = 0; tenth < 1000; ++tenth) {
    budget.advance_to(0.1 * tenth);
    while (budget.has_some()) {
      budget.spend(30);
      spent += 30;
    }
  }
  EXPECT_NEAR(static_cast<double>(spent), 1000.0 + 100.0 * 99.9, 40.0);
}

TEST(ByteBudget, LetsALargeMessagePassAndMissesItAfterwards) {
  ByteBudget budget(100.0, 50.0);
  EXPECT_TRUE(budget.has_some());
  budget.spend(1050);
  budget.advance_to(9.9);
  EXPECT_FALSE(budget.has_some());
  budget.advance_to(10.1);
  EXPECT_TRUE(budget.has_some());
}

TEST(ByteBudget, DoesNotFillByATimeThatGoesBack) {
  ByteBudget budget(100.0, 50.0);
  budget.advance_to(10.0);
  budget.spend(50);
  budget.advance_to(5.0);
  budget.advance_to(10.0);
  EXPECT_FALSE(budget.has_some());
}

}  // namespace
}  // namespace echomap::fleet
