// SPDX-License-Identifier: MIT
#include "host/pipeline/slam_track.hpp"

#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

void SlamTrack::follow(const geometry::Pose2& T_odom_robot) {
  method_->follow(T_odom_robot);
  instants_.push_back({T_odom_robot, scans()});
}

void SlamTrack::add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) {
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
  for (const Instant& instant : instants_) {
    poses.push_back(T_map_odom(instant, T_map_scans) * instant.T_odom_robot);
  }
  return poses;
}

std::vector<geometry::Pose2> SlamTrack::T_map_odom_at(std::span<const std::size_t> instants) const {
  const std::vector<geometry::Pose2> T_map_scans = method_->trajectory();
  std::vector<geometry::Pose2> corrections;
  corrections.reserve(instants.size());
  for (const std::size_t instant : instants) {
    corrections.push_back(instant < instants_.size() ? T_map_odom(instants_[instant], T_map_scans)
                                                     : T_map_odom_);
  }
  return corrections;
}

geometry::Pose2 SlamTrack::T_map_odom(const Instant& instant,
                                      const std::vector<geometry::Pose2>& T_map_scans) const {
  if (instant.scans == 0) {
    return {};
  }
  return T_map_scans[instant.scans - 1] * T_odom_scans_[instant.scans - 1].inverse();
}

}  // namespace echomap::pipeline
