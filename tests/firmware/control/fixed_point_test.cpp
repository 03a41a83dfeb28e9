// SPDX-License-Identifier: MIT
#include "firmware/control/fixed_point.hpp"

#include <gtest/gtest.h>

namespace echomap::control {
namespace {

TEST(FixedPoint, ASecondOfStepsIsTheSpeedInTicks) {
  for (const int speed : {-32000, -1, 0, 1, 3300, 32000}) {
    const auto ticks_per_s = static_cast<std::int16_t>(speed);
    EXPECT_EQ(per_period(ticks_per_s) * kControlHz, speed * kOneTick);
    EXPECT_EQ(ticks_per_second(per_period(ticks_per_s)), speed);
  }
}

TEST(FixedPoint, AccelerationIsNeverZero) {
  EXPECT_GE(change_per_period(0), 1);
  EXPECT_NEAR(change_per_period(6000), 6000.0 * kOneTick / kControlHz / kControlHz, 1.0);
  EXPECT_NEAR(change_per_period(65535), 65535.0 * kOneTick / kControlHz / kControlHz, 1.0);
}

}  // namespace
}  // namespace echomap::control
