// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/factor_graph.hpp"

namespace echomap::slam {

/// A way to find out at once where a robot is and what is around it, from its odometry and its
/// ranges. The map frame is that of the odometry where it is first told.
class SlamMethod {
 public:
  SlamMethod() = default;
  virtual ~SlamMethod() = default;
  SlamMethod(const SlamMethod&) = delete;
  SlamMethod& operator=(const SlamMethod&) = delete;

  /// Takes where the odometry has the robot between two scans. A method that only looks at scans
  /// need not know.
  virtual void follow(const geometry::Pose2& /*T_odom_robot*/) {}
  /// Somebody has carried the robot to there, in the odometry's frame.
  virtual void carry(const geometry::Pose2& T_odom_robot) { follow(T_odom_robot); }
  /// Takes a scan, and where the odometry had the robot when it was taken. In the order of time.
  virtual void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) = 0;
  /// Where the robot was at the last scan.
  virtual localization::PoseGaussian belief() const = 0;
  /// Where the robot was at each scan that was added, as it is known now: a loop that is closed
  /// moves poses of the past, too.
  virtual std::vector<geometry::Pose2> trajectory() const = 0;
  /// Poses of the way and what is known between them, as it is known now.
  virtual FactorGraph factor_graph() const = 0;
};

}  // namespace echomap::slam
