// SPDX-License-Identifier: MIT
#include "host/models/odometry_motion.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::models {
namespace {

using geometry::Pose2;

/// The pose that a step leads to.
Pose2 after(const Pose2& before, const OdometryStep& step) {
  return before * Pose2(0.0, 0.0, step.turn_before_rad) * Pose2(step.drive_m, 0.0, 0.0) *
         Pose2(0.0, 0.0, step.turn_after_rad);
}

TEST(OdometryStep, LeadsFromOnePoseToTheOther) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 before(any(random), any(random), any(random));
    const Pose2 wanted(any(random), any(random), any(random));
    const Pose2 reached = after(before, odometry_step(before, wanted));
    ASSERT_LT((reached.position_m() - wanted.position_m()).norm(), 1e-9) << i;
    ASSERT_NEAR(geometry::angle_between(reached.heading_rad(), wanted.heading_rad()), 0.0, 1e-9)
        << i;
  }
}

TEST(OdometryStep, DrivesBackwardsRatherThanTurningRound) {
  const OdometryStep step = odometry_step({}, {-0.5, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(step.drive_m, -0.5);
  EXPECT_NEAR(step.turn_before_rad, 0.0, 1e-12);
  EXPECT_NEAR(step.turn_after_rad, 0.0, 1e-12);
}

TEST(OdometryStep, TakesLessThanAMillimetreForATurnOnTheSpot) {
  const OdometryStep step = odometry_step({}, {0.0, 0.0005, 2.0});
  EXPECT_DOUBLE_EQ(step.turn_before_rad, 2.0);
  EXPECT_DOUBLE_EQ(step.turn_after_rad, 0.0);
}

TEST(OdometryMotion, SpreadsByTheSquaresOfTableFiveSix) {
  const OdometryMotion motion({.alpha1 = 0.01,
                               .alpha2_rad2_per_m2 = 0.02,
                               .alpha3 = 0.03,
                               .alpha4_m2_per_rad2 = 0.04,
                               .side_slip = 0.05});
  const MotionSpread spread = motion.spread({0.5, 2.0, -1.0});
  EXPECT_DOUBLE_EQ(spread.turn_before_rad, std::sqrt(0.01 * 0.25 + 0.02 * 4.0));
  EXPECT_DOUBLE_EQ(spread.turn_after_rad, std::sqrt(0.01 * 1.0 + 0.02 * 4.0));
  EXPECT_DOUBLE_EQ(spread.drive_m, std::sqrt(0.03 * 4.0 + 0.04 * 1.25));
  EXPECT_DOUBLE_EQ(spread.side_m, std::sqrt(0.05 * 4.0));
}

TEST(OdometryMotion, IsSureOfARobotThatStands) {
  const MotionSpread spread = OdometryMotion().spread({});
  EXPECT_EQ(spread.drive_m, 0.0);
  EXPECT_EQ(spread.turn_before_rad, 0.0);
}

TEST(OdometryMotion, RefusesVariancesThatAreNone) {
  EXPECT_THROW(OdometryMotion({.alpha1 = -0.1}), std::invalid_argument);
  EXPECT_THROW(OdometryMotion({.side_slip = std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
