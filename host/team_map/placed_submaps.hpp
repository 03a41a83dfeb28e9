// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// A bumper contact on a map.
struct PlacedContact {
  geometry::Pose2 T_map_robot;
  bool left = false;
  bool right = false;
};

/// What a robot has published, placed on a map.
struct PlacedSubmaps {
  std::vector<mapping::Scan> scans;        ///< One for each submap.
  std::vector<geometry::Pose2> T_map_way;  ///< Robot poses along its path, stops included.
  std::vector<PlacedContact> contacts;
};

/// Places submaps by the robot's pose at the first reading of each. The path between two of them
/// leads from the one to the other: the odometry's error is spread over it.
PlacedSubmaps placed(const std::vector<Submap>& submaps,
                     const std::vector<geometry::Pose2>& T_map_submaps);

/// Pose of the robot at the end of a stop.
struct StopEnd {
  double stamp_s = 0.0;  ///< On the robot's clock.
  geometry::Pose2 T_map_robot;
};

/// Ends of the stops of all submaps, placed by the robot's pose at the first reading of each.
std::vector<StopEnd> stop_ends(const std::vector<Submap>& submaps,
                               const std::vector<geometry::Pose2>& T_map_submaps);

/// Positions of the robot's centre.
std::vector<Eigen::Vector2d> positions_m(const std::vector<geometry::Pose2>& poses);

}  // namespace echomap::team_map
