// SPDX-License-Identifier: MIT
#include "hil_mock/world/pan_servo.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::world {
namespace {

constexpr double kQuarterRad = 0.5 * std::numbers::pi;

TEST(PanServo, LooksToTheLeftForLongerPulses) {
  PanServo servo({.slew_rad_per_s = 100.0});
  servo.step(1.0, 1500.0 + 450.0);
  EXPECT_NEAR(servo.pan_rad(), 0.5 * kQuarterRad, 1e-12);
  servo.step(1.0, 1500.0 - 900.0);
  EXPECT_NEAR(servo.pan_rad(), -kQuarterRad, 1e-3);
}

TEST(PanServo, TurnsNoFasterThanItCan) {
  PanServo servo({.slew_rad_per_s = 2.0});
  servo.step(0.25, 2400.0);
  EXPECT_DOUBLE_EQ(servo.pan_rad(), 0.5);
  servo.step(0.25, 600.0);
  EXPECT_DOUBLE_EQ(servo.pan_rad(), 0.0);
}

TEST(PanServo, StaysAtItsStopAndWithoutPulses) {
  PanServo servo({.slew_rad_per_s = 100.0, .limit_rad = 1.0});
  servo.step(1.0, 2500.0);
  EXPECT_DOUBLE_EQ(servo.pan_rad(), 1.0);
  servo.step(1.0, 0.0);
  EXPECT_DOUBLE_EQ(servo.pan_rad(), 1.0);
}

TEST(PanServo, RefusesAScaleOfZero) {
  EXPECT_THROW(PanServo({.us_per_90deg = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::world
