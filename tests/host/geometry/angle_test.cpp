// SPDX-License-Identifier: MIT
#include "host/geometry/angle.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(WrapAngle, KeepsPiAndTurnsMinusPiIntoIt) {
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
  EXPECT_EQ(wrap_angle(0.0), 0.0);
}

TEST(WrapAngle, GivesTheSameDirectionWithinOneTurn) {
  for (double angle_rad = -30.0; angle_rad < 30.0; angle_rad += 0.37) {
    const double wrapped_rad = wrap_angle(angle_rad);
    EXPECT_GT(wrapped_rad, -kPi);
    EXPECT_LE(wrapped_rad, kPi);
    EXPECT_NEAR(std::sin(wrapped_rad), std::sin(angle_rad), 1e-12);
    EXPECT_NEAR(std::cos(wrapped_rad), std::cos(angle_rad), 1e-12);
  }
}

TEST(WrapAngle, LeavesAnAngleWithinTheTurnAsItIsToTheLastBit) {
  for (const double angle_rad : {3.141592653589793, -3.1415926535897927, 1e-300, 0.1, -2.5}) {
    EXPECT_EQ(wrap_angle(angle_rad), angle_rad);
  }
}

TEST(WrapAngle, IsTheRemainderToTheLastBit) {
  for (double angle_rad = -25.0; angle_rad < 25.0; angle_rad += 0.0137) {
    EXPECT_EQ(wrap_angle(angle_rad), std::remainder(angle_rad, 2.0 * kPi)) << angle_rad;
  }
}

TEST(AngleBetween, TakesTheShortWayAcrossTheBack) {
  EXPECT_NEAR(angle_between(radians(170.0), radians(-170.0)), radians(20.0), 1e-12);
  EXPECT_NEAR(angle_between(radians(-170.0), radians(170.0)), radians(-20.0), 1e-12);
}

TEST(Degrees, UndoRadians) { EXPECT_NEAR(degrees(radians(123.4)), 123.4, 1e-12); }

}  // namespace
}  // namespace echomap::geometry
