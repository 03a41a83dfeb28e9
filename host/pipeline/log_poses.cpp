// SPDX-License-Identifier: MIT
#include "host/pipeline/log_poses.hpp"

#include "host/geometry/angle.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::pipeline {

bool LogPoses::follow(const datasets::LogRecord& record) {
  return std::visit([this](const auto& kind) { return take(kind); }, record);
}

std::optional<geometry::Pose2> LogPoses::T_map_robot() const {
  if (source_ == PoseSource::kOdometry) {
    return T_odom_robot_;
  }
  return T_map_odom_ ? std::optional(*T_map_odom_ * T_odom_robot_) : std::nullopt;
}

bool LogPoses::take(const datasets::OdometryPose& pose) {
  T_odom_robot_ = pose.T_odom_robot;
  return moved();
}

bool LogPoses::take(const datasets::OdometryStep& step) {
  T_odom_robot_ = T_odom_robot_ * step.T_last_now;
  return moved();
}

bool LogPoses::take(const datasets::WheelIncrement& wheels) {
  // Where there is a gyro, it knows the turn better than wheels that skid.
  const double turn_rad = heading_rad_ && used_heading_rad_
                              ? geometry::angle_between(*used_heading_rad_, *heading_rad_)
                              : (wheels.right_m - wheels.left_m) / wheels.track_m;
  used_heading_rad_ = heading_rad_;
  T_odom_robot_ =
      T_odom_robot_ * sensors::arc_step((wheels.left_m + wheels.right_m) / 2.0, turn_rad);
  return moved();
}

bool LogPoses::take(const datasets::Heading& heading) {
  heading_rad_ = heading.heading_rad;
  return false;
}

bool LogPoses::take(const datasets::GivenPose& pose) {
  ++given_records_;
  T_map_odom_ = pose.T_map_robot * T_odom_robot_.inverse();
  return source_ == PoseSource::kGiven;
}

bool LogPoses::moved() {
  ++odometry_records_;
  return source_ == PoseSource::kOdometry || T_map_odom_;
}

}  // namespace echomap::pipeline
