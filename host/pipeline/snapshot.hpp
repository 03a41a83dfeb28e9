// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/scan_check.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/pipeline/seen_landmark.hpp"
#include "host/sensors/observations.hpp"
#include "host/time/robot_time.hpp"

namespace echomap::pipeline {

/// Where the robot was at one instant. The map frame is the robot's pose when it started.
struct StampedPose {
  time::RobotTime stamp;
  geometry::Pose2 T_map_robot;
};

/// Where the robot is now, without its map.
struct PoseEstimate {
  geometry::Pose2 T_map_robot;
  /// Where the wheels alone place the robot, from where it started.
  geometry::Pose2 T_odom_robot;
  /// Of x, y (m) and heading (rad) in the map frame, as SLAM had it at its last scan; empty without
  /// SLAM.
  std::optional<Eigen::Matrix3d> covariance;
};

/// Everything the pipeline knows at one instant. Immutable and cheap to copy: the large parts are
/// shared and never null.
struct Snapshot {
  StampedPose latest;
  /// Standard deviation of the latest position in the direction in which it is the largest, as SLAM
  /// has it; empty without SLAM.
  std::optional<double> position_stddev_m;
  /// Where the wheels alone place the robot, from where it started.
  geometry::Pose2 T_odom_robot;
  std::shared_ptr<const std::vector<StampedPose>> trajectory;
  /// Indices of poses of the trajectory to which the robot was carried from the one before.
  std::vector<std::size_t> carried_to;
  std::shared_ptr<const mapping::PointCloudMap> points;
  std::shared_ptr<const mapping::OccupancyGrid> grid;
  /// Walls and compact obstacles that stops with a sonar have measured.
  std::shared_ptr<const mapping::SonarFeatures> features =
      std::make_shared<const mapping::SonarFeatures>();
  /// What was heard at all stops whose scans are in the grid, where it has them now.
  std::shared_ptr<const std::vector<mapping::Scan>> scans;
  /// Every landmark that was seen, in their order.
  std::shared_ptr<const std::vector<SeenLandmark>> landmarks;
  /// The last scan that was ended; empty before.
  std::shared_ptr<const mapping::Scan> last_scan;
  /// A scan with a fault that makes it worthless is not in the grid.
  mapping::ScanFault last_scan_fault = mapping::ScanFault::kNone;
  /// Scans ended so far, one per stop.
  std::size_t stops = 0;
  /// Floor that the last scan showed free and nobody had known before, square metres.
  double newly_free_m2 = 0.0;
  /// The last of each; default where the robot has told none.
  sensors::HazardObservation hazards;
  sensors::InfraredObservation infrared;
  std::optional<sensors::YawObservation> yaw;
  std::optional<sensors::BatteryObservation> battery;
  /// How often the robot was picked up: its pose is void since the last time.
  std::size_t times_lifted = 0;
};

}  // namespace echomap::pipeline
