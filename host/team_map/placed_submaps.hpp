// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// A contact on a map.
struct PlacedContact {
  geometry::Pose2 T_map_robot;
  bool left = false;
  bool right = false;
};

/// What a robot has told, on a map.
struct PlacedSubmaps {
  std::vector<mapping::Scan> scans;        ///< One of each submap.
  std::vector<geometry::Pose2> T_map_way;  ///< Where the robot was on its way, stops included.
  std::vector<PlacedContact> contacts;
};

/// Places submaps by the robot's poses at the first reading of each; the way between two of them
/// goes from the one to the other, and what odometry is off on it is spread over it.
PlacedSubmaps placed(const std::vector<Submap>& submaps,
                     const std::vector<geometry::Pose2>& T_map_submaps);

/// Where the robot was when a stop ended.
struct StopEnd {
  double stamp_s = 0.0;  ///< On the robot's clock.
  geometry::Pose2 T_map_robot;
};

/// One of each submap, placed by the robot's pose at the first reading of each.
std::vector<StopEnd> stop_ends(const std::vector<Submap>& submaps,
                               const std::vector<geometry::Pose2>& T_map_submaps);

/// Where the robot's centre was.
std::vector<Eigen::Vector2d> positions_m(const std::vector<geometry::Pose2>& poses);

}  // namespace echomap::team_map
