// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"
#include "host/pipeline/log_poses.hpp"
#include "host/pipeline/slam_track.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::pipeline {

/// Feeds a log's odometry and scans to a way of doing SLAM, as if it began at the origin:
/// coordinates of a country have no digits left for centimetres. Scans before any odometry were
/// taken where it begins. What the log itself says of the robot's true pose is not looked at.
class LogSlam {
 public:
  /// `method` has to live as long.
  explicit LogSlam(slam::SlamMethod& method) : track_(method) {}

  void add(const datasets::LogRecord& record);
  /// Where the robot was at every record that says something of its place, with the scans that
  /// follow it, as it is known now. From one scan to the next its odometry goes on. Empty where
  /// the log has no odometry.
  std::vector<geometry::Pose2> trajectory() const;
  /// From SLAM's map to the frame of the log's odometry, which `trajectory` is in.
  const geometry::Pose2& T_log_map() const { return T_log_odom_; }
  std::size_t scans() const { return track_.scans(); }

 private:
  SlamTrack track_;
  LogPoses poses_{PoseSource::kOdometry};
  geometry::Pose2 T_log_odom_;  ///< Where the log's odometry begins.
  geometry::Pose2 T_odom_robot_;
};

}  // namespace echomap::pipeline
