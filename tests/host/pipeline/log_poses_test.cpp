// SPDX-License-Identifier: MIT
#include "host/pipeline/log_poses.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {
namespace {

using datasets::GivenPose;
using datasets::Heading;
using datasets::OdometryPose;
using datasets::OdometryStep;
using datasets::WheelIncrement;
using geometry::Pose2;

constexpr double kRightAngleRad = std::numbers::pi / 2.0;

void expect_near(const std::optional<Pose2>& pose, const Pose2& wanted) {
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x_m(), wanted.x_m(), 1e-12);
  EXPECT_NEAR(pose->y_m(), wanted.y_m(), 1e-12);
  EXPECT_NEAR(pose->heading_rad(), wanted.heading_rad(), 1e-12);
}

TEST(LogPoses, OdometryBeginsAtTheOriginAndTakesEveryKindOfRecord) {
  LogPoses poses(PoseSource::kOdometry);
  expect_near(poses.T_map_robot(), {});
  EXPECT_TRUE(poses.follow(OdometryStep{{}, {1.0, 0.0, kRightAngleRad}}));
  EXPECT_TRUE(poses.follow(WheelIncrement{{}, 0.5, 0.5, 0.2}));
  expect_near(poses.T_map_robot(), {1.0, 0.5, kRightAngleRad});
  EXPECT_TRUE(poses.follow(OdometryPose{{}, {7.0, 8.0, 0.0}}));
  expect_near(poses.T_map_robot(), {7.0, 8.0, 0.0});
  EXPECT_FALSE(poses.follow(GivenPose{{}, {1.0, 1.0, 1.0}}));
  EXPECT_FALSE(poses.follow(sensors::RangeScan{}));
  EXPECT_EQ(poses.odometry_records(), 3U);
  EXPECT_EQ(poses.given_records(), 1U);
}

TEST(LogPoses, WheelsAloneTurnByTheirDifferenceAndAGyroKnowsBetter) {
  LogPoses wheels(PoseSource::kOdometry);
  wheels.follow(WheelIncrement{{}, -0.1, 0.1, 0.2});
  EXPECT_NEAR(wheels.T_map_robot()->heading_rad(), 1.0, 1e-12);

  LogPoses gyro(PoseSource::kOdometry);
  gyro.follow(Heading{{}, 3.0});
  gyro.follow(WheelIncrement{{}, 0.0, 0.0, 0.2});
  EXPECT_FALSE(gyro.follow(Heading{{}, -3.0}));
  gyro.follow(WheelIncrement{{}, -0.1, 0.1, 0.2});
  EXPECT_NEAR(gyro.T_map_robot()->heading_rad(), 2.0 * std::numbers::pi - 6.0, 1e-12);
}

TEST(LogPoses, OdometryGoesOnBetweenGivenPoses) {
  LogPoses poses(PoseSource::kGiven);
  EXPECT_FALSE(poses.follow(OdometryStep{{}, {5.0, 0.0, 0.0}}));
  EXPECT_FALSE(poses.T_map_robot()) << "before the first given pose";
  EXPECT_TRUE(poses.follow(GivenPose{{}, {1.0, 1.0, kRightAngleRad}}));
  expect_near(poses.T_map_robot(), {1.0, 1.0, kRightAngleRad});
  EXPECT_TRUE(poses.follow(OdometryStep{{}, {0.5, 0.0, 0.0}}));
  expect_near(poses.T_map_robot(), {1.0, 1.5, kRightAngleRad});
}

}  // namespace
}  // namespace echomap::pipeline
