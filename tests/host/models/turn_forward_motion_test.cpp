// SPDX-License-Identifier: MIT
#include "host/models/turn_forward_motion.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::models {
namespace {

TEST(TurnForwardMotion, ErrsByTheSameHoweverLongTheMotionIs) {
  const TurnForwardMotion motion;
  for (const double length_m : {0.06, -3.0}) {
    const MotionSpread spread = motion.spread({geometry::radians(20.0), length_m, 0.0});
    EXPECT_NEAR(geometry::degrees(spread.turn_before_rad), 0.25, 1e-4);
    EXPECT_DOUBLE_EQ(spread.drive_m, 0.0005);
    EXPECT_EQ(spread.turn_after_rad, 0.0);
    EXPECT_EQ(spread.side_m, 0.0);
  }
}

TEST(TurnForwardMotion, ARobotThatStandsStaysWhereItIs) {
  const MotionSpread spread = TurnForwardMotion().spread({1e-16, 0.0, -1e-16});
  EXPECT_EQ(spread.turn_before_rad, 0.0);
  EXPECT_EQ(spread.drive_m, 0.0);
  EXPECT_EQ(spread.turn_after_rad, 0.0);
}

TEST(TurnForwardMotion, RefusesNoiseWithoutSense) {
  EXPECT_THROW(TurnForwardMotion({.turn_stddev_rad = -0.1}), std::invalid_argument);
  EXPECT_THROW(TurnForwardMotion({.forward_stddev_m = std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
