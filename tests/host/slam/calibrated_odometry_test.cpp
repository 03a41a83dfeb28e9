// SPDX-License-Identifier: MIT
#include "host/slam/calibrated_odometry.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

TEST(CalibratedOdometry, IsOdometryUntilItIsCalibrated) {
  CalibratedOdometry odometry;
  EXPECT_EQ(odometry.follow({0.3, 0.1, 2.0}).heading_rad(), 2.0);
  EXPECT_EQ(odometry.T_calibrated_odom().heading_rad(), 0.0);
}

TEST(CalibratedOdometry, TurnsByItsShareMoreFromThenOn) {
  CalibratedOdometry odometry;
  odometry.follow({0.0, 0.0, 0.5});
  odometry.calibrate({{0.1, 0.0, 0.0}});
  EXPECT_NEAR(odometry.follow({0.0, 0.0, 1.5}).heading_rad(), 1.6, 1e-12);
  const Pose2 driven = odometry.follow(Pose2(0.0, 0.0, 1.5) * Pose2(1.0, 0.0, 0.0));
  EXPECT_NEAR(driven.x_m(), std::cos(1.6), 1e-12) << "in the direction in which it points";
  EXPECT_NEAR(driven.y_m(), std::sin(1.6), 1e-12);
}

TEST(CalibratedOdometry, TakesACarriedRobotForOneThatDidNotTurn) {
  CalibratedOdometry odometry;
  odometry.calibrate({{0.1, 0.0, 0.0}});
  EXPECT_NEAR(odometry.carry({0.0, 0.0, 1.0}).heading_rad(), 1.0, 1e-12);
  EXPECT_NEAR(odometry.follow({0.0, 0.0, 2.0}).heading_rad(), 2.1, 1e-12);
}

}  // namespace
}  // namespace echomap::slam
