// SPDX-License-Identifier: MIT
#include "host/slam/odometry_meter.hpp"

#include <cmath>

namespace echomap::slam {

namespace {

/// Motion at once that is more than this is a jump.
constexpr double kJumpM = 1.0;
constexpr double kJumpRad = 1.0;

}  // namespace

bool is_jump(const geometry::Pose2& T_before_after) {
  return T_before_after.position_m().norm() > kJumpM ||
         std::abs(T_before_after.heading_rad()) > kJumpRad;
}

OdometryPiece piece_between(const OdometryMark& before, const OdometryMark& after) {
  return {before.T_odom_robot.inverse() * after.T_odom_robot,
          after.path_m - before.path_m,
          after.turn_rad - before.turn_rad,
          after.turned_rad - before.turned_rad,
          after.jumped_m - before.jumped_m,
          after.jumped_rad - before.jumped_rad};
}

void OdometryMeter::follow(const geometry::Pose2& T_odom_robot) { step_to(T_odom_robot, false); }

void OdometryMeter::carry(const geometry::Pose2& T_odom_robot) { step_to(T_odom_robot, true); }

void OdometryMeter::step_to(const geometry::Pose2& T_odom_robot, bool is_carried) {
  const geometry::Pose2 T_before_after = mark_.T_odom_robot.inverse() * T_odom_robot;
  mark_.T_odom_robot = T_odom_robot;
  if (!has_begun_) {
    has_begun_ = true;
    return;
  }
  const double step_m = T_before_after.position_m().norm();
  const double turn_rad = T_before_after.heading_rad();
  if (is_carried || is_jump(T_before_after)) {
    mark_.jumped_m += step_m;
    mark_.jumped_rad += std::abs(turn_rad);
    return;
  }
  mark_.path_m += step_m;
  mark_.turn_rad += turn_rad;
  mark_.turned_rad += std::abs(turn_rad);
}

}  // namespace echomap::slam
