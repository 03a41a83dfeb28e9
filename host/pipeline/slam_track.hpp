// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::pipeline {

/// A robot's way by its odometry, with the scans on it that SLAM places. Between scans, and behind
/// the last one, the odometry goes on from where SLAM has it.
class SlamTrack {
 public:
  /// `method` has to live as long.
  explicit SlamTrack(slam::SlamMethod& method) : method_(&method) {}

  /// The next instant of the way.
  void follow(const geometry::Pose2& T_odom_robot);
  /// A scan that belongs to the last instant, or is from before the first; the robot may have gone
  /// on a little since then.
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan);

  /// From where odometry has the robot to where SLAM has it, after the last scan.
  const geometry::Pose2& T_map_odom() const { return T_map_odom_; }
  /// Where the robot was at every instant, as it is known now.
  std::vector<geometry::Pose2> trajectory() const;
  /// From where odometry had the robot at those instants to where SLAM has it now; instants to come
  /// are as the last one.
  std::vector<geometry::Pose2> T_map_odom_at(std::span<const std::size_t> instants) const;
  std::size_t instants() const { return instants_.size(); }
  std::size_t scans() const { return T_odom_scans_.size(); }

 private:
  struct Instant {
    geometry::Pose2 T_odom_robot;
    std::size_t scans = 0;  ///< Taken up to then.
  };

  geometry::Pose2 T_map_odom(const Instant& instant,
                             const std::vector<geometry::Pose2>& T_map_scans) const;

  slam::SlamMethod* method_;
  geometry::Pose2 T_map_odom_;
  std::vector<Instant> instants_;
  std::vector<geometry::Pose2> T_odom_scans_;
};

}  // namespace echomap::pipeline
