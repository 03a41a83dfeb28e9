// SPDX-License-Identifier: MIT
#include "firmware/control/proportion.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "firmware/control/fixed_point.hpp"

namespace echomap::control {
namespace {

TEST(Proportion, EqualWaysAreEqualSteps) {
  Proportion proportion;
  proportion.start(protocol::kMaxMoveTicks, protocol::kMaxMoveTicks);
  for (const std::int32_t step : {0, 1, 4001, 512000}) {
    EXPECT_EQ(proportion.scale(step), step);
  }
}

TEST(Proportion, NothingOfAWayIsNothing) {
  Proportion proportion;
  proportion.start(0, 1000);
  EXPECT_EQ(proportion.scale(512000), 0);
}

TEST(Proportion, SumIsRightToATenthOfATick) {
  std::mt19937 generator(6);
  for (int i = 0; i < 300; ++i) {
    const auto whole = static_cast<std::int32_t>(1 + generator() % protocol::kMaxMoveTicks);
    const auto part = static_cast<std::int32_t>(generator() % (static_cast<unsigned>(whole) + 1U));
    Proportion proportion;
    proportion.start(part, whole);
    std::int64_t left = std::int64_t{whole} * kOneTick;
    double sum = 0.0;
    while (left > 0) {
      const auto wanted = static_cast<std::int64_t>(generator() % 500000);
      const auto step = static_cast<std::int32_t>(std::min(left, wanted));
      sum += proportion.scale(step);
      left -= step;
    }
    ASSERT_LE(std::abs(sum / kOneTick - part), 0.1) << part << " of " << whole;
  }
}

}  // namespace
}  // namespace echomap::control
