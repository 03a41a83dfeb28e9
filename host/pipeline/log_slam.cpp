// SPDX-License-Identifier: MIT
#include "host/pipeline/log_slam.hpp"

#include <variant>

#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

void LogSlam::add(const datasets::LogRecord& record) {
  if (poses_.follow(record)) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): follow() has just set it
    const geometry::Pose2 T_log_robot = *poses_.T_map_robot();
    if (track_.instants() == 0 && std::holds_alternative<datasets::OdometryPose>(record)) {
      T_log_odom_ = T_log_robot;
    }
    T_odom_robot_ = T_log_odom_.inverse() * T_log_robot;
    track_.follow(T_odom_robot_);
  } else if (const auto* scan = std::get_if<sensors::RangeScan>(&record)) {
    track_.add(T_odom_robot_, *scan);
  }
}

std::vector<geometry::Pose2> LogSlam::trajectory() const {
  std::vector<geometry::Pose2> poses = track_.trajectory();
  for (geometry::Pose2& pose : poses) {
    pose = T_log_odom_ * pose;
  }
  return poses;
}

}  // namespace echomap::pipeline
