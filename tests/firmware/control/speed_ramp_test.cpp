// SPDX-License-Identifier: MIT
#include "firmware/control/speed_ramp.hpp"

#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

namespace echomap::control {
namespace {

TEST(SpeedRamp, GoesToItsTargetInEqualSteps) {
  SpeedRamp ramp;
  ramp.start(0, 10);
  ramp.set_target(25);
  EXPECT_EQ(ramp.advance(), 10);
  EXPECT_EQ(ramp.advance(), 20);
  EXPECT_EQ(ramp.advance(), 25);
  EXPECT_EQ(ramp.advance(), 25);
}

TEST(SpeedRamp, NeverChangesFasterAndAlwaysArrives) {
  std::mt19937 generator(4);
  SpeedRamp ramp;
  ramp.start(0, 37);
  std::int32_t speed = 0;
  for (int i = 0; i < 200; ++i) {
    const auto target = static_cast<std::int32_t>(generator() % 20001) - 10000;
    ramp.set_target(target);
    for (int step = 0; step < 20000 / 37 + 2; ++step) {
      const std::int32_t next = ramp.advance();
      ASSERT_LE(std::abs(next - speed), 37);
      speed = next;
    }
    ASSERT_EQ(speed, target);
  }
}

TEST(SpeedRamp, BrakesAsHardAsTold) {
  SpeedRamp ramp;
  ramp.start(-100, 10);
  ramp.brake(40);
  EXPECT_EQ(ramp.advance(), -60);
  EXPECT_EQ(ramp.advance(), -20);
  EXPECT_EQ(ramp.advance(), 0);
  EXPECT_TRUE(ramp.at_rest());
}

TEST(SpeedRamp, RestsOnlyAtZero) {
  SpeedRamp ramp;
  ramp.start(5, 10);
  EXPECT_FALSE(ramp.at_rest());
  ramp.set_target(0);
  EXPECT_FALSE(ramp.at_rest());
  ramp.advance();
  EXPECT_TRUE(ramp.at_rest());
}

}  // namespace
}  // namespace echomap::control
