// SPDX-License-Identifier: MIT
#include "host/models/linear_odometry_motion.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/models/uniform_sum.hpp"

namespace echomap::models {
namespace {

TEST(LinearOdometryMotion, HasTheAlphasOfThePaper) {
  const LinearOdometryMotion motion;
  // 360 mm: 0.3 degrees and 9.36 mm; 360 degrees: 1 degree and 0.072 mm. All of these are b.
  const MotionSpread drive = motion.spread({0.0, 0.36, 0.0});
  EXPECT_NEAR(geometry::degrees(uniform_sum_b(drive.turn_before_rad)), 0.3, 1e-5);
  EXPECT_NEAR(uniform_sum_b(drive.drive_m), 0.00936, 1e-9);
  const MotionSpread turn = motion.spread({geometry::radians(360.0), 0.0, 0.0});
  EXPECT_NEAR(geometry::degrees(uniform_sum_b(turn.turn_before_rad)), 1.0, 1e-4);
  EXPECT_NEAR(uniform_sum_b(turn.drive_m), 7.2e-5, 1e-9);
}

TEST(LinearOdometryMotion, IsTheSameBackwardsAndToEitherSide) {
  const LinearOdometryMotion motion;
  const MotionSpread one = motion.spread({0.5, 1.0, -0.2});
  const MotionSpread other = motion.spread({-0.5, -1.0, 0.2});
  EXPECT_DOUBLE_EQ(one.turn_before_rad, other.turn_before_rad);
  EXPECT_DOUBLE_EQ(one.drive_m, other.drive_m);
  EXPECT_DOUBLE_EQ(one.turn_after_rad, other.turn_after_rad);
  EXPECT_GT(one.turn_after_rad, 0.0);
}

TEST(LinearOdometryMotion, RefusesAlphasWithoutSense) {
  EXPECT_THROW(LinearOdometryMotion({.alpha3 = -1.0}), std::invalid_argument);
  EXPECT_THROW(LinearOdometryMotion({.alpha2 = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
