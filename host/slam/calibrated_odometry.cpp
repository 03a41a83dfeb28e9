// SPDX-License-Identifier: MIT
#include "host/slam/calibrated_odometry.hpp"

#include "host/slam/odometry_meter.hpp"

namespace echomap::slam {

geometry::Pose2 CalibratedOdometry::follow(const geometry::Pose2& T_odom_robot) {
  OdometryPiece step;
  step.T_before_after = T_odom_robot_.inverse() * T_odom_robot;
  if (calibration_ && !is_jump(step.T_before_after)) {
    step.path_m = step.T_before_after.position_m().norm();
    step.turn_rad = step.T_before_after.heading_rad();
    T_calibrated_odom_ = T_calibrated_odom_ * T_odom_robot_ * calibrated(step, *calibration_) *
                         T_odom_robot.inverse();
  }
  return carry(T_odom_robot);
}

geometry::Pose2 CalibratedOdometry::carry(const geometry::Pose2& T_odom_robot) {
  T_odom_robot_ = T_odom_robot;
  return T_calibrated_odom_ * T_odom_robot;
}

}  // namespace echomap::slam
