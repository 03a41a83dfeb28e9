// SPDX-License-Identifier: MIT
#include "host/pipeline/slam_track.hpp"

namespace echomap::pipeline {

void SlamTrack::follow(const geometry::Pose2& T_odom_robot) {
  method_->follow(T_odom_robot);
  instants_.push_back({T_odom_robot, scans()});
}

void SlamTrack::add(const geometry::Pose2& T_odom_robot, const slam::RangeScan& scan) {
  method_->add(T_odom_robot, scan);
  T_map_odom_ = method_->belief().T_map_robot * T_odom_robot.inverse();
  T_odom_scans_.push_back(T_odom_robot);
  if (!instants_.empty()) {
    instants_.back().scans = scans();
  }
}

std::vector<geometry::Pose2> SlamTrack::trajectory() const {
  const std::vector<geometry::Pose2> T_map_scans = method_->trajectory();
  std::vector<geometry::Pose2> poses;
  poses.reserve(instants_.size());
  for (const auto& [T_odom_robot, scans] : instants_) {
    if (scans == 0) {
      poses.push_back(T_odom_robot);
    } else {
      poses.push_back(T_map_scans[scans - 1] * T_odom_scans_[scans - 1].inverse() * T_odom_robot);
    }
  }
  return poses;
}

}  // namespace echomap::pipeline
