// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/stop_stand.hpp"

namespace echomap::team_map {

/// A bumper contact: the robot's pose by odometry, and which switches closed.
struct SubmapContact {
  geometry::Pose2 T_odom_robot;
  bool left = false;
  bool right = false;
};

/// Readings of one stop, and of the path there from the stop before: the smallest part of a map,
/// immutable. Its poses are by odometry alone; its place on the map is in the pose graph, which may
/// change without it.
struct Submap {
  std::uint32_t index = 0;  ///< Number among its robot's submaps, from 0 on, without a gap.
  double begin_s = 0.0;     ///< On the robot's clock: start of the path there, and end of the stop.
  double end_s = 0.0;
  std::vector<slam::StopReading> readings;  ///< At least one.
  std::vector<geometry::Pose2> T_odom_way;  ///< Robot poses, about 10 cm apart.
  std::vector<SubmapContact> contacts;
};

/// All that one robot has published of its surroundings.
struct RobotRecord {
  std::string robot;
  std::vector<Submap> submaps;  ///< By index.
  /// The robot's pose graph: its pose in its own map at the first reading of each submap, as its
  /// SLAM has it now.
  std::vector<geometry::Pose2> T_map_submaps;
  double beam_half_angle_rad = 0.2269;  ///< Of its sonar.
  double body_radius_m = 0.0;
};

}  // namespace echomap::team_map
