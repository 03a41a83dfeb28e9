// SPDX-License-Identifier: MIT
#include "host/localization/gyro_odometry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

using geometry::degrees;
using geometry::Pose2;
using geometry::radians;

/// A robot whose wheels say that it turns by `wheel_share` of what it does, and whose gyro drifts.
class GyroRobot {
 public:
  explicit GyroRobot(double wheel_share, double bias_rad_per_s)
      : wheel_share_(wheel_share), bias_rad_per_s_(bias_rad_per_s) {
    odometry_.update(T_odom_robot_, yaw_);
  }

  void move(double turn_rad, double forward_m, double duration_s) {
    T_true_ = T_true_ * Pose2(0.0, 0.0, turn_rad) * Pose2(forward_m, 0.0, 0.0);
    T_odom_robot_ =
        T_odom_robot_ * Pose2(0.0, 0.0, wheel_share_ * turn_rad) * Pose2(forward_m, 0.0, 0.0);
    yaw_.yaw_rad += turn_rad + bias_rad_per_s_ * duration_s;
    yaw_.measured_s += duration_s;
    odometry_.update(T_odom_robot_, yaw_);
  }
  /// Turns on its way, and the wheels do not say so.
  void veer(double turn_rad, double forward_m, double duration_s) {
    T_true_ = T_true_ * Pose2(0.0, 0.0, turn_rad);
    yaw_.yaw_rad += turn_rad;
    move(0.0, forward_m, duration_s);
  }
  double heading_error_deg() const {
    return degrees(
        geometry::angle_between(T_true_.heading_rad(), odometry_.T_start_robot().heading_rad()));
  }
  double error_m() const {
    return (T_true_.position_m() - odometry_.T_start_robot().position_m()).norm();
  }
  double wheel_error_m() const {
    return (T_true_.position_m() - T_odom_robot_.position_m()).norm();
  }

 private:
  double wheel_share_;
  double bias_rad_per_s_;
  GyroOdometry odometry_;
  Pose2 T_true_;
  Pose2 T_odom_robot_;
  sensors::Yaw yaw_;
};

TEST(GyroOdometry, FollowsTheWheelsWithoutAGyro) {
  GyroOdometry odometry;
  const Pose2 T_odom_robot(0.4, -0.2, 2.0);
  odometry.update({0.3, 0.1, 1.0}, std::nullopt);
  const Pose2 T_start_robot = odometry.update(T_odom_robot, std::nullopt);
  EXPECT_NEAR(T_start_robot.x_m(), 0.4, 1e-12);
  EXPECT_NEAR(T_start_robot.y_m(), -0.2, 1e-12);
  EXPECT_NEAR(T_start_robot.heading_rad(), 2.0, 1e-12);
}

TEST(GyroOdometry, TurnsAsTheGyroSaysWhereTheWheelsSlip) {
  GyroRobot robot(0.8, 0.0);
  robot.move(0.0, 0.0, 10.0);
  for (int side = 0; side < 4; ++side) {
    robot.move(0.0, 1.0, 5.0);
    robot.move(0.5 * std::numbers::pi, 0.0, 2.0);
  }
  EXPECT_NEAR(robot.heading_error_deg(), 0.0, 1.0);
  EXPECT_LT(robot.error_m(), 0.05);
  EXPECT_GT(robot.wheel_error_m(), 0.3);
}

TEST(GyroOdometry, LearnsTheGyrosBiasWhileTheRobotStands) {
  GyroRobot robot(1.0, radians(2.0));
  robot.move(0.0, 0.0, 13.0);
  for (int i = 0; i < 10; ++i) {
    robot.move(radians(50.0), 0.0, 2.0);
    robot.move(0.0, 0.5, 3.0);
    robot.move(0.0, 0.0, 13.0);
  }
  EXPECT_NEAR(robot.heading_error_deg(), 0.0, 2.0);
}

// Wheels of unlike size, which the wheels themselves do not see, must not pass for the gyro's bias.
TEST(GyroOdometry, TakesNoVeeringForTheGyrosBias) {
  GyroRobot robot(1.0, radians(2.0));
  robot.move(0.0, 0.0, 13.0);
  for (int i = 0; i < 10; ++i) {
    robot.veer(radians(1.3), 0.6, 4.0);
    robot.move(0.0, 0.0, 17.0);
  }
  EXPECT_NEAR(robot.heading_error_deg(), 0.0, 6.0);
}

TEST(GyroOdometry, TakesATurnRoundForOneEitherWay) {
  for (const double turn_deg : {179.0, -179.0}) {
    GyroRobot robot(1.02, 0.0);
    robot.move(0.0, 0.0, 13.0);
    robot.move(radians(turn_deg), 0.0, 3.0);
    EXPECT_NEAR(robot.heading_error_deg(), 0.0, 4.0) << turn_deg;
  }
}

}  // namespace
}  // namespace echomap::localization
