// SPDX-License-Identifier: MIT
#include "host/exploration/unwinding_turn.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;
using geometry::radians;

double turn_deg(double heading_deg, double target_deg) {
  return degrees(unwinding_turn_rad(radians(heading_deg), radians(target_deg)));
}

TEST(UnwindingTurn, TakesTheShorterWayUpToARightAngle) {
  EXPECT_NEAR(turn_deg(10.0, 80.0), 70.0, 1e-9);
  EXPECT_NEAR(turn_deg(170.0, -170.0), 20.0, 1e-9);
}

TEST(UnwindingTurn, GoesRoundByTheHeadingOfTheStartWhereItIsLonger) {
  EXPECT_NEAR(turn_deg(120.0, -120.0), -240.0, 1e-9);
  EXPECT_NEAR(turn_deg(-100.0, 80.0), 180.0, 1e-9);
}

TEST(UnwindingTurn, LeadsToTheTargetWhateverTheHeading) {
  std::mt19937 random(1);
  const auto any_rad = [&] {
    return geometry::wrap_angle(static_cast<double>(random() % 6283) * 1e-3);
  };
  for (int i = 0; i < 1000; ++i) {
    const double heading_rad = any_rad();
    const double target_rad = any_rad();
    const double end_rad = heading_rad + unwinding_turn_rad(heading_rad, target_rad);
    EXPECT_NEAR(geometry::angle_between(end_rad, target_rad), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace echomap::exploration
