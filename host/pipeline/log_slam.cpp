// SPDX-License-Identifier: MIT
#include "host/pipeline/log_slam.hpp"

#include <variant>

namespace echomap::pipeline {

slam::RangeScan slam_scan(const datasets::RangeScan& scan) {
  slam::RangeScan taken{scan.T_robot_sensor, {}, scan.beam_opening_rad, scan.max_range_m};
  taken.beams.reserve(scan.beams.size());
  for (const datasets::Beam& beam : scan.beams) {
    taken.beams.push_back({beam.bearing_rad, beam.range_m});
  }
  return taken;
}

void LogSlam::add(const datasets::LogRecord& record) {
  if (poses_.follow(record)) {
    const geometry::Pose2 T_log_robot = *poses_.T_map_robot();
    if (instants_.empty() && std::holds_alternative<datasets::OdometryPose>(record)) {
      T_log_odom_ = T_log_robot;
    }
    T_odom_robot_ = T_log_odom_.inverse() * T_log_robot;
    instants_.push_back({T_odom_robot_, scans()});
    return;
  }
  const auto* scan = std::get_if<datasets::RangeScan>(&record);
  if (scan == nullptr) {
    return;
  }
  method_->add(T_odom_robot_, slam_scan(*scan));
  T_odom_scans_.push_back(T_odom_robot_);
  if (!instants_.empty()) {
    instants_.back().scans = scans();
  }
}

std::vector<geometry::Pose2> LogSlam::trajectory() const {
  const std::vector<geometry::Pose2> T_map_scans = method_->trajectory();
  std::vector<geometry::Pose2> poses;
  poses.reserve(instants_.size());
  for (const Instant& instant : instants_) {
    if (instant.scans == 0) {
      poses.push_back(T_log_odom_ * instant.T_odom_robot);
    } else {
      const std::size_t last = instant.scans - 1;
      const geometry::Pose2 T_scan_robot = T_odom_scans_[last].inverse() * instant.T_odom_robot;
      poses.push_back(T_log_odom_ * T_map_scans[last] * T_scan_robot);
    }
  }
  return poses;
}

}  // namespace echomap::pipeline
