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

/// What a robot sensed from one stop, and on its way there from the stop before: the least part of
/// a map, immutable. It is by odometry alone; where it lies on the map is a matter of the pose
/// graph, which may change without it.
struct Submap {
  std::uint32_t index = 0;  ///< Of its robot, from 0 on, without a gap.
  double begin_s = 0.0;     ///< On the robot's clock: of the way there, and the stop's end.
  double end_s = 0.0;
  std::vector<slam::StopReading> readings;  ///< At least one.
  std::vector<geometry::Pose2> T_odom_way;  ///< Robot poses, about 10 cm apart.
  std::vector<SubmapContact> contacts;
};

/// All that one robot has told of its surroundings.
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
